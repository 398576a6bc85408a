"""`HERE 1p`: a name that begins with a digit, where nothing can be multiplied."""

import re

from vrts.lang.reading.odd_signs import INVALID_NAME
from vrts.lang.steps.misread.meant import Meant

_GLUED = re.compile(r"(?<![\w.^$])(?P<digits>\d+)(?![eE][-+]?\d)(?P<rest>[A-Za-z][\w.]*)", re.ASCII)
_LOCATED = re.compile(  # what a location, or the name of something, stands behind
    r"""(?:^(?:MOVES?|MOVES?T|APPROS?|TOOL|HERE|SET|SHIFT|CALL|PCEXECUTE|FOR)[ \t]+
    |^SET[ \t]+[^=]+=[ \t]*
    |^REACTI?[ \t]+[^,]+,[ \t]*
    |:[ \t]*
    |\b(?:DX|DY|DZ|INVERSE|SHIFT|FRAME|DISTANCE|IDENTICAL|DEST|RX)[ \t]*\([ \t]*
    |\b(?:FRAME|DISTANCE|IDENTICAL)[ \t]*\([^()]*,[ \t]*
    |^)\#?$""",
    re.ASCII | re.IGNORECASE | re.VERBOSE,
)
_JOINED = re.compile(r"[ \t]*:(?![ \t]*$)")


def digit_first(text: str) -> Meant | None:
    """Return what is meant by a number with letters behind it, in the place of a name."""
    for found in _GLUED.finditer(text):
        before, behind = text[: found.start()], text[found.end() :]
        if '"' in before and before.count('"') % 2:
            continue
        assigned = re.match(r"[ \t]*(?:\[[^\]]*\][ \t]*)?=(?!=)", behind)
        if before and not _LOCATED.search(before) and not _JOINED.match(behind):
            continue
        if not before.strip() and not assigned:
            continue
        name = f"{found['rest']}{found['digits']}"
        return Meant(
            INVALID_NAME,
            f"`{found.group()}` is no name: a name begins with a letter",
            found.start(),
            found.end(),
            (f"begin the name with a letter: write `{name}`, here and wherever it stands",),
            name,
            notes=("VAL-II says *Invalid program or variable name*",),
        )
    return None
