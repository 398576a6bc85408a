"""One line for one submission as marking goes on, and one more if somebody has to look at it."""

from fractions import Fraction

from vrts.base.safe_names import safe
from vrts.marking.exports.steps import steps
from vrts.marking.result import Result
from vrts.marking.row import Row
from vrts.report.plain import one_line, width
from vrts.report.quantities import lost, mark

MARK_WIDTH = 4  # of 10.0; a larger total needs more
NAME_WIDTH = 28
LONGEST = 110  # characters of the cause


def row_words(row: Row, title: str) -> str:
    """Return final mark, name and cause; further lines for what is beside the computed mark.

    Args:
        row: Of the submission.
        title: Of its program; shown where it tells as much as the id.
    """
    result, final = row.result, row.exact_final
    wide = max(MARK_WIDTH, len(mark(result.exact_total)))
    shown = f"{'- ' if final is None else mark(final):>{wide}}"
    cause = one_line(result.cause)
    if len(cause) > LONGEST:
        cause = cause[: LONGEST - 1] + "…"
    name = one_line(title if safe(title.rsplit(".", 1)[0]) == row.id else row.id)
    lines = [f"{shown}  {name}{' ' * max(0, NAME_WIDTH - width(name))}  {cause}"]
    beside = steps(row)
    if beside:
        computed = "no mark" if result.exact_mark is None else mark(result.exact_mark)
        told = (f"{lost(-step.points)} {step.title} ({one_line(step.sentence)})" for step in beside)
        lines.append(f"      computed {computed}; {'; '.join(told)}")
    if row.unsafe:
        lines.append(f"      unsafe{_between(result)}: {_reasons(row)}")
    return "\n".join(lines)


def _reasons(row: Row) -> str:
    """Return why a mark is unsafe, without saying the cause once more."""
    cause = row.result.cause
    return "; ".join(
        doubt.reason.value + ("" if doubt.sentence == cause else f": {one_line(doubt.sentence)}")
        for doubt in row.unsafe
    )


def _between(result: Result) -> str:
    """Return between which marks the right one lies, where that is known."""
    highest = result.exact_mark
    if result.lowest is None or highest is None or result.lowest == result.mark:
        return ""
    return f" {mark(Fraction(str(result.lowest)))} to {mark(highest)}"
