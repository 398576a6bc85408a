"""`TYPE f"part {n}"`, and `"part {}".format(n)`: a text with values in it, as in Python."""

import re

from vrts.lang.steps.misread.meant import Meant
from vrts.lang.steps.other_forms import INVALID_EXPRESSION
from vrts.lang.steps.repair import Repair

_F_STRING = re.compile(r"(?<![\w.$])f\"(?P<text>[^\"]*)\"", re.IGNORECASE)
_PLACE = re.compile(r"\{(?P<value>[^{}:!]*)(?:[:!][^{}]*)?\}")


def f_string(text: str, repair: Repair) -> Meant | None:
    """Return what is meant by a step with an f-string."""
    found = _F_STRING.search(text)
    if found is None:
        return None
    typed = re.match(r"TYPE\b|PRINT\b", text, re.IGNORECASE) is not None
    parts: list[str] = []
    at = 0
    for place in _PLACE.finditer(found["text"]):
        parts.append(f'"{found["text"][at : place.start()]}"')
        value = place["value"].strip()
        parts.append(value if typed or value[:1] == "$" else f"$ENCODE({value})")
        at = place.end()
    parts.append(f'"{found["text"][at:]}"')
    instead = (", " if typed else "+").join(part for part in parts if part != '""') or '""'
    step = text[: found.start()] + instead + text[found.end() :]
    tried = repair.steps(step)
    if tried is None:
        return None
    return Meant(
        INVALID_EXPRESSION,
        "VAL-II has no f-strings: a text is written as it stands",
        found.start(),
        found.end(),
        (f"write `{tried.text}`",),
        instead,
        sure=not tried.fixes,
    )
