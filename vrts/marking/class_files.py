"""What marking writes about a class as a whole: all of it in `staff`."""

import msgspec

from vrts.marking.about import NAME, About
from vrts.marking.about import from_bytes as about_from_bytes
from vrts.marking.about import to_bytes as about_to_bytes
from vrts.marking.exports.write import write_marks_table
from vrts.marking.layout import Layout, write_atomically
from vrts.marking.overview.page import overview_page
from vrts.marking.result import Damaged
from vrts.marking.row import Class, class_to_bytes
from vrts.marking.similarity.files import PAGE


def begin_class(about: About, layout: Layout) -> None:
    """Write what the marking is before anything else: so what it leaves can always be purged.

    Args:
        about: Of a marking that has not ended.
        layout: Where results of an earlier marking may be.
    """
    path = layout.staff / NAME
    try:
        earlier = about_from_bytes(path.read_bytes()).intake_sha256
    except (OSError, Damaged):
        earlier = ""
    write_atomically(path, about_to_bytes(msgspec.structs.replace(about, intake_sha256=earlier)))


def write_class(rows: Class, about: About, layout: Layout) -> None:
    """Write the rows, also as a table, what the marking was, and the page of the class."""
    write_atomically(layout.results, class_to_bytes(rows))
    write_atomically(layout.staff / NAME, about_to_bytes(about))
    write_marks_table(rows, layout)
    write_overview(rows, about, layout)


def write_overview(rows: Class, about: About, layout: Layout) -> None:
    """Write the page of the class, with a link to similar programs where they were compared."""
    page = overview_page(
        rows,
        pages=about.wanted.pages,
        similarity=PAGE if (layout.staff / PAGE).is_file() else None,
        where=f"marked {about.when:%Y-%m-%d %H:%M %Z}",
    )
    write_atomically(layout.overview, page.encode())
