"""Histories made shorter at the front: columns, logs of events, cells, traces.

What histories share they go on sharing.
"""

import math
from array import array
from bisect import bisect_left, bisect_right
from collections.abc import Iterable, Sequence
from typing import TypeVar

from vrts.engine.memory.cells import Cell
from vrts.engine.memory.event_log import EventLog
from vrts.engine.memory.event_order import begins, is_of_robot
from vrts.engine.memory.events import (
    AnalogChanged,
    Answered,
    Event,
    ProgramEnded,
    ProgramProgressed,
    ProgramStarted,
    Prompted,
    SignalChanged,
    SpeedChanged,
    SwitchChanged,
)
from vrts.engine.memory.trace import Trace

Column = TypeVar("Column", "array[int]", "array[float]", "list[object]")


class Columns:
    """Columns cut at the front, each once, for all that share it."""

    def __init__(self) -> None:
        """Start with none cut."""
        self._cut: dict[int, tuple[object, object]] = {}  # by id: the old one, the new one

    def without(self, column: Column, count: int) -> Column:
        """Return a column without its first entries; the same for the same column."""
        if count <= 0:
            return column
        known = self._cut.get(id(column))
        if known is None:
            known = self._cut[id(column)] = (column, column[count:])
        return known[1]  # type: ignore[return-value]

    def less(self, column: "array[int]", count: int, amount: int) -> "array[int]":
        """Return a column without its first entries, the others less by an amount."""
        if count <= 0:
            return column
        known = self._cut.get(id(column))
        if known is None:
            fewer = array("I", (entry - amount for entry in column[count:]))
            known = self._cut[id(column)] = (column, fewer)
        return known[1]  # type: ignore[return-value]


class ShorterEvents:
    """Logs of events without those before a time that tell nothing any more.

    Logs that share their items go on sharing: the first one shortened serves the others, if they
    are shorter by events of later times only.
    """

    def __init__(self, before_s: float) -> None:
        """Take the time [s] before which events are let go."""
        self._before_s = before_s
        self._whole: EventLog | None = None
        self._short = EventLog()
        self._kept: list[int] = []  # which events of the whole the short one has
        self._settled = 0  # events of the whole, the last of which is the last before the time

    def shortened(self, events: EventLog) -> EventLog:
        """Return the events from the time on, and earlier ones that still tell how things are."""
        whole = self._whole
        if (
            whole is None
            or not whole.shares_with(events)
            or not (self._settled <= len(events) <= len(whole))
        ):
            self._shorten(events)
        found = self._short.first(bisect_left(self._kept, len(events)))
        found.counted = events.counted
        return found

    def _shorten(self, events: EventLog) -> None:
        last: dict[object, int] = {}
        every = list(events)
        early = [n for n, event in enumerate(every) if event.time_s < self._before_s]
        for number in early:
            for what in _tells(every[number]):
                last[what] = number
        self._whole, self._settled = events, early[-1] + 1 if early else 0
        gone = set(early).difference(last.values()) | set(_given_up(every[: self._settled]))
        self._kept = [number for number in range(len(every)) if number not in gone]
        numbers = events.numbers
        self._short = EventLog.of([every[n] for n in self._kept], [numbers[n] for n in self._kept])


def _given_up(events: Sequence[Event]) -> Iterable[int]:
    """Return the numbers of ends of the robot program that another program came before."""
    begun_s = math.inf
    for number in range(len(events) - 1, -1, -1):
        event = events[number]
        if is_of_robot(event) and event.time_s > begun_s:
            yield number
        elif begins(event):
            begun_s = event.time_s


def forget_values(cell: Cell, finished: int, columns: Columns) -> None:
    """Shorten the history of a cell to what holds from a number of finished statements on."""
    first = bisect_right(cell.since, finished) - 1
    cell.since = columns.without(cell.since, first)
    cell.values = columns.without(cell.values, first)  # type: ignore[type-var]


def forget_steps(trace: Trace, finished: int, columns: Columns) -> None:
    """Shorten a trace: counts are of the statements that are still listed."""
    first = bisect_right(trace.begun, finished) - 1
    if first > 0:
        gone = trace.counts[first]
        trace.instructions = columns.without(trace.instructions, gone)
        trace.begun = columns.without(trace.begun, first)
        trace.counts = columns.less(trace.counts, first, gone)
    first = bisect_right(trace.rested, finished) - 1
    trace.rested = columns.without(trace.rested, first)
    trace.resting = columns.without(trace.resting, first)
    first = bisect_right(trace.changed, finished) - 1
    trace.changed = columns.without(trace.changed, first)
    trace.activations = columns.without(trace.activations, first)  # type: ignore[type-var]


def _tells(event: Event) -> tuple[object, ...]:
    """Return of what an event is the latest news, until another one is."""
    match event:
        case ProgramStarted(process=process):
            return (("spell", process),)
        case ProgramEnded(process=process):
            return (("spell", process), "question")
        case ProgramProgressed(process=process):
            return (("spell", process), ("progress", process))
        case Prompted() | Answered():
            return ("question",)
        case SignalChanged(signal=signal):
            return (("signal", signal),)
        case SwitchChanged(switch=switch):
            return (("switch", switch),)
        case AnalogChanged(channel=channel):
            return (("analog", channel),)
        case SpeedChanged():
            return ("speed",)
        case _:
            return ()
