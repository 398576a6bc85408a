"""How a final mark came to be: from the computed mark to the final one, in steps that add up."""

from fractions import Fraction
from typing import NamedTuple

from vrts.marking.exports.numbers import decimal
from vrts.marking.row import Row, final_mark

NOTHING = Fraction(0)
ROUNDED = "as marks are written"


class Step(NamedTuple):
    """What changes a mark after it was computed."""

    title: str
    points: Fraction  # signed
    sentence: str


def steps(row: Row) -> tuple[Step, ...]:
    """Return what lies between computed and final mark, which differ by exactly these points.

    Marks are tenths from 0 to the total, so a step may come to less than what was written for it;
    it says so then.
    """
    final, result = row.exact_final, row.result
    if final is None:
        return ()
    before = result.exact_mark or NOTHING
    found: list[Step] = []
    made = () if row.decided is None else row.decided.steps
    if row.late is not None and not row.late.review:  # what is not known yet changes nothing
        after = final
        if row.change is not None:
            after = final_mark(result.exact_mark, row.late, None, result.exact_total) or NOTHING
        found.append(Step("lateness", after - before, row.late.sentence))
        before = after
    for step in made:
        points = Fraction(step.delta)
        found.append(Step(step.title, points, step.sentence))
        before += points
    if made and before != final:
        found.append(Step(ROUNDED, final - before, f"marks are tenths from 0 to {_full(row)}"))
    if row.change is not None and not made:
        points, written = final - before, Fraction(row.change.delta)
        sentence = row.change.reason
        if points != written:
            sign = "+" if written > 0 else ""
            sentence += f" ({sign}{decimal(written)}, in tenths from 0 to {_full(row)})"
        found.append(Step("change by hand", points, sentence))
    return tuple(found)


def _full(row: Row) -> str:
    return decimal(row.result.exact_total)
