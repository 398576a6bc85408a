"""`DRAW 0, 0, 50mm`: a number with its unit, which is no product."""

import re

from vrts.lang.reading.odd_signs import INVALID_NAME
from vrts.lang.steps.misread.meant import Meant
from vrts.lang.steps.repair import Repair

_UNIT = re.compile(
    r'"[^"]*"|(?<![\w.])(?P<number>\d+(?:\.\d*)?|\.\d+)'
    r"(?P<unit>[ \t]*(?:mm|deg|degrees|millimeters?))(?![\w.])",
    re.ASCII | re.IGNORECASE,
)
_SPEED = re.compile(r"SPEED\b", re.IGNORECASE)  # has units of its own


def unit_behind(text: str, repair: Repair) -> Meant | None:
    """Return what is meant by a step that is right without the units of its numbers."""
    units = [found for found in _UNIT.finditer(text) if found["unit"]]
    if not units or _SPEED.match(text):
        return None
    plain = _UNIT.sub(lambda found: found["number"] or found.group(), text)
    tried = repair.at_once(plain)
    if tried is None:
        return None
    first, last = units[0], units[-1]
    return Meant(
        INVALID_NAME,
        "a number has no unit: lengths are in mm, angles in degrees",
        first.start("number"),
        last.end(),
        (f"write `{tried.text}`",),
        plain[first.start("number") : len(plain) - (len(text) - last.end())],
        sure=True,
    )
