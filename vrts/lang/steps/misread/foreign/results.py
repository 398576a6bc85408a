"""`[x, y] = place(n)`, `x, y = place(n)`: several values that a program is to give back."""

import re

from vrts.lang.grammar.shapes import UNEXPECTED_TEXT
from vrts.lang.steps.misread.meant import VARIABLE, Meant
from vrts.lang.steps.repair import Repair

_GIVEN = re.compile(
    rf"(?P<open>[(\[{{])?[ \t]*(?P<names>{VARIABLE}(?:[ \t]*[, \t][ \t]*{VARIABLE})+)[ \t]*[)\]}}]?"
    r"[ \t]*:?=(?!=)[ \t]*(?:CALL[ \t]+)?(?P<program>[A-Za-z][\w.]*)[ \t]*\((?P<given>.*)\)",
    re.ASCII | re.IGNORECASE,
)
_FOR = re.compile(r"(?:FOR|SET|POINT|BITS|PACK|TIMER|DECOMPOSE|PARAMETER)\b", re.IGNORECASE)


def several_results(text: str, repair: Repair) -> Meant | None:
    """Return what is meant by a call that gives values to several variables."""
    found = _GIVEN.fullmatch(text)
    if found is None or (found["open"] is None and (_FOR.match(text) or "," not in found["names"])):
        return None
    names = re.findall(VARIABLE, found["names"])
    given = [found["given"].strip()] if found["given"].strip() else []
    call = f"CALL {found['program']}({', '.join([*given, *names])})"
    if repair.at_once(call) is None:
        return None
    return Meant(
        UNEXPECTED_TEXT,
        "a program gives no values back: it puts them into its arguments",
        0,
        len(text),
        (f"hand the variables over as arguments: `{call}`",),
        call,
        sure=True,
        notes=("VAL-II says *Illegal expression syntax*",),
    )
