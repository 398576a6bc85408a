"""Stretches of a text, and whether one of them holds another: for many at once."""

from bisect import bisect_right
from collections.abc import Iterable
from itertools import accumulate


class Stretches:
    """Stretches from a start to an end, which may lie in each other."""

    def __init__(self, stretches: Iterable[tuple[int, int]]) -> None:
        """Take them in any order."""
        known = sorted(stretches)
        self._starts = [start for start, _ in known]
        self._farthest = list(accumulate((end for _, end in known), max))

    def hold(self, start: int, end: int) -> bool:
        """Return whether a stretch lies in one of them, or in some that lie in each other."""
        before = bisect_right(self._starts, start)
        return before > 0 and end <= self._farthest[before - 1]
