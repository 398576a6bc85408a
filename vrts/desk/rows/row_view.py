"""Everything about one row: its program, what it lost, what was decided, and what was before."""

from urllib.parse import quote

from msgspec.structs import replace

from vrts.desk.book.book import Book, found_out
from vrts.desk.rows.causes import cause_key
from vrts.desk.told import HistoryTold, LossTold, OneRow, RowTold, SourceTold, StepTold
from vrts.marking.exports.numbers import number
from vrts.marking.exports.steps import steps
from vrts.marking.layout import STAFF, STUDENTS
from vrts.marking.row import Row
from vrts.marking.submission.report_files import REPORT

LONGEST_PROGRAM = 400_000  # characters that are shown
FILES = "/files"


def one_row(
    book: Book, told: RowTold, source: SourceTold | None, source_problem: str | None
) -> OneRow:
    """Return everything about a row.

    Args:
        book: The state.
        told: The row as the list has it.
        source: Its program; None where there is none to show.
        source_problem: Why there is none, where one was marked.
    """
    row = book.by_id[told.id]
    result, mine = found_out(row), book.decided.of(row.id)
    losses = tuple(
        LossTold(
            loss.points,
            loss.kind,
            loss.sentence,
            loss.hint,
            loss.line,
            loss.time_s,
            cause_key(loss),
        )
        for loss in result.losses
    )
    made = tuple(
        StepTold(float(number(step.points)), step.title, step.sentence) for step in steps(row)
    )
    return OneRow(
        told,
        source,
        source_problem,
        losses,
        result.checks,
        result.findings,
        made,
        mine.comments,
        mine.given,
        mine.changes,
        tuple(_with_others(book, one) for one in mine.history),
        _address(book, row, staff=True),
        _address(book, row, staff=False),
        book.attempts_of(row),
    )


def _with_others(book: Book, one: HistoryTold) -> HistoryTold:
    return replace(one, at_once=book.decided.beside(one.record))


def source_of(name: str, data: bytes) -> SourceTold:
    """Return a program as it is shown: any bytes can be."""
    text = data.decode("utf-8-sig", "replace")[:LONGEST_PROGRAM]
    lines = text.replace("\r\n", "\n").replace("\r", "\n").split("\n")
    return SourceTold(name, tuple(lines[:-1] if lines[-1] == "" else lines))


def _address(book: Book, row: Row, *, staff: bool) -> str | None:
    layout = book.opened.layout
    home = layout.grader(row.id) if staff else layout.student(row.id)
    if not (home / REPORT).is_file():
        return None
    folder = f"{STAFF}/{STUDENTS}" if staff else STUDENTS
    return f"{FILES}/{folder}/{quote(row.id, safe='')}/{REPORT}"
