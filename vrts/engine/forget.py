"""The far past of machines forgotten, so that one that goes on for hours stays small.

From the time given on everything can be asked as before; earlier answers are lost.
"""

import math
from array import array
from bisect import bisect_left, bisect_right
from collections.abc import Iterable, Sequence
from typing import TypeVar

from vrts.engine.code.executable import Executable
from vrts.engine.hand.hand import Hand
from vrts.engine.machine.machine import Machine
from vrts.engine.memory.cells import Cell, cells_of
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
from vrts.engine.memory.log import Log
from vrts.engine.memory.records import INSTANT
from vrts.engine.memory.trace import Activation, Trace
from vrts.engine.motion.planner import Planner
from vrts.engine.programs.context import Context
from vrts.engine.programs.watches import Watch

Column = TypeVar("Column", "array[int]", "array[float]", "list[object]")


def forget(machines: Sequence[Machine], before_s: float) -> None:
    """Forget what was before a time [s] in machines whose own time is not before it.

    Args:
        machines: One machine and earlier copies of it; what they share they go on sharing.
        before_s: From here on everything is kept.
    """
    columns = _Columns()
    events = _Events(before_s)
    for machine in machines:
        _forget(machine, before_s, columns, events)
    obeyed = min(_obeyed_before(machine, before_s) for machine in machines)
    used = _Reached(machines).programs
    only: dict[int, tuple[Executable, Executable]] = {}  # by id: the old one, the new one
    for machine in machines:
        machine.issued = machine.issued[obeyed:]
        machine.obeyed -= obeyed
        old = machine.executable
        machine.take_over(only.setdefault(id(old), (old, old.only(used)))[1])


def forget_values(machines: Sequence[Machine], before_s: float) -> None:
    """Forget only values and statements, not what arm, hand and programs did."""
    columns = _Columns()
    for machine in machines:
        _forget_statements(machine, before_s, columns)


class _Columns:
    """Columns cut at the front, each once, for all that share it."""

    def __init__(self) -> None:
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


class _Events:
    """Logs of events without those before a time that tell nothing any more.

    Logs that share their items go on sharing: the first one shortened serves the others, if they
    are shorter by events of later times only.
    """

    def __init__(self, before_s: float) -> None:
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


def _forget(machine: Machine, before_s: float, columns: _Columns, events: _Events) -> None:
    system = machine.system
    _forget_motions(system.planner, before_s)
    _forget_hand(system.hand, before_s)
    if system.answers_read == len(system.answers):
        system.answers, system.answers_read = Log(), 0
    system.events = events.shortened(system.events)
    machine.robot.events = machine.process.events = system.events
    _forget_statements(machine, before_s, columns)


def _forget_statements(machine: Machine, before_s: float, columns: _Columns) -> None:
    tick = int(before_s / machine.tick + INSTANT / machine.tick)
    first = max(bisect_right(machine.ticks, tick) - 1, 0)
    finished = machine.counts[first] if machine.counts and machine.ticks[first] <= tick else 0
    machine.ticks = columns.without(machine.ticks, first)
    machine.counts = columns.without(machine.counts, first)
    for cell in _cells(machine):
        _forget_values(cell, finished, columns)
    for c in (machine.robot, machine.process):
        _forget_steps(c.trace, finished, columns)


def _forget_motions(planner: Planner, before_s: float) -> None:
    pieces, path_s = planner.pieces, planner.scale.path(before_s)
    del pieces[: max(bisect_right(pieces, path_s, key=lambda piece: piece.start_s) - 1, 0)]
    if pieces:
        planner.motions.forget(pieces[0].motion)
        first = planner.motions[planner.motions.first]
        planner.scale.forget(min(path_s, first.start_s))


def _obeyed_before(machine: Machine, before_s: float) -> int:
    """Return how many commands were obeyed before a time."""
    issued = machine.issued[: machine.obeyed]
    return bisect_left(issued, before_s, key=lambda timed: timed.time_s)


class _Reached:
    """Numbers of programs that machines execute, or tell of."""

    def __init__(self, machines: Sequence[Machine]) -> None:
        self.programs: set[int] = set()
        self._seen: set[int] = set()  # ids of what several of them share
        for machine in machines:
            for c in (machine.robot, machine.process):
                self._told(c.trace)
                self._executed(c.activation, c.watches, c.error_program)
            if machine.stopped is not None:
                left = machine.stopped
                self._executed(left.activation, left.watches, left.error_program)

    def _told(self, trace: Trace) -> None:
        if id(trace.activations) not in self._seen:
            self._seen.add(id(trace.activations))
            for activation in trace.activations:
                self._called(activation)

    def _executed(
        self, activation: Activation | None, watches: Sequence[Watch], error_program: int | None
    ) -> None:
        self._called(activation)
        others = (error_program, *(watch.program for watch in watches))
        self.programs.update(number for number in others if number is not None)

    def _called(self, activation: Activation | None) -> None:
        while activation is not None and id(activation) not in self._seen:
            self._seen.add(id(activation))
            self.programs.add(activation.program)
            activation = activation.caller


def _forget_hand(hand: Hand, before_s: float) -> None:
    strokes = hand.strokes
    del strokes[: max(bisect_right(strokes, before_s, key=lambda stroke: stroke.start_s) - 1, 0)]
    for track in hand.placements.values():
        del track[: max(bisect_right(track, before_s, key=lambda p: p.start_s) - 1, 0)]


def _cells(machine: Machine) -> Iterable[Cell]:
    """Return every cell of a machine, some of them more than once."""
    yield from machine.system.memory.cells()
    yield from machine.system.cells()
    for c in (machine.robot, machine.process):
        yield from _own_cells(c)
    if machine.stopped is not None:
        for frame in machine.stopped.frames:
            for slot in frame.slots:
                yield from cells_of(slot)  # type: ignore[arg-type]


def _own_cells(c: Context) -> Iterable[Cell]:
    for frame in c.frames:
        for slot in frame.slots:
            yield from cells_of(slot)


def _forget_values(cell: Cell, finished: int, columns: _Columns) -> None:
    first = bisect_right(cell.since, finished) - 1
    cell.since = columns.without(cell.since, first)
    cell.values = columns.without(cell.values, first)  # type: ignore[type-var]


def _forget_steps(trace: Trace, finished: int, columns: _Columns) -> None:
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
