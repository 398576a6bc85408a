"""When is everything that a via point asks for true at once? Intervals halved until decided.

The distance of tool and point changes by no more than the tool can move, and the tool's direction
and speed are bounded alike. So an interval in which one of them must be wrong is closed at once,
one in which all must be right is a visit, and others are halved [Schwarzer2005]_.
"""

import math
from collections.abc import Sequence
from typing import NamedTuple, TypeAlias

import numpy as np
import numpy.typing as npt

from vrts.check.curves.tool_motion import Bounded

Array: TypeAlias = npt.NDArray[np.float64]
Interval: TypeAlias = tuple[float, float]

SHORT = 1e-4  # [s] to which the ends of visits are found
FINEST = 1e-5  # [s] intervals are not halved below this
MOST = 300_000  # intervals looked at; what is open then cannot be told


class Wanted(NamedTuple):
    """A quantity that must not be above a limit."""

    quantity: Bounded
    limit: float  # with what measurements are rounded to
    close: float  # where it is never kept, the smallest value is known to this


class Found(NamedTuple):
    """What is known of a via point."""

    sure: tuple[Interval, ...]  # all is true at an instant of each [s], in time order
    open: tuple[Interval, ...]  # it cannot be told
    least: float  # smallest value seen of the last quantity, where the others are right; within
    # `close` of the smallest there is, if nothing is sure
    least_s: float  # when; nan where the others never are


def search(wanted: Sequence[Wanted], start: Array, end: Array) -> Found:
    """Return when every quantity is within its limit.

    Args:
        wanted: Quantities; of the last, the smallest value is looked for as well.
        start: Starts of the first intervals, (n,), in s.
        end: Their ends.
    """
    sure: list[Interval] = []
    doubtful: list[Interval] = []
    least, least_s, count = math.inf, math.nan, 0
    while len(start):
        count += len(start)
        middle = 0.5 * (start + end)
        others, certain = np.ones(len(start), dtype=bool), np.ones(len(start), dtype=bool)
        possible = np.ones(len(start), dtype=bool)
        for want in wanted[:-1]:
            value, change = want.quantity(start, middle, end)
            others &= value <= want.limit
            certain &= value + change <= want.limit
            possible &= value - change <= want.limit
        last = wanted[-1]
        value, change = last.quantity(start, middle, end)
        told = np.where(others, value, np.inf)
        best = int(np.argmin(told))
        if told[best] < least:
            least, least_s = float(told[best]), float(middle[best])
        length = end - start
        true = others & (value <= last.limit)
        inside = (certain & (value + change <= last.limit)) | (true & (length <= SHORT))
        sure += zip(start[inside].tolist(), end[inside].tolist(), strict=True)
        unsure = possible & (value - change <= last.limit) & ~inside
        finest = length <= (FINEST if count <= MOST else math.inf)
        left = unsure & finest
        doubtful += zip(start[left].tolist(), end[left].tolist(), strict=True)
        nearer = possible & (value - change <= least - last.close) & (length > SHORT)
        go_on = (unsure if sure else unsure | nearer) & ~finest
        start, middle, end = start[go_on], middle[go_on], end[go_on]
        start, end = np.concatenate([start, middle]), np.concatenate([middle, end])
    visits = _merged(sure)
    return Found(visits, _apart(_merged(doubtful), visits), least, least_s)


def _merged(intervals: list[Interval]) -> tuple[Interval, ...]:
    merged: list[Interval] = []
    for begin, finish in sorted(intervals):
        if merged and begin <= merged[-1][1] + 2 * SHORT:
            merged[-1] = (merged[-1][0], max(merged[-1][1], finish))
        else:
            merged.append((begin, finish))
    return tuple(merged)


def _apart(doubtful: tuple[Interval, ...], sure: tuple[Interval, ...]) -> tuple[Interval, ...]:
    """Return the intervals that are not merely the border of a visit."""
    return tuple(
        (begin, finish)
        for begin, finish in doubtful
        if not any(begin <= b + 2 * SHORT and finish >= a - 2 * SHORT for a, b in sure)
    )
