"""How a final mark came to be: from the computed mark to the final one, in steps that add up."""

from fractions import Fraction
from typing import NamedTuple

from vrts.marking.row import Row

NOTHING = Fraction(0)
FULL = Fraction(10)


class Step(NamedTuple):
    """What changes a mark after it was computed."""

    title: str
    points: Fraction  # signed
    sentence: str


def steps(row: Row) -> tuple[Step, ...]:
    """Return what lies between computed and final mark, which differ by exactly these points."""
    if row.exact_final is None:
        return ()
    computed = row.result.exact_mark or NOTHING
    found: list[Step] = []
    if row.late is not None:
        deduction = min(computed, Fraction(row.late.deduction))
        found.append(Step("lateness", -deduction, row.late.sentence))
    if row.change is not None:
        found.append(Step("change by hand", Fraction(row.change.delta), row.change.reason))
    rest = row.exact_final - computed - sum((step.points for step in found), NOTHING)
    if rest:
        found.append(Step("rounding", rest, "marks are tenths from 0 to 10"))
    return tuple(found)
