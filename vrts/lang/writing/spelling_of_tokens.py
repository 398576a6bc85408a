"""How a step is written: the case of words, and where blanks stand."""

from collections.abc import Sequence

from vrts.lang.dialect import Dialect
from vrts.lang.reading.classify import Head
from vrts.lang.syntax.token import Token
from vrts.lang.vocabulary.functions import CONSTANTS, applied_functions, bare_functions

_COMPARISONS = frozenset({"==", "<>", "<", "<=", ">", ">="})
_TIGHT = frozenset({"+", "-", "*", "/", ":", "**"})
_NAMES = frozenset({"NAME", "STRINGNAME", "JOINTNAME", "PROGRAM"})
_OPENING = frozenset({"LPAREN", "LBRACKET", "UNITOPEN"})
_CALLABLE = _NAMES | {"STRING", "RBRACKET"}
_CLOSING = frozenset({"RPAREN", "RBRACKET", "UNITCLOSE", "COMMA", "ENDCOLON"})
_AS_WRITTEN = frozenset({"NUMBER", "STRING"})
_SIGNS = frozenset({"MINUS", "PLUS"})
_OPERAND_ENDS = _NAMES | _AS_WRITTEN | {"RPAREN", "RBRACKET", "FORMAT"}


def written(tokens: Sequence[Token], head: Head, source: str, dialect: Dialect) -> str:
    """Return a step in canonical spelling; its tokens, read again, are the same."""
    parts: list[str] = []
    depth = 0
    for i, token in enumerate(tokens):
        before = tokens[i - 1] if i else None
        text = _text(tokens, i, head, source, dialect)
        if before is not None and (
            before.end < token.start
            if _belongs_to_the_word(tokens, i, dialect)
            else _blank(tokens, i, depth)
        ):
            parts.append(" ")
        parts.append(text)
        if token.kind in ("LPAREN", "LBRACKET"):
            depth += 1
        elif token.kind in ("RPAREN", "RBRACKET"):
            depth -= 1
    return "".join(parts)


def _text(tokens: Sequence[Token], i: int, head: Head, source: str, dialect: Dialect) -> str:
    token = tokens[i]
    original = source[token.start : token.end]
    if i == 0 and head.word is not None:
        return head.word.text
    if token.kind in _AS_WRITTEN:
        return original
    if token.kind in _NAMES:
        if _of_the_controller(tokens, i):
            return original.upper()
        if i and tokens[i - 1].kind in ("CALL", "GOTO"):
            return original.lower()
        following = tokens[i + 1].kind if i + 1 < len(tokens) else ""
        name = original.lower()
        functions = applied_functions(dialect) if following == "LPAREN" else {}
        if name in CONSTANTS or name in bare_functions(dialect) or name in functions:
            return name.upper()
        return name
    if token.kind == "INFIX" and token.text == "**":
        return original
    if token.kind in ("INFIX", "PREFIX", "LPAREN", "RPAREN"):
        return token.text if token.text.isalpha() or original[:1] not in "[]" else original
    return original.upper()


def _of_the_controller(tokens: Sequence[Token], i: int) -> bool:
    """Whether a name is that of a switch or a parameter."""
    first = tokens[0].text
    if first in ("ENABLE", "DISABLE") and tokens[0].kind == "WORDITEMS":
        return True
    if first == "PARAMETER" and i == 1:
        return True
    function = tokens[i - 2].text.upper() if i > 1 and tokens[i - 1].kind == "LPAREN" else ""
    return function in ("SWITCH", "PARAMETER")


def _belongs_to_the_word(tokens: Sequence[Token], i: int, dialect: Dialect) -> bool:
    """Whether a token is the end of a word of AS: `POINT/OAT`, which `POINT /OAT` is too."""
    return i == 1 and tokens[i].kind == "FORMAT" and dialect.is_as


def _blank(tokens: Sequence[Token], i: int, depth: int) -> bool:
    """Return whether a blank stands before a token that is not the first."""
    token, before = tokens[i], tokens[i - 1]
    if token.kind == "COMMA" and (i == 1 or before.kind == "BY"):
        return True  # an operand is left out: `BASE ,,300`
    if token.kind in _CLOSING or before.kind in ("LPAREN", "LBRACKET", "UNITOPEN"):
        return False
    if before.kind == "COMMA":
        return depth == 0 and (i < 2 or tokens[i - 2].kind != "COMMA")
    if token.kind in _OPENING and before.kind in _CALLABLE:
        return False
    if before.kind in _SIGNS and not _tight(tokens, i - 1):
        return token.kind in _SIGNS  # nothing behind a sign, but `- -b`
    if token.kind == "LBRACKET":
        return False
    if _loose(token) or _loose(before):
        return True
    if token.kind in _SIGNS and before.kind in _SIGNS:
        return True  # `a- -b`
    return not (_tight(tokens, i) or _tight(tokens, i - 1))


def _loose(token: Token) -> bool:
    """Whether blanks stand round an operator."""
    if token.kind in ("EQUAL", "RELATION"):
        return True
    return token.kind == "INFIX" and (token.text in _COMPARISONS or token.text.isalpha())


def _tight(tokens: Sequence[Token], i: int) -> bool:
    """Whether no blanks stand round an operator, or behind a sign."""
    token = tokens[i]
    if token.kind == "INFIX":
        return token.text in _TIGHT
    return token.kind in _SIGNS and (i == 0 or tokens[i - 1].kind in _OPERAND_ENDS)
