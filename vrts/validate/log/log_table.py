"""The text of a log as a table: delimiter, decimal sign, comments and header found out.

Nothing is known here of robots: every cell is a text, `numbers` makes a column of them.
"""

import math
import re
from collections.abc import Sequence
from datetime import UTC, datetime
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from vrts.base.diagnostic import Diagnostic, Label, Rule, error
from vrts.base.source import SourceFile, Span

LOG_UNREADABLE = Rule("V880", "log-unreadable")
LOG_TABLE = Rule("V881", "log-table")
LOG_VALUE = Rule("V884", "log-value")

Array = npt.NDArray[np.float64]

MOST_BYTES = 50_000_000
MOST_ROWS = 1_000_000
COMMENTS = ("#", "%", "//", "!", ";")
MISSING = frozenset({"", "-", "--", "nan", "na", "n/a", "null", "none", "?"})

_NUMBER = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?", re.IGNORECASE)
_COMMA = re.compile(r"[+-]?\d*,\d+(e[+-]?\d+)?", re.IGNORECASE)
_CLOCK = re.compile(r"(\d+):(\d\d):(\d\d(?:\.\d*)?)")


class Row(NamedTuple):
    """A line of values."""

    line: int  # from 1
    cells: tuple[str, ...]


class LogTable(NamedTuple):
    """What a log says, cell by cell."""

    source: SourceFile
    header: Row
    rows: tuple[Row, ...]
    comments: tuple[str, ...]  # the words of comment lines
    decimal_comma: bool


def read_table(data: bytes, name: str, *, numbered: bool = False) -> LogTable | Diagnostic:
    """Return the table of a log, or what is wrong with it.

    Args:
        data: The bytes of the file.
        name: As shown.
        numbered: Columns without names are read too, as 1, 2, ...
    """
    text = _text(data)
    if isinstance(text, str):
        source = SourceFile(name, text)
        return _table(source, numbered=numbered)
    return error(
        LOG_UNREADABLE,
        f"`{name}` is no table of text",
        notes=(f"expected lines of numbers; {text.reason}",),
        help=("write the log as comma-separated values: `vrts validate --help` shows them",),
    )


def numbers(table: LogTable, column: int) -> Array | Diagnostic:
    """Return a column as numbers, NaN where a value is missing; or the first that is none."""
    found = np.empty(len(table.rows))
    for k, row in enumerate(table.rows):
        cell = row.cells[column] if column < len(row.cells) else ""
        value = _number(cell, decimal_comma=table.decimal_comma)
        if value is None:
            return error(
                LOG_VALUE,
                f"`{cell[:40]}` in column `{table.header.cells[column]}` is no number",
                Label(line_span(table.source, row.line), "expected a number here"),
                help=("leave the field empty, or write `nan`, where a value is missing",),
                data={"line": row.line, "column": table.header.cells[column]},
            )
        found[k] = value
    return found


def line_span(source: SourceFile, line: int) -> Span:
    """Return the place of a line."""
    start = source.line_starts[line - 1]
    return Span(source, start, start + len(source.line_text(line)))


class _Refusal(NamedTuple):
    reason: str


def _text(data: bytes) -> "str | _Refusal":
    if not data.strip():
        return _Refusal("the file is empty")
    if len(data) > MOST_BYTES:
        return _Refusal(f"it has {len(data):,} bytes, more than {MOST_BYTES:,}")
    if data[:2] in (b"\xff\xfe", b"\xfe\xff"):
        text = data.decode("utf-16", "replace")
    else:
        try:
            text = data.decode("utf-8-sig")
        except UnicodeDecodeError:
            text = data.decode("latin-1")  # a degree sign of an old machine
    if "\0" in text:
        return _Refusal("it holds bytes that are no text")
    return text.replace("\r\n", "\n").replace("\r", "\n")


