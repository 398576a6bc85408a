"""`VALUE 1 TO 3:`: a range, where VALUE names each number."""

import re

from vrts.lang.steps.misread.meant import Meant
from vrts.lang.steps.other_forms import INVALID_EXPRESSION

MOST_VALUES = 10  # of a range that is written out

_GROUP = re.compile(r"(?P<group>VALUE[ \t]+(?P<values>[^:\"]*?)[ \t]*(?::|$))(?P<rest>.*)", re.I)
_COMPARED = re.compile(
    r"(?P<group>VALUE[ \t]+(?:IS[ \t]+)?(?P<rest>(?:[<>]=?|<>|==)[^:\"]*?)[ \t]*(?::|$)).*", re.I
)
_RANGE = re.compile(
    r"(?P<first>[^,]*?[^,\s.])[ \t]*"
    r"(?:\b(?:TO|THROUGH|THRU|UNTIL|BIS)\b|\.{2,3}|(?<=\d)-(?=[ \t]*\d))"
    r"[ \t]*(?P<last>[^,\s.][^,]*?)",
    re.IGNORECASE,
)


def value_range(text: str) -> Meant | None:
    """Return what is meant by a VALUE with `TO`, `..` or `-` between two ends."""
    compared = _COMPARED.fullmatch(text)
    if compared is not None:
        question = f"x {compared['rest'].strip()}"
        return Meant(
            INVALID_EXPRESSION,
            "VALUE takes numbers, and no comparison",
            0,
            compared.end("group"),
            (
                f"ask by IF and ELSE: `IF {question} THEN`",
                f"or write `CASE TRUE OF`, and then `VALUE ({question}):`",
            ),
            notes=("VAL-II says *Illegal expression syntax*",),
        )
    found = _GROUP.fullmatch(text)
    if found is None:
        return None
    values: list[str] = []
    known, ranges = True, 0
    for part in found["values"].split(","):
        ends = _RANGE.fullmatch(part.strip())
        ranges += ends is not None
        written = _written_out(ends["first"], ends["last"]) if ends else [part.strip()]
        known = known and bool(written)
        values += written
    if not ranges:
        return None
    known = known and len(values) <= MOST_VALUES
    instead = f"VALUE {', '.join(values)}:" if known else None
    return Meant(
        INVALID_EXPRESSION,
        "VALUE takes no range: it lists all numbers, with commas between them",
        0,
        found.end("group"),
        (f"write `{instead}`" if instead else "name each number, as in `VALUE 1, 2, 3:`",),
        instead,
        sure=True,
        notes=("VAL-II says *Illegal expression syntax*",),
    )


def _written_out(first: str, last: str) -> list[str]:
    """Return all numbers from one to another; none where they are too many, or no numbers."""
    if not (first.isdecimal() and last.isdecimal()) or len(first + last) > MOST_VALUES:
        return []
    low, high = int(first), int(last)
    return [str(n) for n in range(low, high + 1)] if high - low < MOST_VALUES else []
