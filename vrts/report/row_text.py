"""One line for one submission, as marking goes on."""

from vrts.report.assessment import Assessment
from vrts.report.first_screen import first_screen
from vrts.report.plain import one_line

NAME_WIDTH = 28
LONGEST = 110  # characters of the cause


def row_text(a: Assessment) -> str:
    """Return mark, name and cause."""
    screen = first_screen(a)
    mark = "  - " if screen.mark is None else f"{float(screen.mark):4.1f}"
    cause = screen.cause if len(screen.cause) <= LONGEST else screen.cause[: LONGEST - 1] + "…"
    return f"{mark}  {one_line(a.title):<{NAME_WIDTH}}  {cause}"
