"""What exports are made of, and what they make."""

from collections.abc import Callable, Iterable, Mapping
from datetime import datetime
from fractions import Fraction
from types import MappingProxyType
from typing import NamedTuple

from vrts.base.diagnostic import Diagnostic
from vrts.marking.result import Result
from vrts.marking.row import Class, Row


class Page(NamedTuple):
    """A file for a student, as marking wrote it."""

    name: str
    data: bytes


class Given(NamedTuple):
    """A class as marked, and what its students may know."""

    whole: Class  # for those who mark
    public: Mapping[str, Result]  # the students' own results, by id: nothing hidden is in them
    pages: Callable[[str], tuple[Page, ...]]  # what is there to be sent to a student


class Options(NamedTuple):
    """How to export."""

    fill: Page | None = None  # the teacher's worksheet or grade book, to be filled in
    column: str = ""  # title of the column for the marks; "" where it can be told
    points: Fraction | None = None  # what full marks are worth; None: as the file tells
    comments: bool = True  # whether to fill in comments, where there is a column for them
    delimiter: str = ","  # of tables of our own; with `;` numbers have a decimal comma
    pages: bool = True  # whether reports go along with the feedback
    environment: Mapping[str, str] = MappingProxyType({})  # of a platform's run, by variable
    now: datetime | None = None  # UTC
    decimal: str = ""  # "," or "."; "" as a file that is filled in tells, and as `delimiter` tells
    despite: frozenset[str] = frozenset()  # reasons why marks are unsafe that do not keep them back


class Product(NamedTuple):
    """The files of an export, by their path with `/`, and what there is to say."""

    files: Iterable[tuple[str, bytes]]
    diagnostics: tuple[Diagnostic, ...] = ()


class Returned(NamedTuple):
    """A row, and the result that its student sees."""

    row: Row
    public: Result


def returned(given: Given) -> Iterable[Returned]:
    """Yield every row with the student's own result."""
    return (Returned(row, given.public[row.id]) for row in given.whole.rows)
