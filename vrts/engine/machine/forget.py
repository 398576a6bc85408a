"""The far past of machines forgotten, so that one that goes on for hours stays small.

From the time given on everything can be asked as before; earlier answers are lost.
"""

from bisect import bisect_left, bisect_right
from collections.abc import Iterable, Sequence

from vrts.engine.code.executable import Executable
from vrts.engine.hand.hand import Hand
from vrts.engine.machine.machine import Machine
from vrts.engine.memory.cells import Cell, cells_of
from vrts.engine.memory.log import Log
from vrts.engine.memory.records import INSTANT
from vrts.engine.memory.shorter import Columns, ShorterEvents, forget_steps
from vrts.engine.memory.shorter import forget_values as shorten_values
from vrts.engine.memory.trace import Activation, Trace
from vrts.engine.motion.planner import Planner
from vrts.engine.programs.context import Context
from vrts.engine.programs.watches import Watch


def forget(machines: Sequence[Machine], before_s: float) -> None:
    """Forget what was before a time [s] in machines whose own time is not before it.

    Args:
        machines: One machine and earlier copies of it; what they share they go on sharing.
        before_s: From here on everything is kept.
    """
    columns = Columns()
    events = ShorterEvents(before_s)
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
    columns = Columns()
    for machine in machines:
        _forget_statements(machine, before_s, columns)


def forget_arm_and_hand(machine: Machine, before_s: float) -> None:
    """Forget where the arm and the hand were before a time [s] that is over for the programs."""
    _forget_motions(machine.system.planner, before_s, machine.arrived)
    _forget_hand(machine.system.hand, before_s)


def _forget(machine: Machine, before_s: float, columns: Columns, events: ShorterEvents) -> None:
    system = machine.system
    forget_arm_and_hand(machine, before_s)
    if system.answers_read == len(system.answers):
        system.answers, system.answers_read = Log(), 0
    system.events = events.shortened(system.events)
    machine.robot.events = machine.process.events = system.events
    _forget_statements(machine, before_s, columns)


def _forget_statements(machine: Machine, before_s: float, columns: Columns) -> None:
    tick = int(before_s / machine.tick + INSTANT / machine.tick)
    first = max(bisect_right(machine.ticks, tick) - 1, 0)
    finished = machine.counts[first] if machine.counts and machine.ticks[first] <= tick else 0
    machine.ticks = columns.without(machine.ticks, first)
    machine.counts = columns.without(machine.counts, first)
    for cell in _cells(machine):
        shorten_values(cell, finished, columns)
    if machine.system.facts is not None:
        machine.system.facts.forget(before_s, columns)
    for c in (machine.robot, machine.process):
        forget_steps(c.trace, finished, columns)


def _forget_motions(planner: Planner, before_s: float, arrived: int) -> None:
    """Forget motions before a time, but for those whose ends were not noted yet."""
    given, path_s = planner.given, planner.scale.path(before_s)
    pieces = given.pieces
    del pieces[: max(bisect_right(pieces, path_s, key=lambda piece: piece.start_s) - 1, 0)]
    if pieces:
        given.motions.forget(min(pieces[0].motion, arrived))
        first = given.motions[given.motions.first]
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
