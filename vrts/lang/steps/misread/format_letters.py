"""`TYPE /8.2F, x`: the letter of a format behind its width."""

import re

from vrts.lang.steps.misread.meant import Meant
from vrts.lang.steps.other_forms import INVALID_FORMAT
from vrts.lang.steps.repair import Repair

_BEHIND = re.compile(
    r'"[^"]*"|(?P<before>[,(]|^TYPE\b)[ \t]*'
    r"(?P<format>/(?P<width>\d+(?:\.\d+)?)(?P<letter>[A-Za-z]))(?=[ \t]*(?:,|\)|$))",
    re.IGNORECASE,
)


def letter_behind(text: str, repair: Repair) -> Meant | None:
    """Return what is meant by a step that is right with the letters before the widths."""
    places = [found for found in _BEHIND.finditer(text) if found["format"]]
    if not places:
        return None
    meant = text
    for found in reversed(places):
        right = f"/{found['letter'].upper()}{found['width']}"
        meant = f"{meant[: found.start('format')]}{right}{meant[found.end('format') :]}"
    tried = repair.at_once(meant)
    if tried is None:
        return None
    start, end = places[0].start("format"), places[-1].end("format")
    return Meant(
        INVALID_FORMAT,
        "the letter of a format comes first",
        start,
        end,
        (f"write `{meant[start:end]}`",),
        meant[start:end],
        sure=True,
        notes=("VAL-II says *Invalid format specifier*",),
    )
