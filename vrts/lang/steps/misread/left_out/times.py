"""`10(i+1)`, `x = 2 y` and `(1+2)(3+4)`: a product without its `*`."""

import re

from vrts.lang.grammar.shapes import UNEXPECTED_TEXT
from vrts.lang.steps.misread.meant import VARIABLE, Meant
from vrts.lang.steps.repair import Repair

_STRING = re.compile(r'"[^"]*"')
_NO_SIGN = re.compile(
    r"(?<![\w.^$#\]])(?:\d+(?:\.\d*)?|\.\d+)[ \t]*(?=\()|\)(?=\w)|\)[ \t]*(?=\()",
    re.ASCII,
)
_GIVEN = re.compile(rf"{VARIABLE}[ \t]*=(?!=)", re.ASCII)
_APART = re.compile(r"(?<![\w.^$#\]])(?:\d+(?:\.\d*)?|\.\d+)[ \t]+(?=[A-Za-z])", re.ASCII)  # `2 n`
_OF_NUMBERS = re.compile(  # steps that compute with numbers, not with locations
    rf"{VARIABLE}[ \t]*=(?!=)|(?:IF|WHILE|UNTIL|FOR|CASE|TYPE|DRAW|DEPARTS?|DELAY|SPEED|DRIVE)\b",
    re.ASCII | re.IGNORECASE,
)


def missing_times(text: str, repair: Repair) -> Meant | None:
    """Return what is meant by a step that is right with `*` between two factors."""
    bare = _STRING.sub(lambda string: '"' * len(string.group()), text)
    places = [found.end() for found in _NO_SIGN.finditer(bare)]
    if _GIVEN.match(text):
        places = sorted({*places, *(found.end() for found in _APART.finditer(bare))})
    if not places or not _OF_NUMBERS.match(text):
        return None
    meant = text
    for place in reversed(places):
        meant = f"{meant[:place].rstrip()}*{meant[place:]}"
    tried = repair.at_once(meant)
    if tried is None:
        return None
    start, end = len(text[: places[0]].rstrip()), places[-1]
    return Meant(
        UNEXPECTED_TEXT,
        "`*` is missing between two factors",
        start - 1,
        end + 1,
        (f"write `{meant}`",),
        meant[start - 1 : len(meant) - (len(text) - end - 1)],
        notes=("VAL-II says *Unexpected text at end of line*",),
    )
