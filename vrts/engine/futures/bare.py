"""A machine that keeps no past, so that copies of it are cheap and memory does not grow.

Where it came from is told by what was decided on the way: from that a run with its whole past is
made again.
"""

from collections import deque
from collections.abc import Iterator
from typing import Any, Self

from vrts.engine.machine.machine import Machine
from vrts.engine.memory.cells import cells_of
from vrts.engine.memory.event_log import EventLog
from vrts.engine.memory.events import Event
from vrts.engine.memory.trace import Activation, Trace


class Nowhere(list[Any]):
    """Takes everything and keeps nothing."""

    def append(self, item: object) -> None:
        """Forget an item."""

    def pop(self, index: Any = -1) -> None:
        """Forget that an item was there."""


NOWHERE = Nowhere()
UNKEPT: deque[Any] = deque(maxlen=0)  # the same, but faster: it is never asked to give back


class NoTrace(Trace):
    """Tells nothing of the statements that were executed."""

    __slots__ = ()

    def __init__(self) -> None:
        """Keep nothing from the beginning on."""
        super().__init__()
        self.instructions = NOWHERE  # type: ignore[assignment]

    def begin_slice(self, finished: int) -> None:
        """Note nothing."""

    def rest(self, finished: int, instruction: int) -> None:
        """Note nothing."""

    def activate(self, finished: int, activation: Activation | None) -> None:
        """Note nothing."""

    def copy(self) -> Self:
        """Return itself: there is nothing to copy."""
        return self


class Fresh(EventLog):
    """What has happened since somebody last took it."""

    __slots__ = ()

    def append(self, item: Event) -> None:
        """Keep an event until it is taken."""
        self._items.append(item)
        self._length += 1

    def add(self, item: Event, number: int) -> None:
        """Keep an event until it is taken."""
        self._items.append(item)
        self._length += 1

    def not_finished(self, count: int) -> None:
        """Do nothing: it does not matter here which statement an event came with."""

    def copy(self) -> "Fresh":
        """Return an independent log."""
        other = Fresh.__new__(Fresh)
        other._items, other._length = self._items.copy(), self._length
        other._numbers, other._order, other.counted = self._numbers, self._order, self.counted
        return other

    def take(self) -> list[Event]:
        """Return what has happened, and forget it."""
        found = self._items
        self._items, self._length = [], 0
        return found


def without_past(machine: Machine) -> Machine:
    """Return a machine at the same state that has no past, and keeps none from now on."""
    other = machine.copy()
    events = Fresh()
    other.system.events = events
    for c in (other.robot, other.process):
        c.events = events
        c.trace = NoTrace()
    events.counted = other.counted
    other.ticks = other.counts = NOWHERE  # type: ignore[assignment]
    for cell in _cells(other):
        cell.since = cell.values = UNKEPT  # type: ignore[assignment]
    other.system.facts = other.system.planner.facts = None
    other.watcher.broken = "futures are told apart by others"
    return other


def _cells(machine: Machine) -> Iterator[Any]:
    yield from machine.system.memory.cells()
    yield from machine.system.cells()
    for c in (machine.robot, machine.process):
        for frame in c.frames:
            for slot in frame.slots:
                yield from cells_of(slot)
