"""`IF x > 3 AND < 5 THEN`: what is compared stands only once."""

import re

from vrts.lang.steps.misread.meant import Meant
from vrts.lang.steps.other_forms import INVALID_EXPRESSION
from vrts.lang.steps.repair import Repair

_VALUE = r"[\w.$]+(?:\[[^\[\]]*\]|\([^()]*\))?"
_SIGN = r"<=|>=|<>|==|<|>"
_TWICE = re.compile(
    rf"\(?(?P<of>{_VALUE})[ \t]*(?P<sign>{_SIGN})[ \t]*(?P<than>-?{_VALUE})\)?[ \t]+"
    rf"(?P<joins>AND|OR)[ \t]*\(?(?P<second>{_SIGN})[ \t]*(?P<last>-?{_VALUE})\)?",
    re.ASCII | re.IGNORECASE,
)


def left_out_operand(text: str, repair: Repair) -> Meant | None:
    """Return what is meant by a second comparison that does not say of what."""
    found = _TWICE.search(text)
    if found is None:
        return None
    first = f"({found['of']} {found['sign']} {found['than']})"
    second = f"({found['of']} {found['second']} {found['last']})"
    instead = f"{first} {found['joins']} {second}"
    tried = repair.at_once(text[: found.start()] + instead + text[found.end() :])
    if tried is None:
        return None
    return Meant(
        INVALID_EXPRESSION,
        f"`{found['second']}` has nothing before it that is compared",
        found.start(),
        found.end(),
        (f"name what is compared in each: `{instead}`",),
        instead,
        sure=True,
        notes=("VAL-II says *Illegal expression syntax*",),
    )
