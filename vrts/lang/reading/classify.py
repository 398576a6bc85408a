"""Which words of a step are keywords.

See [manual language/names#reserved, language/names#abbreviations].

The first word of a step is an instruction unless `=` or `[...]=` follows; elsewhere a word is a
keyword only if the instruction of the step wants it. So `stop` may be a variable wherever no
instruction can stand.
"""

from typing import NamedTuple

from vrts.base.made import made
from vrts.lang.dialect import VAL2, Dialect
from vrts.lang.syntax.token import Token
from vrts.lang.vocabulary.lookup import look_up
from vrts.lang.vocabulary.word import Word
from vrts.lang.vocabulary.words import OPERATORS, QUALIFIERS

_DEEPER = {"LPAREN": 1, "LBRACKET": 1, "RPAREN": -1, "RBRACKET": -1}
_KINDS = {"REAL": "KIND", "DOUBLE": "KIND", "LOC": "KIND"}
_RELATIONS = {"EQ": "==", "NE": "<>", "LT": "<", "GT": ">", "LE": "<=", "GE": ">="}
_UNITS = {  # of AS, by the word before and after the slash
    ("MM", "S"): "MMPS",
    ("MM", "MIN"): "MM/MIN",
    ("CM", "MIN"): "CM/MIN",
    ("DEG", "S"): "DEG/S",
}
_OPERAND_ENDS = frozenset({"NUMBER", "NAME", "RPAREN", "RBRACKET"})
_OPERAND_STARTS = frozenset({"NUMBER", "NAME", "LPAREN"})
# AS puts a number and a colon before operands: of a terminal, a task, a robot
_DEVICE_WORDS = frozenset({"TYPE", "PROMPT", "PCEXECUTE", "PCABORT", "PCEND", "DECOMPOSE", "SET"})
_NUMBERS = frozenset({"NUMBER", "WORD", "NAME"})  # what such a number is written as
_MODES = frozenset({"/ERR", "/LVL"})  # of ON and ONI: what becomes of a signal that is on
_NO_VARIABLES = frozenset({"IF", "FOR", "WHILE", "UNTIL", "CASE", "VALUE", "SET", "GIVE", "CALL"})


class Head(NamedTuple):
    """The instruction of a step as far as its first word tells."""

    word: Word | None  # None: an assignment, or no instruction
    abbreviates: tuple[Word, ...] = ()


NO_HEAD = Head(None)


def classify(tokens: list[Token], dialect: Dialect = VAL2) -> tuple[list[Token], Head]:
    """Return the tokens with the kinds that the grammar wants, and the instruction of the step."""
    first = tokens[0]
    head = NO_HEAD
    if first.kind == "WORD":
        assigned = is_assigned(tokens)
        match = look_up(first.text, dialect)
        if not assigned or (dialect.is_vplus and _takes_no_value(match.word, first)):
            head = Head(match.word, match.candidates)
    word = head.word
    if word is not None and dialect.has("a"):
        tokens = _without_device(_with_units(tokens, word), word)
    wanted = word.qualifiers if word else frozenset[str]()
    result: list[Token] = []
    depth = 0
    for i, token in enumerate(tokens):
        kind = token.kind
        if kind == "WORD":
            upper = token.text.upper()
            if i == 0 and word is not None:
                token = made(Token, (word.terminal, word.canonical, token.start, token.end, None))
            elif upper in OPERATORS:
                token = Token(OPERATORS[upper].terminal, upper, token.start, token.end)
            elif upper == "FINE" and upper in wanted:
                continue  # ACCURACY of AS may say it; nothing here depends on it
            elif (upper in wanted and not depth) or (upper == "BY" and depth):
                token = Token(_kind_of(upper), upper, token.start, token.end)
            elif word is not None and dialect.tolerant and not depth:
                token = _tolerant(token, upper, word, dialect, result[-1].kind)
            else:
                token = made(Token, ("NAME", token.text, token.start, token.end, None))
        else:
            depth += _DEEPER.get(kind, 0)
        result.append(token)
    if word is not None:
        if word.terminal == "TASKCALL":
            _mark_program(result)
        if word.terminal in ("VALUE", "ANY") and result[-1].text == ":":
            result[-1] = result[-1]._replace(kind="ENDCOLON")
        if len(result) > 1 and result[1].kind == "LPAREN" and _has_unit(word, result, dialect):
            _open_unit(result)
    return result, head


def _takes_no_value(word: Word | None, first: Token) -> bool:
    """Whether a word is none that a variable of V+ is ever called: FOR, SET, PARAMETER."""
    if word is None or word.text != first.text.upper():
        return False
    return word.terminal in _NO_VARIABLES


def is_assigned(tokens: list[Token]) -> bool:
    """Return whether a step begins with `name =` or `name[...] =`."""
    if len(tokens) < 2:
        return False
    if tokens[1].kind != "LBRACKET":
        return tokens[1].kind == "EQUAL"
    depth = 0
    for i in range(1, len(tokens)):
        if tokens[i].kind == "LBRACKET":
            depth += 1
        elif tokens[i].kind == "RBRACKET":
            depth -= 1
            if depth == 0:
                return i + 1 < len(tokens) and tokens[i + 1].kind == "EQUAL"
    return False


