"""What a command did, as text for people and as data for programs (`vrts.debug/1`)."""

import json
from collections.abc import Iterable, Iterator

from vrts.debug.events.asking import Row as TableRow
from vrts.debug.scripted.places import NAMES, as_data
from vrts.debug.scripted.session import Done, Row
from vrts.report.plain import SERVICE_COMMAND, visible

SCHEMA = "vrts.debug/1"
MOST_LINES = 1_000  # of one command
WIDEST = 2_000  # characters of a line


def as_text(done: Done) -> str:
    """Return what a command did, in lines for people."""
    mark = ">" if done.ok else "!"
    return "\n".join([f"{mark} {visible(done.command)}", *(f"  {line}" for line in _lines(done))])


def json_line(number: int, done: Done) -> str:
    """Return what a command did as one line of JSON, in ASCII: no terminal obeys it."""
    text = json.dumps(as_data_of(number, done), ensure_ascii=True, allow_nan=False)
    return SERVICE_COMMAND.sub(r"\\u0023", text.replace("\x7f", r"\u007f"))


def as_data_of(number: int, done: Done) -> dict[str, object]:
    """Return what a command did, as the schema `debug` has it."""
    found: dict[str, object] = {
        "schema": SCHEMA,
        "number": number,
        "command": done.command,
        "ok": done.ok,
    }
    place = done.place
    if place is not None:
        found |= {
            "time_s": place.time_s,
            "statements": place.statements,
            "stopped": {"why": NAMES[place.why], "text": place.text},
        }
        if place.line:
            found |= {
                "file": place.file,
                "program": place.program,
                "step": place.step,
                "line": place.line,
                "source": place.source,
            }
    found["said"] = _cut(done.said)
    if done.value is not None:
        found["value"] = as_data(done.value)
    if done.reasons:
        found["reasons"] = _cut(done.reasons)
    if done.table is not None:
        found[done.table.table] = [_row_data(row) for row in done.table.rows]
        found["total"] = done.table.total
    if done.log:
        found["log"] = [row._asdict() for row in done.log[:MOST_LINES]]
    return found


def _row_data(row: TableRow) -> dict[str, object]:
    """Return a row of a table: its columns, and where it leads."""
    found: dict[str, object] = {"number": row.number, "text": row.words}
    for name, value in row.values.items():
        found[name] = value  # JSON knows no tuples, and makes lists of them
    at = row.go.instant
    return found | {"go": {"time_s": at.time_s, "statements": at.finished}}


def _lines(done: Done) -> Iterator[str]:
    yield from _cut(_row(row) for row in done.log)
    if done.table is not None:
        yield from _cut(row.text for row in done.table.rows)
    yield from (visible(line) for line in _cut(done.said))
    if done.moved and done.ok and done.place is not None:
        yield from done.place.sentence.split("\n")


def _row(row: Row) -> str:
    return f"{row.time_s:9.3f} s  {row.kind:8} {row.text}"


def _cut(lines: Iterable[str]) -> list[str]:
    found = [line if len(line) <= WIDEST else f"{line[:WIDEST]} …" for line in lines]
    more = len(found) - MOST_LINES
    return found if more <= 0 else [*found[:MOST_LINES], f"and {more:,} lines more"]
