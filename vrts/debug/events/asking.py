"""A question to the tables of a run, answered: rows with a number each, to go to."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Generic, NamedTuple, TypeVar, cast

from vrts.debug.alarms import Alarms
from vrts.debug.events import calls, happened
from vrts.debug.events.calls import Call, calls_of
from vrts.debug.events.columns import Columns, texts_of
from vrts.debug.events.happened import CHECKED, Happening, time_of
from vrts.debug.events.query import USUAL, Query, read_query
from vrts.debug.near import near_words
from vrts.debug.passages import Instant
from vrts.debug.stops.stop import Stop
from vrts.engine.memory.events import Cause
from vrts.engine.run import Run
from vrts.report.plain import visible

R = TypeVar("R")
COLUMNS: Mapping[str, Columns[Any]] = {"events": happened.COLUMNS, "calls": calls.COLUMNS}
TABLES = tuple(COLUMNS)


class Row(NamedTuple):
    """A row of an answer."""

    number: int  # to go to, from 1
    time_s: float
    words: str
    go: Stop
    cause: Cause | None
    values: Mapping[str, Any]  # by column, with its unit behind the name: `depth_mm`

    @property
    def text(self) -> str:
        """The row as a line for people."""
        return f"{self.number:>4} {self.time_s:9.3f} s  {self.words}"


class Answer(NamedTuple):
    """What a table says."""

    table: str
    rows: Sequence[Row]
    total: int  # rows that fit
    says: Sequence[str]  # what there is to say beside


@dataclass(frozen=True, slots=True)
class _Table(Generic[R]):
    """A table of a run, and how its rows are told."""

    name: str
    columns: Columns[R]
    text: Callable[[R], str]  # that the words of a question are looked for in
    line: Callable[[R], tuple[float, str]]  # when [s], and the rest of its line
    stop: Callable[[R], Stop]
    cause: Callable[[R], Cause | None]


class Tables:
    """The tables of one run; each is made once it is asked for."""

    def __init__(self, run: Run, alarms: Alarms) -> None:
        """Take a run, and what knows its contacts."""
        self.run, self._alarms = run, alarms
        self._events: dict[bool, list[Happening]] = {}
        self._calls: list[Call] | None = None

    def asked(self, table: str, text: str, at: Instant) -> Answer:
        """Return the rows that fit a question.

        Args:
            table: One of `TABLES`.
            text: The question, as `query` reads it.
            at: Where somebody stands who asks.

        Raises:
            CannotTell: The question cannot be read; the text says why.
        """
        if table == "calls":
            query = read_query(text, calls.COLUMNS, at.time_s, table)
            return _answer(self._of_calls(), self.calls(), query)
        asked = read_query(text, happened.COLUMNS, at.time_s, table)
        checked = asked.kinds is None or not asked.kinds.isdisjoint(CHECKED)
        return _answer(self._of_events(), self.events(checked=checked), asked)

    def events(self, *, checked: bool) -> list[Happening]:
        """Return the table of events; with contacts and near misses if it is checked."""
        if checked not in self._events:
            self._events[checked] = happened.happened(self.run, self._alarms, checked=checked)
        return self._events[checked]

    def calls(self) -> list[Call]:
        """Return the table of calls."""
        if self._calls is None:
            self._calls = calls_of(self.run)
        return self._calls

    def _of_events(self) -> _Table[Happening]:
        kind = happened.COLUMNS["kind"].of
        return _Table(
            "events",
            happened.COLUMNS,
            lambda row: f"{kind(row)} {happened.text_of(row)}",
            lambda row: (time_of(row), f"{kind(row)!s:9} {happened.text_of(row)}{_at(row)}"),
            lambda row: happened.stop_at(self.run, row),
            lambda row: row.event.cause,
        )

    def _of_calls(self) -> _Table[Call]:
        return _Table(
            "calls",
            calls.COLUMNS,
            calls.text_of,
            lambda row: (row.begin.time_s, calls.text_of(row)),
            calls.stop_at,
            lambda row: row.cause,
        )


def _answer(table: _Table[R], rows: list[R], query: Query[R]) -> Answer:
    found = rows if query.fits is None else [row for row in rows if query.fits(row)]
    if query.words:
        found = [
            row for row in found if all(word in table.text(row).lower() for word in query.words)
        ]
    if query.by:
        found = _sorted(found, table.columns[query.by].of, down=query.down)
    total = len(found)
    kept = found[: query.first or USUAL] if query.last is None else found[-query.last :]
    says: list[str] = []
    if not total:
        says += _nothing(table, rows, query)
    elif len(kept) < total and query.first is None and query.last is None:
        says.append(
            f"the first {len(kept)} of {total:,}: `first N`, `last N` and `where` choose others"
        )
    told = (_row(table, number, row) for number, row in enumerate(kept, start=1))
    return Answer(table.name, list(told), total, says)


def _row(table: _Table[R], number: int, row: R) -> Row:
    time_s, words = table.line(row)
    values: dict[str, Any] = {}
    for name, column in table.columns.items():
        value = column.of(row)
        if value is not None:
            values[f"{name}_{column.unit}" if column.unit else name] = value
    return Row(number, time_s, visible(words), table.stop(row), table.cause(row), values)


def _at(row: Happening) -> str:
    """Return the line of the step that did it, in words."""
    cause = row.event.cause
    return "" if cause is None else f", line {cause.span.line}"


def _sorted(rows: list[R], of: Callable[[R], object], *, down: bool) -> list[R]:
    """Return rows by a column, those that have nothing in it last."""
    having = [row for row in rows if of(row) is not None]
    without = [row for row in rows if of(row) is None]
    return [*sorted(having, key=cast("Callable[[R], Any]", of), reverse=down), *without]


def _nothing(table: _Table[R], rows: list[R], query: Query[R]) -> list[str]:
    """Return what to say where no row fits, with what may have been meant."""
    says = [f"no such {table.name.rstrip('s')}"]
    for column, text in query.equal:
        of = table.columns[column].of
        known = {each.lower() for row in rows if (c := of(row)) is not None for each in texts_of(c)}
        if text.lower() not in known:
            says.append(f"no row has the {column} `{text}`{near_words(text.lower(), known)}")
    return says
