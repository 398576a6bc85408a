"""Text of one step to tokens. What a regular expression cannot decide is decided here.

The longest name wins; which words are keywords is decided in `classify.py`. `/X` is a format, and
`^` and `'c` begin a number, only where an operand may stand.
"""

import re

from vrts.base.diagnostic import Rule
from vrts.base.numbers import single
from vrts.lang.dialect import Dialect
from vrts.lang.problems import Problems
from vrts.lang.reading.characters import BLANKS, INVISIBLE, LOOK_ALIKES, OPENING_QUOTES, STRANGERS
from vrts.lang.reading.nesting import MAX_NESTING, balanced
from vrts.lang.syntax.token import Token
from vrts.lang.vocabulary.words import OPERATORS, QUALIFIERS

STRAY_CHARACTER = Rule("V107", "stray-character")
MISSING_QUOTE = Rule("V109", "missing-quote")
INVALID_CONSTANT = Rule("V110", "invalid-constant")
INVALID_NAME = Rule("V111", "invalid-name")
CHARACTER_IN_STRING = Rule("V112", "character-in-string")
STRING_TOO_LONG = Rule("V114", "string-too-long")

MAX_STRING = 128  # [manual language/strings#length]
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
    r"""\.&?(?P<sigil>[$#])?(?P<name>[A-Za-z][\w.]*)
    |(?P<mark>&)(?=[ \t]*[A-Za-z.#$])
    |(?P<joints>\#)(?=\[)""",
    re.ASCII | re.VERBOSE,
)
_WORD = re.compile(r"[\w.]+")
_CARET = re.compile(r"\^[A-Za-z0-9]*")

_SIGNS = {
    "=": "EQUAL",
    ",": "COMMA",
    "(": "LPAREN",
    ")": "RPAREN",
    "[": "LBRACKET",
    "]": "RBRACKET",
    "-": "MINUS",
    "+": "PLUS",
}
_INFIX = frozenset({"*", "/", "<", ">", ":", "==", "<>", "<=", "=<", ">=", "=>"})
_BRACKETS = frozenset("()[]（）")
_USUAL = {"=<": "<=", "=>": ">=", "><": "<>"}
_MISTAKEN = {  # signs of other languages: what to write
    "!=": "<>",
    "><": "<>",
    ":=": "=",
    "**": "SQR(x)` or `x*x",
    "&&": "AND",
    "||": "OR",
    "+=": "x = x+1",
    "-=": "x = x-1",
    "++": "x = x+1",
    "--": "x = x-1",
}
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
        token: Token | None = None
        if kind == "WORD":
            if written.isascii():
                token = Token("WORD", written, at + start, at + end)
            else:
                _foreign_name(written, at + start, problems)
        elif kind == "NUMBER":
            if end < size and (text[end].isalpha() or text[end] == "_"):
                word = _WORD.match(text, start)
                end = position = word.end() if word else start + 1
                _name_after_digit(text[start:end], at + start, problems)
            else:
                token = _number(written, at + start, problems)
        elif kind == "ONE":
            token = Token(_SIGNS.get(written, "INFIX"), written, at + start, at + end)
            if written == "/" and _operand_expected(tokens):
                form = _FORMAT.match(text, start)
                if form is not None:
                    end = position = form.end()
                    token = Token("FORMAT", form.group(), at + start, at + end)
        elif kind == "STRING":
            token = _string(written[1:-1], at + start, at + end, problems)
        elif kind == "SIGIL":
            if written.isascii():
                name = "STRINGNAME" if written[0] == "$" else "JOINTNAME"
                token = Token(name, written, at + start, at + end)
            else:
                _foreign_name(written, at + start, problems)
        elif kind == "TWO":
            meant = written if written in _INFIX else _tolerated(written, dialect)
            if meant is not None:
                token = Token("INFIX", _USUAL.get(meant, meant), at + start, at + end)
            elif written in {"++", "--"} and end < size and text[end:].strip():
                position = start + 1  # a - -b, a + +b
                token = Token(_SIGNS[written[0]], written[0], at + start, at + start + 1)
            else:
                token = _mistaken(written, at + start, problems)
        elif kind in ("OPEN", "CURLY"):
            token = _odd_string(written, at + start, problems)
        elif written == "^" and _operand_expected(tokens):
            caret = _CARET.match(text, start)
            assert caret is not None
            position = caret.end()
            token = _based(caret.group(), at + start, problems, dialect)
        elif written == "^" and dialect.is_as:
            token = Token("INFIX", "**", at + start, at + end)
        elif written == "'" and _operand_expected(tokens) and end < size:
            position = end + 1
            token = Token(
                "NUMBER", text[start:position], at + start, at + position, float(ord(text[end]))
            )
        elif written in ".&#" and dialect.has("a") and (special := _LOCAL.match(text, start)):
            position = special.end()
            if special["mark"]:
                continue  # `&a` says that a location is passed
            if special["joints"]:
                joint_literals.append(len(tokens))
            token = _local(special, at, problems)
        else:
            token = _other(written, at + start, problems)
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
    return "<>" if written in ("><", "!=") and dialect.tolerant else None


def _local(special: re.Match[str], at: int, problems: Problems) -> Token:
    """Return a local name of AS, `.x`, with its sigil first, or the `#` of `#[...]`."""
    start, end = at + special.start(), at + special.end()
    if special["joints"]:
        return Token("JOINTNAME", "#PPOINT", start, end)
    sigil, name = special["sigil"] or "", special["name"]
    kind = {"$": "STRINGNAME", "#": "JOINTNAME", "": "NAME"}[sigil]
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


