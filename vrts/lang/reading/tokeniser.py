"""Text of one step to tokens. What a regular expression cannot decide is decided here.

The longest name wins; which words are keywords is decided in `classify.py`. `/X` is a format, and
`^` and `'c` begin a number, only where an operand may stand.
"""

import re

from vrts.base.made import made
from vrts.lang.dialect import Dialect
from vrts.lang.problems import Problems
from vrts.lang.reading.characters import LOOK_ALIKES, OPENING_QUOTES
from vrts.lang.reading.literals import based, number, odd_string, string
from vrts.lang.reading.nesting import MAX_NESTING, balanced
from vrts.lang.reading.odd_signs import (
    INFIX,
    SIGNS,
    foreign_name,
    inner_quotes,
    mistaken,
    name_after_digit,
    stranger,
)
from vrts.lang.syntax.token import Token
from vrts.lang.vocabulary.words import OPERATORS, QUALIFIERS

MOST_BAD = 20  # problems of one step; it is not read further

_QUOTES = re.escape(OPENING_QUOTES)
_TOKEN = re.compile(
    rf"""[ \t]*(?:(?P<WORD>[^\W\d_][\w.]*)
    |(?P<NUMBER>(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][+-]?\d+)?)
    |(?P<STRING>"[^"]*")
    |(?P<OPEN>"[^"]*$)
    |(?P<CURLY>[{_QUOTES}][^{_QUOTES}"]*(?:[{_QUOTES}"]|$))
    |(?P<SIGIL>[$\#][^\W\d_][\w.]*)
    |(?P<TWO>==|<>|><|<=|=<|>=|=>|\*\*|!=|:=|\+=|-=|\+\+|--|&&|\|\|)
    |(?P<ONE>[-+*/=<>()\[\],:])
    |(?P<OTHER>[^ \t]))""",
    re.VERBOSE,
)
_FORMAT = re.compile(r"/[A-Za-z][A-Za-z0-9]*(?:\.\d+)?")
_LOCAL = re.compile(
    r"""(?:\.&?(?P<sigil>[$#@])?|(?P<timer>@))(?P<name>[A-Za-z][\w.]*)
    |(?P<mark>&)(?=[ \t]*[A-Za-z.#$])
    |(?P<joints>\#)(?=\[)""",
    re.ASCII | re.VERBOSE,
)
_WORD = re.compile(r"[\w.]+")
_BELT = re.compile(r"%[A-Za-z][\w.]*", re.ASCII)
_UNIT = re.compile(r"(?:MM|CM|DEG)[ \t]*/[ \t]*(?:S|MIN)\b", re.IGNORECASE)  # SPEED 100MM/S of AS
_CARET = re.compile(r"\^[A-Za-z0-9]*")

_BRACKETS = frozenset("()[]（）")
_USUAL = {"=<": "<=", "=>": ">=", "><": "<>"}
_AFTER_OPERAND = frozenset(
    {"NAME", "STRINGNAME", "JOINTNAME", "NUMBER", "STRING", "FORMAT", "RPAREN", "RBRACKET"}
)


