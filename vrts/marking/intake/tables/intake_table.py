"""Writes intake.csv, which the teacher may edit and marking obeys."""

from collections.abc import Iterable
from datetime import datetime

from vrts.marking.intake.row import Attempt, Problem, Row
from vrts.marking.intake.tables.table_text import BOM, field

COLUMNS = (
    "id",
    "name",
    "file",
    "problem",
    "why",
    "received",
    "late",
    "due",
    "email",
    "login",
    "ids",
    "group",
    "attempts",
    "others",
    "download",
)
NAME = "intake.csv"
YES, NO = "yes", "no"
UNKNOWN_TIME = "-"
COUNTS = "*"  # before the attempt that counts, where that is not the latest


def write_rows(rows: Iterable[Row], delimiter: str = ",", download: str = "") -> bytes:
    """Return the table of rows, as spreadsheets read it: UTF-8 with its mark, RFC 4180.

    Args:
        rows: Of the intake.
        delimiter: Between fields; spreadsheets of many languages want `;`.
        download: Name of the file or folder that they are of.
    """
    lines = [delimiter.join(COLUMNS)]
    lines += [delimiter.join(field(text) for text in (*_texts(row), download)) for row in rows]
    return BOM + "".join(f"{line}\r\n" for line in lines).encode()


def _texts(row: Row) -> tuple[str, ...]:
    """Return the fields of a row, in the order of the columns, up to the download."""
    student = row.student
    return (
        row.identifier,
        student.name,
        row.file or "",
        problem_text(row.problem),
        row.why,
        time_text(row.received),
        YES if row.called_late else NO if row.late is False else "",
        time_text(row.due),
        student.email,
        student.login,
        "; ".join(f"{platform} {value}" for platform, value in student.ids.items()),
        row.group,
        "\n".join(_attempt(row, one) for one in row.attempts) if _lists(row) else "",
        "\n".join(row.others),
    )


def problem_text(problem: Problem | None) -> str:
    """Return a problem as one text: its kind, and the sentence."""
    if problem is None:
        return ""
    return f"{problem.kind.value}: {problem.sentence}"


def time_text(time: datetime | None) -> str:
    """Return a time as written in tables: ISO 8601 with its offset."""
    return "" if time is None else time.isoformat()


def _lists(row: Row) -> bool:
    """Return whether attempts are more than what `file` and `received` tell."""
    return len(row.attempts) > 1 or (row.problem is not None and bool(row.attempts))


def _attempt(row: Row, attempt: Attempt) -> str:
    another = attempt.file == row.file and attempt != row.attempts[-1]
    words = f"{time_text(attempt.received) or UNKNOWN_TIME} {attempt.file}"
    return f"{COUNTS} {words}" if another else words