def _table(source: SourceFile, *, numbered: bool) -> LogTable | Diagnostic:
    comments: list[str] = []
    lines: list[tuple[int, str]] = []
    header_in_comment: tuple[int, str] | None = None
    for number, line in enumerate(source.lines(), 1):
        bare = line.strip()
        if not bare:
            continue
        if bare.startswith(COMMENTS):
            comments.append(bare.lstrip("#%/!; "))
            if not lines:
                header_in_comment = (number, comments[-1])
            continue
        lines.append((number, line))
    if len(lines) > MOST_ROWS:
        return _no_table(source, lines[MOST_ROWS][0], f"more than {MOST_ROWS:,} rows")
    if not lines:
        return _no_table(source, 1, "there are only comments")
    delimiter = _delimiter(lines[0][1])
    if _looks_numeric(lines[0][1]):
        if header_in_comment is not None:
            lines.insert(0, header_in_comment)
            delimiter = _delimiter(header_in_comment[1])
        elif numbered:
            count = len(_cells(lines[0][1], delimiter))
            names = (delimiter or " ").join(str(k + 1) for k in range(count))
            lines.insert(0, (lines[0][0], names))
        else:
            return _no_table(
                source,
                lines[0][0],
                "numbers, but no line that names the columns",
                "write such a line, or say by `--columns FILE` which column holds what",
            )
    rows = [Row(number, _cells(line, delimiter)) for number, line in lines]
    header, body = rows[0], rows[1:]
    if not body:
        return _no_table(source, header.line, "names of columns, but no values below them")
    width = len(header.cells)
    comma = delimiter != "," and any(_COMMA.fullmatch(c) for row in body[:100] for c in row.cells)
    for row in body:
        if len(row.cells) > width and any(row.cells[width:]):
            return _no_table(
                source,
                row.line,
                f"{len(row.cells)} values under {width} names",
                "commas between values and as decimal signs cannot be told apart: separate values"
                " by semicolons or tabs, or write decimal points"
                if delimiter == ","
                else "",
            )
    return LogTable(source, header, tuple(body), tuple(comments), comma)


def _no_table(source: SourceFile, line: int, came: str, remedy: str = "") -> Diagnostic:
    return error(
        LOG_TABLE,
        f"`{source.name}` cannot be read as a table",
        Label(line_span(source, line), came),
        notes=(
            "expected a line of names such as `time_s,jt1_deg,…,jt6_deg`, then lines of values",
        ),
        help=(remedy,) if remedy else (),
        data={"line": line},
    )


def _delimiter(header: str) -> str | None:
    """Return what separates values; None: blanks."""
    return next((sign for sign in (";", "\t", ",") if sign in header), None)


def _cells(line: str, delimiter: str | None) -> tuple[str, ...]:
    return tuple(cell.strip().strip('"').strip() for cell in line.split(delimiter))


def _looks_numeric(line: str) -> bool:
    cells = [cell for cell in re.split(r"[;\t ]+|,(?!\d)|(?<!\d),", line.strip()) if cell]
    return all(_plain(cell) or _COMMA.fullmatch(cell) or _CLOCK.search(cell) for cell in cells)


def _plain(cell: str) -> bool:
    parts: Sequence[str] = cell.split(",")
    return all(_NUMBER.fullmatch(part) or part.lower() in MISSING for part in parts)


def _number(cell: str, *, decimal_comma: bool) -> float | None:
    if cell.lower() in MISSING:
        return math.nan
    if decimal_comma and _COMMA.fullmatch(cell):
        cell = cell.replace(",", ".")
    if _NUMBER.fullmatch(cell):
        value = float(cell)
        return value if math.isfinite(value) else None
    return _clock(cell)


def _clock(cell: str) -> float | None:
    """Return seconds of a time of day, or of a date with one."""
    clock = _CLOCK.fullmatch(cell)
    if clock is not None:
        hours, minutes, seconds = clock.groups()
        return 3600.0 * int(hours) + 60.0 * int(minutes) + float(seconds)
    if ":" not in cell:
        return None
    try:
        found = datetime.fromisoformat(cell.replace("Z", "+00:00"))
    except ValueError:
        return None
    return (found if found.tzinfo else found.replace(tzinfo=UTC)).timestamp()
