"""Why a teacher's file cannot be filled in."""

from collections.abc import Iterable

from vrts.base.diagnostic import Rule, error
from vrts.marking.exports.given import Options, Page
from vrts.marking.exports.grade_books.sheet import LARGEST
from vrts.pipeline.refused import Refused

NO_SUCH_FILE = Rule("V740", "no-grade-book")
NO_COLUMN = Rule("V741", "no-column-for-marks")
NO_POINTS = Rule("V742", "points-unknown")


def file_of(options: Options, what: str) -> Page:
    """Return the file to fill in.

    Raises:
        Refused: None was given, or it is too large.
    """
    if options.fill is None:
        raise no_file(f"no {what} was given", what)
    if len(options.fill.data) > LARGEST:
        raise no_file(f"`{options.fill.name}` has more than {LARGEST:,} bytes", what)
    return options.fill


def no_file(headline: str, what: str) -> Refused:
    """Return that a file is not what it has to be."""
    remedy = f"export the {what}, and name the file with `--fill`; vrts fills it in, and makes none"
    return Refused((error(NO_SUCH_FILE, headline, help=(remedy,)),))


def no_column(headline: str, titles: Iterable[str]) -> Refused:
    """Return that it cannot be told where marks belong."""
    shown = ", ".join(f"`{title}`" for title in titles)
    notes = (f"columns: {shown}",) if shown else ()
    remedy = "name the column with `--column`"
    return Refused((error(NO_COLUMN, headline, notes=notes, help=(remedy,)),))


def no_points(headline: str) -> Refused:
    """Return that it cannot be told what full marks are worth."""
    remedy = "give the assignment points on the platform, or name them with `--points`"
    return Refused((error(NO_POINTS, headline, help=(remedy,)),))