def _kind_of(upper: str) -> str:
    found = QUALIFIERS.get(upper)
    return found.terminal if found is not None else _KINDS.get(upper, upper)


def _tolerant(token: Token, upper: str, word: Word, dialect: Dialect, before: str) -> Token:
    """Return a word that is a keyword for some relatives only."""
    kind, text = "NAME", token.text
    if word.terminal == "IF" and upper in _RELATIONS and dialect.has("1"):
        kind, text = "RELATION", _RELATIONS[upper]
    elif word.terminal == "GOTO" and upper == "IF":
        kind = "IF"
    elif word.terminal == "SPEED" and _is_unit(upper, dialect, before):
        kind, text = "UNIT", upper
    return Token(kind, text, token.start, token.end)


def _with_units(tokens: list[Token], word: Word) -> list[Token]:
    """Join `MM / S` to one word where AS has it as a unit."""
    if word.terminal != "SPEED" or not any(t.text == "/" for t in tokens):
        return tokens
    joined: list[Token] = []
    skip = 0
    for i, token in enumerate(tokens):
        if skip:
            skip -= 1
            continue
        if token.kind == "WORD" and i + 2 < len(tokens) and tokens[i + 1].text == "/":
            unit = _UNITS.get((token.text.upper(), tokens[i + 2].text.upper()))
            if unit is not None:
                joined.append(Token("WORD", unit, token.start, tokens[i + 2].end))
                skip = 2
                continue
        joined.append(token)
    return joined


def _without_device(tokens: list[Token], word: Word) -> list[Token]:
    """Drop `2:` before the operands of PRINT and PCEXECUTE of AS, and the mode of ON."""
    numbered = word.canonical in _DEVICE_WORDS or word.terminal == "DEVICE"
    if numbered and len(tokens) > 2 and tokens[2].text == ":" and tokens[1].kind in _NUMBERS:
        return [tokens[0], *tokens[3:]]
    if word.terminal == "DEVICE" and len(tokens) > 2 and tokens[-1].text.upper() == "ALWAYS":
        return tokens[:-1]  # nobody knows which of these settings hold for one motion
    if (
        word.terminal in ("ONCALL", "UNTILSIG")
        and len(tokens) > 1
        and tokens[1].text.upper() in _MODES
    ):
        return [tokens[0], *tokens[2:]]
    return tokens


def _mark_program(tokens: list[Token]) -> None:
    """Mark the program that EXECUTE names: the first name, or one behind the number of a task."""
    while len(tokens) > 1 and tokens[1].kind == "FORMAT":
        del tokens[1]  # `EXECUTE /C 1 program()`
    depth, found = 0, 0
    for i in range(1, len(tokens)):
        kind = tokens[i].kind
        depth += (kind in ("LPAREN", "LBRACKET")) - (kind in ("RPAREN", "RBRACKET"))
        if kind == "COMMA" and not depth:
            break
        if kind == "NAME" and not depth and (i == 1 or tokens[i - 1].kind in _OPERAND_ENDS):
            found = i
    if found:
        tokens[found] = tokens[found]._replace(kind="PROGRAM")


def _open_unit(tokens: list[Token]) -> None:
    """Mark the parentheses round the number of a device."""
    closing = _closing(tokens)
    tokens[1] = tokens[1]._replace(kind="UNITOPEN")
    tokens[closing] = tokens[closing]._replace(kind="UNITCLOSE")


def _closing(tokens: list[Token]) -> int:
    """Return which token closes the parenthesis that the second one opens."""
    depth = 0
    for i in range(1, len(tokens)):
        depth += (tokens[i].kind == "LPAREN") - (tokens[i].kind == "RPAREN")
        if depth == 0:
            return i
    raise AssertionError("brackets are balanced")


def _has_unit(word: Word, tokens: list[Token], dialect: Dialect) -> bool:
    return word.unit or (word.text == "ACCEL" and _is_profile(tokens, dialect))


def _is_profile(tokens: list[Token], dialect: Dialect) -> bool:
    """Whether parentheses behind ACCEL hold a profile of V+, as in `ACCEL (1) 100, 100`."""
    if not dialect.has("+"):
        return False
    after = tokens[_closing(tokens) + 1 :]
    if not after or after[0].kind == "ALWAYS":
        return not dialect.takes_all  # others write `ACCEL (n)` for a number
    return after[0].kind in _OPERAND_STARTS


def _is_unit(upper: str, dialect: Dialect, before: str) -> bool:
    if upper == "MONITOR":
        return dialect.has("+")
    if upper == "S":  # a time, in AS; `SPEED s` is a variable
        return dialect.has("a") and before in _OPERAND_ENDS
    return upper in _UNITS.values()
