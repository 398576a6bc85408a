"""`n > 250 THEN`, `i = 1 TO 5`, `,n = n+1`, `SIGNAL 9, 10,`: a word or a sign lost or too much."""

import re

from vrts.lang.dialect import Dialect
from vrts.lang.grammar.shapes import UNEXPECTED_TEXT
from vrts.lang.steps.misread.meant import VARIABLE, Meant
from vrts.lang.steps.repair import Repair
from vrts.lang.steps.unknown_words import UNKNOWN_INSTRUCTION
from vrts.lang.vocabulary.lookup import look_up

_LOST = (  # what begins a step that ends so
    (re.compile(r".+[ \t)]THEN", re.IGNORECASE), "IF"),
    (re.compile(r".+[ \t]GOTO[ \t]+\w+", re.IGNORECASE), "IF"),
    (re.compile(r".+[ \t)]DO", re.IGNORECASE), "WHILE"),
    (re.compile(rf"{VARIABLE}[ \t]*=[^=].*[ \t]TO[ \t].+", re.IGNORECASE), "FOR"),
    (re.compile(r".+[ \t)]OF", re.IGNORECASE), "CASE"),
)
_FIRST = re.compile(r"\.?[$#]?[A-Za-z][\w.]*", re.ASCII)
_STRAY = re.compile(r"(?P<sign>[,'`~|\\.-])[ \t]*(?=[A-Za-z$#.])")


def lost_word(text: str, repair: Repair, dialect: Dialect) -> Meant | None:
    """Return what is meant by a line that is a step with a word before it."""
    first = _FIRST.match(text)
    if first is not None and look_up(first.group(), dialect).word is not None:
        return None
    for ends, word in _LOST:
        if ends.fullmatch(text) is None:
            continue
        glued = text[: len(word)].upper() == word
        meant = f"{word} {text[len(word) :] if glued else text}"
        if repair.at_once(meant) is None:
            continue
        says = f"a blank is missing behind {word}"
        return Meant(
            UNKNOWN_INSTRUCTION,
            says if glued else f"{word} is missing at the start of this step",
            0,
            len(text),
            (f"write `{meant}`",),
            meant,
            sure=True,
            notes=("VAL-II says *Unknown instruction*",),
        )
    return None


def stray_sign(text: str, repair: Repair, dialect: Dialect) -> Meant | None:
    """Return what is meant by a step that is right without a sign before it, or a comma behind."""
    found = _STRAY.match(text)
    if found is not None:
        rest = text[found.end() :]
        ways = [f".{rest}"] if dialect.is_as and found["sign"] == "," else []
        for meant in (*ways, rest):
            if repair.at_once(meant) is None:
                continue
            dotted = meant[0] == "." and rest[0] != "."
            says = "a local variable begins with `.`" if dotted else "no step begins with it"
            return Meant(
                UNEXPECTED_TEXT,
                f"`{found['sign']}` stands before this step: {says}",
                0,
                found.end(),
                (f"write `.` instead of `,`: `{meant}`" if dotted else f"write `{meant}`",),
                meant[: len(meant) - len(rest)],
                sure=True,
                notes=("VAL-II says *Unknown instruction*",),
            )
    bare = text.rstrip(" \t,")
    if dialect.has("2") or not text.endswith(",") or repair.at_once(bare) is None:
        return None
    return Meant(
        UNEXPECTED_TEXT,
        "a `,` stands at the end, and no operand behind it",
        len(bare),
        len(text),
        (f"remove the comma `,`: write `{bare}`",),
        "",
        sure=True,
        notes=("VAL-II says *Unexpected text at end of line*",),
    )
