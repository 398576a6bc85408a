"""`1O0` and `l5`: letters that look like digits in a number."""

import re

from vrts.lang.reading.odd_signs import INVALID_NAME
from vrts.lang.steps.misread.meant import Meant
from vrts.lang.steps.repair import Repair

_MIXED = re.compile(r"(?<![\w.^$#])\d[\dOolI.]*[OolI][\dOolI.]*(?![\w.])", re.ASCII)
_DIGITS = str.maketrans("OolI", "0011")
_NAMED = {"O": "the letter O", "o": "the letter o", "l": "the letter l", "I": "the letter I"}


def letters_in_number(text: str, repair: Repair) -> Meant | None:
    """Return what is meant by a step that is right with digits for the letters in a number."""
    for found in _MIXED.finditer(text):
        number = found.group().translate(_DIGITS)
        if number.count(".") > 1 or text[: found.start()].count('"') % 2:
            continue
        tried = repair.steps(text[: found.start()] + number + text[found.end() :])
        if tried is None or tried.fixes:
            continue
        letter = next(sign for sign in found.group() if sign in _NAMED)
        digit = letter.translate(_DIGITS)
        return Meant(
            INVALID_NAME,
            f"{_NAMED[letter]} stands in the number `{found.group()}`",
            found.start(),
            found.end(),
            (f"write the digit {digit}: `{number}`",),
            number,
            sure=True,
        )
    return None
