"""What marking writes about a class as a whole: all of it in `staff`."""

from vrts.marking.about import NAME, About
from vrts.marking.about import to_bytes as about_to_bytes
from vrts.marking.layout import Layout, write_atomically
from vrts.marking.row import Class, class_to_bytes


def write_class(rows: Class, about: About, layout: Layout) -> None:
    """Write the rows, and what the marking was."""
    write_atomically(layout.results, class_to_bytes(rows))
    write_atomically(layout.staff / NAME, about_to_bytes(about))
