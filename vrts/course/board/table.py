"""The public marks of a course as a table: a line for each student and assignment.

Public marks are preliminary: hidden checks, lateness and graders come when a class is marked. So
the columns are called otherwise than those of `vrts grade`, and no grade book takes them for final.
"""

from collections.abc import Iterable, Iterator, Mapping
from datetime import UTC, datetime
from fractions import Fraction
from typing import Final

from vrts.course.board.told import BoardTold, CellTold, ColumnTold, StudentTold
from vrts.live.store.course.people import Person
from vrts.marking.exports.numbers import decimal
from vrts.marking.intake.tables.table_text import BOM, field
from vrts.report.plain import one_line

COLUMNS: Final = (
    "id",
    "name",
    "email",
    "ids",
    "team",
    "assignment",
    "attempts",
    "public mark",
    "of",
    "last attempt",
    "last mark",
    "state",
    "late",
    "lost most by",
)


def marks_csv(told: BoardTold, people: Iterable[Person], assignment: str | None = None) -> bytes:
    """Return the table: UTF-8 with its mark, RFC 4180, no field a formula.

    Args:
        told: The board.
        people: Of the lists: their addresses and ids.
        assignment: The only one that is wanted; None: all.
    """
    known = {person.account: person for person in people}
    words = {cause.key: cause.words for cause in told.causes}
    lines = [",".join(COLUMNS)]
    for row in told.students:
        for column, cell in zip(told.columns, row.cells, strict=True):
            if assignment in (None, column.id):
                lines.append(",".join(_fields(row, known[row.id], column, cell, words)))
    return BOM + "".join(f"{line}\r\n" for line in lines).encode()


def _fields(
    row: StudentTold,
    person: Person,
    column: ColumnTold,
    cell: CellTold,
    words: Mapping[str, str],
) -> Iterator[str]:
    """Yield the fields of a line: foreign text guarded, numbers as they are."""

    def text(value: str) -> str:
        return field(one_line(value))

    def number(value: float | None) -> str:
        return "" if value is None else decimal(Fraction(repr(value)), least=1, point=".")

    yield text(row.key)
    yield text(row.name)
    yield text(person.email)
    yield text("; ".join(f"{platform} {value}" for platform, value in person.ids.items()))
    yield text(row.team)
    yield text(column.id)
    yield str(cell.tries)
    yield number(cell.mark)
    yield number(column.total or None)
    yield datetime.fromtimestamp(cell.at, UTC).isoformat(timespec="seconds") if cell.at else ""
    yield number(cell.last)
    yield cell.state
    yield text(cell.late)
    yield text(words.get(cell.cause, ""))
