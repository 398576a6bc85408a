"""Numbers and strings as a step writes them."""

from vrts.base.diagnostic import Rule
from vrts.base.made import made
from vrts.base.numbers import single
from vrts.lang.dialect import Dialect
from vrts.lang.problems import Problems, short
from vrts.lang.reading.characters import OPENING_QUOTES
from vrts.lang.reading.odd_signs import look_alike, visible
from vrts.lang.syntax.token import Token

MISSING_QUOTE = Rule("V109", "missing-quote")
INVALID_CONSTANT = Rule("V110", "invalid-constant")
CHARACTER_IN_STRING = Rule("V112", "character-in-string")
STRING_TOO_LONG = Rule("V114", "string-too-long")

MAX_STRING = 128  # [manual language/strings#length]
_BASES = {"H": (16, "hexadecimal"), "B": (2, "binary")}


def number(text: str, start: int, problems: Problems) -> Token | None:
    """Return the token of a decimal number, or None where it is too large."""
    try:
        value = single(float(text))
    except OverflowError:
        problems.error(
            INVALID_CONSTANT,
            f"the number `{short(text)}` is too large",
            start,
            start + len(text),
            notes=("numbers reach up to about 3.4E38", "VAL-II says *Invalid constant*"),
        )
        return None
    return made(Token, ("NUMBER", text, start, start + len(text), value))


_DIGITS_OF = {
    "octal": "octal digits are 0 to 7; write `^H` before a hexadecimal number",
    "hexadecimal": "hexadecimal digits are 0 to 9 and A to F, as in `^HFF`",
    "binary": "binary digits are 0 and 1, at most 8 of them, as in `^B1001`",
}


def based(text: str, start: int, problems: Problems, dialect: Dialect) -> Token | None:
    """Return the token of `^17`, `^HFF` or `^B1001`, or None where it is none."""
    letter = text[1:2].upper()
    if letter == "D" and dialect.tolerant and text[2:].isdecimal():
        long = number(text[2:], start, problems)  # an integer of double length of V+
        return long and long._replace(text=text, end=start + len(text))
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
        f"`{short(text)}` is not {'an' if name == 'octal' else 'a'} {name} number",
        start,
        start + len(text),
        notes=(
            "`^17` is octal, `^HFF` hexadecimal, `^B1001` binary with at most 8 digits",
            "VAL-II says *Invalid constant*",
        ),
        help=(_DIGITS_OF[name],),
    )
    return None


def string(value: str, start: int, end: int, problems: Problems) -> Token | None:
    """Return the token of a string, or None where it is too long."""
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
            f"the controller cannot show `{visible(value[odd])}`",
            start + 1 + odd,
            start + 2 + odd,
            notes=("strings hold the characters from blank to `~`",),
        )
    return Token("STRING", value, start, end, value)


def odd_string(written: str, start: int, problems: Problems) -> Token | None:
    """Return the token of a string with a curly quote at either end, or without its end."""
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
    look_alike(written[curly], start + curly, problems)
    end = start + (closing + 1 if closing else len(written))
    return Token("STRING", written[1:closing], start, end, written[1:closing])
