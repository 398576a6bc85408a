"""One line for one submission as marking goes on, and one more if somebody has to look at it."""

from fractions import Fraction

from vrts.marking.result import Result
from vrts.report.plain import one_line, width
from vrts.report.quantities import mark

NAME_WIDTH = 28
LONGEST = 110  # characters of the cause


def row_words(result: Result, name: str) -> str:
    """Return mark, name and cause of a result; a second line where it has to be reviewed."""
    number = result.exact_mark
    shown = "  - " if number is None else f"{mark(number):>4}"
    cause = one_line(result.cause)
    if len(cause) > LONGEST:
        cause = cause[: LONGEST - 1] + "…"
    title = one_line(name)
    row = f"{shown}  {title}{' ' * max(0, NAME_WIDTH - width(title))}  {cause}"
    if not result.review:
        return row
    reasons = "; ".join(one_line(reason) for reason in result.review)
    between = ""
    if result.lowest is not None and result.lowest != result.mark and number is not None:
        between = f" {mark(Fraction(str(result.lowest)))} to {mark(number)}"
    return f"{row}\n      review{between}: {reasons}"
