"""What changes now and then, also between statements: every change with its time.

Copies of a machine share tracks: entries later than a copy are another future's, until `cut`.
"""

from array import array
from bisect import bisect_left, bisect_right
from typing import Generic, TypeVar

from vrts.engine.memory.records import INSTANT
from vrts.engine.memory.shorter import Columns

Value = TypeVar("Value")


class Track(Generic[Value]):
    """Changes in order: when, with how many statements, the one under way included, to what."""

    __slots__ = ("numbers", "times", "values")

    def __init__(self, values: "list[Value] | array[float] | array[int]") -> None:
        """Take a list, or an array of numbers, without any changes yet."""
        self.times = array("d")  # [s]
        self.numbers = array("I")
        self.values = values

    def note(self, time_s: float, number: int, value: Value) -> None:
        """Note a change."""
        self.times.append(time_s)
        self.numbers.append(number)
        self.values.append(value)  # type: ignore[arg-type]

    def turn(self, time_s: float, number: int, value: Value) -> None:
        """Note what holds now, if it is another than before."""
        if not self.values or self.values[-1] != value:
            self.note(time_s, number, value)

    def count(self, time_s: float, finished: int) -> int:
        """Return how many changes there were at a time, when so many statements are finished.

        Of those in the same tick, the ones count that came with a statement that is finished.
        """
        k = bisect_right(self.times, time_s)
        if k and self.numbers[k - 1] > finished:
            earlier = bisect_left(self.times, time_s - INSTANT)
            while k > earlier and self.numbers[k - 1] > finished:
                k -= 1
        return k

    def at(self, time_s: float, finished: int) -> Value | None:
        """Return what held then; None before the first change."""
        k = self.count(time_s, finished)
        return self.values[k - 1] if k else None  # type: ignore[return-value]

    def cut(self, time_s: float) -> "Track[Value]":
        """Return a track of its own, without what came later than a time [s]."""
        kept = bisect_right(self.times, time_s + INSTANT)
        other: Track[Value] = Track(self.values[:kept])
        other.times, other.numbers = self.times[:kept], self.numbers[:kept]
        return other

    def shorter(self, before_s: float, columns: Columns) -> "Track[Value]":
        """Return a track from the last change before a time [s] on; what is shared stays so."""
        first = bisect_right(self.times, before_s - INSTANT) - 1
        if first <= 0:
            return self
        other: Track[Value] = Track(columns.without(self.values, first))  # type: ignore[arg-type]
        other.times = columns.without(self.times, first)
        other.numbers = columns.without(self.numbers, first)
        return other
