"""`N100 MOVES part`, `L10: READY`: a label that is more than a number."""

import re

from vrts.lang.dialect import Dialect
from vrts.lang.grammar.shapes import LABEL_EXPECTED
from vrts.lang.steps.misread.meant import Meant
from vrts.lang.steps.repair import Repair
from vrts.lang.vocabulary.lookup import look_up

_LABELLED = re.compile(
    r"(?P<label>(?:[A-Za-z]+_?|#|\()(?P<number>\d{1,5})[:.)]?)[ \t]+(?P<step>[A-Za-z$#].*)",
    re.ASCII,
)


def word_label(text: str, repair: Repair, dialect: Dialect) -> Meant | None:
    """Return what is meant by a step behind a label with letters or signs in it."""
    found = _LABELLED.fullmatch(text)
    if found is None or repair.at_once(found["step"]) is None:
        return None
    word = look_up(found["label"].rstrip(":.)"), dialect).word
    if word is not None or found["step"].upper().startswith(("AND ", "OR ", "MOD ")):
        return None
    meant = f"{found['number']} {found['step']}"
    return Meant(
        LABEL_EXPECTED,
        f"`{found['label']}` is no label: labels are numbers alone",
        0,
        found.end("label"),
        (f"write `{meant}`, and `GOTO {found['number']}` where it is jumped to",),
        found["number"],
        sure=True,
        notes=("VAL-II says *Invalid statement label*",),
    )