def tokenise(text: str, at: int, problems: Problems) -> list[Token] | None:
    """Return the tokens of a piece of a line, words not yet classified, or None if one is bad.

    Args:
        text: The text of a statement, without label and comment.
        at: Offset of the text in the source.
        problems: Where each bad character is reported, once per cause; it knows the dialect.
    """
    dialect = problems.dialect
    if problems.full:
        return None  # what is wrong with it would not be shown
    reported = len(problems.found)
    tokens: list[Token] = []
    joint_literals: list[int] = []  # places in `tokens` of `#` before `[`
    good = True
    position = 0
    size = len(text)
    while position < size:
        match = _TOKEN.match(text, position)
        if match is None:
            break  # blanks at the end; OTHER takes any other character
        kind = match.lastgroup
        assert kind is not None
        start, end = match.span(kind)
        written = text[start:end]
        position = end
        if kind == "WORD" and written.isascii():
            tokens.append(made(Token, ("WORD", written, at + start, at + end, None)))
            continue
        token: Token | None = None
        if kind == "ONE":
            token = made(Token, (SIGNS.get(written, "INFIX"), written, at + start, at + end, None))
            if written == "/" and _operand_expected(tokens):
                form = _FORMAT.match(text, start)
                if form is not None:
                    end = position = form.end()
                    token = Token("FORMAT", form.group(), at + start, at + end)
        elif kind == "WORD":
            foreign_name(written, at + start, problems)
        elif kind == "NUMBER":
            glued = end < size and (text[end].isalpha() or text[end] == "_")
            if glued and not (dialect.has("a") and _UNIT.match(text, end)):
                word = _WORD.match(text, start)
                end = position = word.end() if word else start + 1
                name_after_digit(text[start:end], at + start, problems)
            else:
                token = number(written, at + start, problems)
        elif kind == "STRING":
            beyond = text[end : end + 1]
            if beyond and (beyond.isalnum() or beyond == '"' or text[end - 2] == "\\"):
                closed = inner_quotes(text, start, at, problems)
                if closed:
                    return None
            token = string(written[1:-1], at + start, at + end, problems)
        elif kind == "SIGIL":
            if written.isascii():
                name = "STRINGNAME" if written[0] == "$" else "JOINTNAME"
                token = Token(name, written, at + start, at + end)
            else:
                foreign_name(written, at + start, problems)
        elif kind == "TWO":
            meant = written if written in INFIX else _tolerated(written, dialect)
            if meant is not None:
                token = Token("INFIX", _USUAL.get(meant, meant), at + start, at + end)
            elif written in {"++", "--"} and end < size and text[end:].strip():
                position = start + 1  # a - -b, a + +b
                token = Token(SIGNS[written[0]], written[0], at + start, at + start + 1)
            else:
                token = mistaken(written, at + start, problems)
        elif kind in ("OPEN", "CURLY"):
            token = odd_string(written, at + start, problems)
        elif written == "^" and _operand_expected(tokens):
            caret = _CARET.match(text, start)
            assert caret is not None
            position = caret.end()
            token = based(caret.group(), at + start, problems, dialect)
        elif written == "^" and dialect.is_as:
            token = Token("INFIX", "**", at + start, at + end)
        elif written == "%" and dialect.is_as and not _operand_expected(tokens):
            token = Token("INFIX", "MOD", at + start, at + end)
        elif written == "'" and _operand_expected(tokens) and end < size:
            position = end + 1
            token = Token(
                "NUMBER", text[start:position], at + start, at + position, float(ord(text[end]))
            )
        elif written == "%" and dialect.has("+") and (belt := _belt(text, start, tokens)):
            position = start + len(belt)
            token = Token("NAME", belt, at + start, at + position)
        elif written in ".&#@" and dialect.has("a") and (special := _LOCAL.match(text, start)):
            position = special.end()
            if special["mark"]:
                continue  # `&a` says that a location is passed
            if special["joints"]:
                joint_literals.append(len(tokens))
            token = _local(special, at, problems)
        else:
            token = stranger(written, at + start, problems)
            good = good and written in LOOK_ALIKES
            if token is None and written in LOOK_ALIKES:
                continue
        if token is None:
            good = False
            if len(problems.found) - reported >= MOST_BAD:
                break
        else:
            tokens.append(token)
    if not good:
        return None
    nested = len(tokens) > MAX_NESTING or not _BRACKETS.isdisjoint(text)
    if nested and not balanced(tokens, problems):
        return None
    if joint_literals:
        _parenthesise(tokens, {place + 1 for place in joint_literals})
    return tokens


def _tolerated(written: str, dialect: Dialect) -> str | None:
    """Return the operator that a sign is taken for outside strict VAL-II."""
    if written == "**" and dialect.tolerant:
        return "**"
    unlike = ("><",) if dialect.is_vplus else ("><", "!=")  # real files of AS have `!=`
    return "<>" if written in unlike and dialect.tolerant else None


def _belt(text: str, start: int, tokens: list[Token]) -> str | None:
    """Return the name of a belt of V+, `%belt`, where an operand may stand."""
    match = _BELT.match(text, start) if _operand_expected(tokens) else None
    return match.group() if match is not None else None


def _local(special: re.Match[str], at: int, problems: Problems) -> Token:
    """Return a local name of AS, `.x`, with its sigil first, a timer, or the `#` of `#[...]`."""
    start, end = at + special.start(), at + special.end()
    if special["joints"]:
        return Token("JOINTNAME", "#PPOINT", start, end)
    sigil, name = special["sigil"] or "", special["name"]
    if special["timer"]:
        return Token("NAME", f"@{name}", start, end)  # a timer of the user
    kind = {"$": "STRINGNAME", "#": "JOINTNAME"}.get(sigil, "NAME")
    return Token(kind, f"{sigil}.{name}", start, end)


def _parenthesise(tokens: list[Token], places: set[int]) -> None:
    """Make the brackets that open at some places, and their partners, parentheses."""
    open_: list[int] = []
    for i, token in enumerate(tokens):
        if token.kind == "LBRACKET":
            open_.append(i)
            if i in places:
                tokens[i] = token._replace(kind="LPAREN")
        elif token.kind == "RBRACKET" and open_.pop() in places:
            tokens[i] = token._replace(kind="RPAREN")


def _operand_expected(tokens: list[Token]) -> bool:
    if not tokens:
        return True
    last = tokens[-1]
    if last.kind == "WORD":
        upper = last.text.upper()
        return len(tokens) == 1 or upper in OPERATORS or upper in QUALIFIERS
    return last.kind not in _AFTER_OPERAND