def _number(text: str, start: int, problems: Problems) -> Token | None:
    try:
        value = single(float(text))
    except OverflowError:
        problems.error(
            INVALID_CONSTANT,
            f"the number `{_short(text)}` is too large",
            start,
            start + len(text),
            notes=("numbers reach up to about 3.4E38", "VAL-II says *Invalid constant*"),
        )
        return None
    return Token("NUMBER", text, start, start + len(text), value)


_BASES = {"H": (16, "hexadecimal"), "B": (2, "binary")}


def _based(text: str, start: int, problems: Problems, dialect: Dialect) -> Token | None:
    letter = text[1:2].upper()
    if letter == "D" and dialect.tolerant and text[2:].isdecimal():
        number = _number(text[2:], start, problems)  # an integer of double length of V+
        return number and number._replace(text=text, end=start + len(text))
    base, name = _BASES.get(letter, (8, "octal"))
    digits = text[2:] if letter in _BASES else text[1:]
    try:
        value = float(int(digits, base)) if digits.isascii() else None
        valid = value is not None and not (base == 2 and len(digits) > 8)
        if valid and value is not None:
            return Token("NUMBER", text, start, start + len(text), single(value))
    except (ValueError, OverflowError):
        pass  # reported below
    problems.error(
        INVALID_CONSTANT,
        f"`{_short(text)}` is not {'an' if name == 'octal' else 'a'} {name} number",
        start,
        start + len(text),
        notes=(
            "`^17` is octal, `^HFF` hexadecimal, `^B1001` binary with at most 8 digits",
            "VAL-II says *Invalid constant*",
        ),
    )
    return None


def _string(value: str, start: int, end: int, problems: Problems) -> Token | None:
    if len(value) > MAX_STRING:
        problems.error(
            STRING_TOO_LONG,
            f"this string has {len(value)} characters; a string has at most {MAX_STRING}",
            start,
            end,
            help=('write it in two pieces: `TYPE "first", "second"`',),
        )
        return None
    if not value.isascii() or not value.isprintable():
        odd = next(i for i, c in enumerate(value) if not (c.isascii() and c.isprintable()))
        problems.warning(
            CHARACTER_IN_STRING,
            f"the controller cannot show `{_visible(value[odd])}`",
            start + 1 + odd,
            start + 2 + odd,
            notes=("strings hold the characters from blank to `~`",),
        )
    return Token("STRING", value, start, end, value)


def _odd_string(written: str, start: int, problems: Problems) -> Token | None:
    """A string with a curly quote at either end, or without its end."""
    closing = next((i for i, c in enumerate(written[1:], 1) if c in OPENING_QUOTES + '"'), None)
    if written[0] == '"' and closing is None:
        problems.error(
            MISSING_QUOTE,
            "this string is not closed",
            start,
            start + 1,
            "opened here",
            notes=("VAL-II says *Missing quote mark*",),
            help=("end the text with a double quote on the same line",),
            fix=problems.replace(start + len(written), start + len(written), '"'),
        )
        return None
    curly = 0 if written[0] != '"' else closing or 0
    _look_alike(written[curly], start + curly, problems)
    end = start + (closing + 1 if closing else len(written))
    return Token("STRING", written[1:closing], start, end, written[1:closing])


def _other(written: str, start: int, problems: Problems) -> Token | None:
    """A character with no meaning here. A look-alike is read as what it stands for."""
    if written in LOOK_ALIKES:
        _look_alike(written, start, problems)
        replacement = LOOK_ALIKES[written].replacement
        if written in BLANKS + INVISIBLE or not replacement:
            return None
        kind = _SIGNS.get(replacement, "INFIX" if replacement in _INFIX else "")
        return Token(kind, replacement, start, start + 1) if kind else None
    hint = STRANGERS.get(written, "")
    problems.error(
        STRAY_CHARACTER,
        f"`{_visible(written)}` has no meaning here",
        start,
        start + 1,
        notes=("VAL-II says *Illegal expression syntax*",),
        help=(hint,) if hint else (),
    )
    return None


def _look_alike(character: str, start: int, problems: Problems) -> None:
    """Note the place; all look-alikes of a file become one diagnostic (see steps.py)."""
    problems.look_alikes.append((character, start))


def _mistaken(written: str, start: int, problems: Problems) -> Token | None:
    instead = _MISTAKEN[written]
    plain = instead if instead in ("<>", "=", "AND", "OR") else None
    problems.error(
        STRAY_CHARACTER,
        f"`{written}` is not an operator of VAL-II",
        start,
        start + len(written),
        help=(f"write `{instead}`",),
        fix=problems.replace(start, start + len(written), plain) if plain else None,
        notes=("VAL-II says *Illegal operator*",),
    )
    return None


def _foreign_name(written: str, start: int, problems: Problems) -> None:
    at = next(i for i, c in enumerate(written) if not c.isascii())
    problems.error(
        INVALID_NAME,
        f"the name `{_short(written)}` contains `{_visible(written[at])}`",
        start,
        start + len(written),
        notes=("VAL-II says *Invalid program or variable name*",),
        help=("names consist of the letters A to Z, digits, `.` and `_`",),
    )


def _name_after_digit(written: str, start: int, problems: Problems) -> None:
    problems.error(
        INVALID_NAME,
        f"`{_short(written)}` is neither a number nor a name",
        start,
        start + len(written),
        notes=("VAL-II says *Invalid program or variable name*",),
        help=("begin names with a letter; put an operator or a blank after a number",),
    )


def _visible(character: str) -> str:
    return character if character.isprintable() else f"U+{ord(character):04X}"


def _short(text: str) -> str:
    return text if len(text) <= 40 else text[:37] + "..."
