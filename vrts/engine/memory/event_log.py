"""Everything that happened, and beside it after how many statements."""

from collections.abc import Callable, Sequence
from itertools import islice

from vrts.engine.memory.event_order import EventOrder
from vrts.engine.memory.events import Event
from vrts.engine.memory.log import Log


def _none() -> int:
    return 0


class EventLog(Log[Event]):
    """Events in the order in which they came about.

    `numbers` are the statements finished with the one that caused an event, so that before and
    after can be told apart within a tick.
    """

    __slots__ = ("_numbers", "_order", "counted")

    def __init__(self) -> None:
        """Start empty."""
        super().__init__()
        self._numbers: list[int] = []
        self._order = EventOrder()  # copies share it, as they share the events
        self.counted: Callable[[], int] = _none  # statements, the one under way included

    @classmethod
    def of(cls, events: list[Event], numbers: list[int]) -> "EventLog":
        """Return a log that takes these lists over; as many numbers as events."""
        log = cls()
        log._items, log._length, log._numbers = events, len(events), numbers
        return log

    def append(self, item: Event) -> None:
        """Add an event of now."""
        self.add(item, self.counted())

    def add(self, item: Event, number: int) -> None:
        """Add an event that came with a number of statements."""
        if len(self._numbers) != len(self):
            self._numbers = self._numbers[: len(self)]
            self._order = EventOrder()
        self._numbers.append(number)
        super().append(item)

    def not_finished(self, count: int) -> None:
        """Take what a statement did before it began to wait for what came before it."""
        k = len(self) - 1
        while k >= 0 and self._numbers[k] > count:
            self._numbers[k] = count
            k -= 1

    @property
    def numbers(self) -> Sequence[int]:
        """Statements finished with each event, in the same order."""
        return list(islice(self._numbers, len(self)))

    @property
    def in_order(self) -> EventOrder:
        """The events in time order, to be looked at before the log or a copy of it goes on."""
        if self._order.count > len(self):  # of a copy that has gone on
            self._order = EventOrder()
        self._order.take(self._items[self._order.count : len(self)])
        return self._order

    def copy(self) -> "EventLog":
        """Return a log with the same events that can go on by itself."""
        return self.first(len(self))

    def first(self, count: int) -> "EventLog":
        """Return a copy that has the first events only."""
        other = EventLog()
        other._items, other._length = self._items, count
        other._numbers, other.counted = self._numbers, self.counted
        other._order = self._order
        return other
