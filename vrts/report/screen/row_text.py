"""One line for one submission, as marking goes on, and one more if it has to be reviewed."""

from vrts.report.assessment import Assessment
from vrts.report.first_screen import first_screen
from vrts.report.plain import one_line
from vrts.report.review import review_of

MARK_WIDTH = 4  # of 10.0; a larger total needs more
NAME_WIDTH = 28
LONGEST = 110  # characters of the cause


def row_text(a: Assessment) -> str:
    """Return mark, name and cause; a second line where a person has to look at the run."""
    screen = first_screen(a)
    mark = "  - " if screen.mark is None else f"{float(screen.mark):.1f}"
    mark = f"{mark:>{max(MARK_WIDTH, len(f'{float(screen.total):.1f}'))}}"
    cause = screen.cause if len(screen.cause) <= LONGEST else screen.cause[: LONGEST - 1] + "…"
    row = f"{mark}  {one_line(a.title):<{NAME_WIDTH}}  {cause}"
    review = review_of(a)
    if review is None:
        return row
    reasons = "; ".join(review.reasons)
    return f"{row}\n      review{f' {review.range}' if review.range else ''}: {reasons}"
