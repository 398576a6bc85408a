"""Writes what follows from decisions: lists, overview, feedback."""

from pathlib import Path
from typing import Final

from vrts.desk.again.going_on import goes_on
from vrts.desk.book.book import Book
from vrts.desk.book.shelf import sentence
from vrts.marking import about
from vrts.marking.layout import Layout
from vrts.marking.renewing.renewed import pending, renewed
from vrts.marking.result import Damaged
from vrts.pipeline.files import CannotRead
from vrts.pipeline.refused import Refused

NOT_YET: Final = "lists and feedback follow your decisions when the marking has ended"


def follow(folder: Path) -> str:
    """Bring the files of a class up to date; return what went wrong, "" where nothing did.

    While a marking goes on, or has not ended, nothing is written: `NOT_YET`.
    """
    layout = Layout(folder)
    try:
        if goes_on(folder) or not _has_ended(layout):
            return NOT_YET
        renewed(layout)
    except (CannotRead, Refused) as problem:
        return f"lists and feedback are not up to date: {sentence(problem)}"
    except OSError as problem:
        return f"lists and feedback are not up to date: {problem.strerror or problem}"
    return ""


def _has_ended(layout: Layout) -> bool:
    try:
        return about.from_bytes((layout.staff / about.NAME).read_bytes()).finished is not None
    except Damaged:
        return True  # what is wrong with it is told by who reads it next


def is_behind(book: Book) -> bool:
    """Return whether lists lack decisions: a desk, or a marking, may have ended too early."""
    written = {row.id: row for row in book.opened.rows.rows}
    return bool(pending(book.opened.layout)) or any(
        (row.decided, row.final) != (written[row.id].decided, written[row.id].final)
        for row in book.rows.rows
        if row.id not in book.seen.alone  # of which not all is seen here
    )
