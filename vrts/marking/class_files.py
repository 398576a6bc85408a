"""What marking writes about a class as a whole: all of it in `staff`."""

from collections.abc import Generator
from contextlib import ExitStack, contextmanager, suppress
from typing import Final

import msgspec

from vrts.marking.about import NAME, About
from vrts.marking.about import from_bytes as about_from_bytes
from vrts.marking.about import to_bytes as about_to_bytes
from vrts.marking.by_hand.decisions.files import locked
from vrts.marking.exports.write import write_marks_table
from vrts.marking.layout import Layout, write_atomically
from vrts.marking.overview.page import overview_page
from vrts.marking.result import Damaged
from vrts.marking.row import Class, class_to_bytes
from vrts.marking.similarity.files import PAGE
from vrts.pipeline.refused import Refused

LOCK: Final = ".writing.lock"  # in `staff`; nothing is in it


@contextmanager
def lists_alone(layout: Layout) -> Generator[None]:
    """Hold the lists of a class against whoever else writes them: marking, desks, commands.

    What cannot be locked, since nobody may write there, is not held: who writes then is told.
    """
    with ExitStack() as held:
        if layout.staff.is_dir():  # else nobody has written anything yet
            with suppress(Refused, OSError):
                held.enter_context(locked(layout.staff, LOCK))
        yield


def begin_class(about: About, layout: Layout) -> None:
    """Write what the marking is before anything else: so what it leaves can always be purged.

    Args:
        about: Of a marking that has not ended.
        layout: Where results of an earlier marking may be.
    """
    path = layout.staff / NAME
    with lists_alone(layout):  # whoever writes them now ends first; then it is no marking of theirs
        try:
            earlier = about_from_bytes(path.read_bytes()).intake_sha256
        except (OSError, Damaged):
            earlier = ""
        about = msgspec.structs.replace(about, intake_sha256=earlier)
        write_atomically(path, about_to_bytes(about))


def write_class(rows: Class, about: About, layout: Layout) -> None:
    """Write the rows, also as a table, what the marking was, and the page of the class.

    `results.json` comes after table and page: whoever compares it with decisions sees what was
    interrupted. What the marking was comes last: until then it has not ended.
    """
    write_marks_table(rows, layout)
    write_overview(rows, about, layout)
    write_atomically(layout.results, class_to_bytes(rows))
    write_atomically(layout.staff / NAME, about_to_bytes(about))


def write_overview(rows: Class, about: About, layout: Layout) -> None:
    """Write the page of the class, with a link to similar programs where they were compared."""
    page = overview_page(
        rows,
        pages=about.wanted.pages,
        similarity=PAGE if (layout.staff / PAGE).is_file() else None,
        where=f"marked {about.when:%Y-%m-%d %H:%M %Z}",
    )
    write_atomically(layout.overview, page.encode())
