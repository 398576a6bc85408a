"""`ATAN2(y, x)*180/PI`: degrees that are turned into degrees once more."""

import re

from vrts.lang.findings.values.units.angles import RADIANS
from vrts.lang.problems import Problems
from vrts.lang.syntax.program import ProgramText

_ANGLE = r"ATAN2[ \t]*\((?:[^()\"]|\((?:[^()\"]|\([^()\"]*\))*\))*\)"
_FACTOR = r"(?:180(?:\.0*)?[ \t]*/[ \t]*(?:PI|3\.14\d*)|57\.[23]\d*)"
_CONVERTED = re.compile(
    rf"(?P<angle>{_ANGLE})[ \t]*\*[ \t]*(?:{_FACTOR}|\([ \t]*{_FACTOR}[ \t]*\))"
    rf"|(?:{_FACTOR}|\([ \t]*{_FACTOR}[ \t]*\))[ \t]*\*[ \t]*(?P<behind>{_ANGLE})",
    re.IGNORECASE,
)


def check_converted(problems: Problems, program: ProgramText) -> None:
    """Warn of each angle of ATAN2 that is converted."""
    text = problems.source.text
    for step in program.steps:
        node = step.statement
        if node is None:
            continue
        for found in _CONVERTED.finditer(text, node.start, node.end):
            angle = found["angle"] or found["behind"]
            problems.warning(
                RADIANS,
                "ATAN2 yields degrees, and this converts them once more",
                found.start(),
                found.end(),
                notes=("angles are in degrees everywhere, and never in radians",),
                help=(f"leave the factor out: write `{angle}`",),
                fix=problems.replace(found.start(), found.end(), angle),
            )
