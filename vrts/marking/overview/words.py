"""How rows are called, and their numbers written, on the pages of a class."""

from fractions import Fraction

from vrts.marking.result import Kind
from vrts.marking.row import Row
from vrts.report.page.html import Markup, element
from vrts.report.plain import one_line
from vrts.report.quantities import MINUS, points

NONE = "–"
RANGE = "the mark is between"  # said by columns of its own

KINDS = {  # in the order of the page
    Kind.GRADED: "graded",
    Kind.STOPPED: "stopped by an error",
    Kind.LIMIT: "stopped by a limit",
    Kind.DOES_NOT_COMPILE: "does not compile",
    Kind.UNREADABLE: "unreadable",
    Kind.AMBIGUOUS: "ambiguous",
    Kind.UNREAD: "not read",
    Kind.RESOURCE: "too much time or memory",
    Kind.FAULT: "fault of vrts",
    Kind.MISSING: "missing",
    Kind.EXCUSED: "excused",
}


def name_of(row: Row) -> str:
    """Return what a row is called: the student, else its id."""
    return one_line(row.student.name) or row.id


def who(row: Row, link: str | None) -> Markup:
    """Return the name of a row, linked, with the id beside it where they differ."""
    name = name_of(row)
    label = element("a", name, href=link) if link else element("span", name)
    small = element("small", row.id) if name != row.id else None
    return element("span", label, small, class_="who")


def reasons(row: Row) -> tuple[str, ...]:
    """Return why somebody has to look at a row."""
    told = [(doubt.reason.value, one_line(doubt.sentence)) for doubt in row.unsafe]
    said = [(reason, text) for reason, text in told if not text.startswith(RANGE)]
    return tuple(f"{reason}: {text}" for reason, text in said or told)


def to_review(row: Row) -> bool:
    """Return whether somebody has to look at a row."""
    return bool(row.unsafe)


def has_report(row: Row) -> bool:
    """Return whether there is a page about a row: there is where a program was marked."""
    return row.result.program is not None


def tenth(value: float | None) -> str:
    """Return a mark with its one decimal."""
    return NONE if value is None else f"{value:.1f}"


def signed(value: Fraction) -> str:
    """Return points with their sign."""
    return (MINUS if value < 0 else "+") + points(abs(value))
