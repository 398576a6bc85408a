"""Does a quantity of a run stay below a limit at every instant? Intervals halved until decided.

The quantity is known at the middle of an interval, with an upper bound for all of it. An interval
is settled when the bound is below the limit, or when its middle is above it [Schwarzer2005]_.
"""

from collections.abc import Callable
from typing import NamedTuple, TypeAlias

import numpy as np
import numpy.typing as npt

Array: TypeAlias = npt.NDArray[np.float64]

FINEST = 1e-5  # [s] intervals shorter than this stay open
TIMES = 1e-3  # [s] to which the first moment above a limit is found
MOST = 300_000  # intervals looked at; what is open then is undetermined

Quantity: TypeAlias = Callable[[Array, Array, Array], tuple[Array, Array]]
"""Starts, middles and ends, each (m,) [s], to values at middles and upper bounds, each (m,)."""


class Peak(NamedTuple):
    """What is known of a quantity and its limit."""

    above_s: float | None  # first moment above the limit, to 1 ms; None: no such moment was found
    open_s: float | None  # an instant at which it cannot be told
    largest: float  # largest value seen
    largest_s: float
    intervals: int


def peak(quantity: Quantity, start: Array, end: Array, limit: float) -> Peak:
    """Return whether and when a quantity exceeds a limit in intervals of time.

    Args:
        quantity: Tells value and bound.
        start: Starts of the first intervals, (n,), in s.
        end: Their ends.
        limit: Values up to here are allowed.
    """
    first, open_s = np.inf, None
    largest, largest_s, count = -np.inf, 0.0, 0
    while len(start):
        count += len(start)
        middle = 0.5 * (start + end)
        value, upper = quantity(start, middle, end)
        best = int(np.argmax(value))
        if value[best] > largest:
            largest, largest_s = float(value[best]), float(middle[best])
        above = value > limit
        if above.any():
            first = min(first, float(middle[above].min()))
        short = end - start <= np.where(np.isfinite(first), TIMES, FINEST)
        unsure = (upper > limit) & (start < first)
        if count > MOST:
            short[:] = True
        left = unsure & short & ~above
        if left.any() and open_s is None:
            open_s = float(middle[left].min())
        go_on = unsure & ~short
        start, middle, end = start[go_on], middle[go_on], end[go_on]
        start, end = np.concatenate([start, middle]), np.concatenate([middle, end])
    above_s = None if np.isinf(first) else float(first)
    return Peak(above_s, None if above_s is not None else open_s, largest, largest_s, count)


class Highest(NamedTuple):
    """The largest value of a quantity."""

    value: float  # reached; none is larger by more than what was asked for
    time_s: float
    intervals: int


def highest(quantity: Quantity, start: Array, end: Array, close: float) -> Highest:
    """Return the largest value of a quantity in intervals of time.

    Args:
        quantity: Tells value and bound.
        start: Starts of the first intervals, (n,) with n at least 1, in s.
        end: Their ends.
        close: No value is larger than the one returned by more than this, unless intervals
            become shorter than `FINEST`, or too many.
    """
    largest, largest_s, count = -np.inf, 0.0, 0
    while len(start):
        count += len(start)
        middle = 0.5 * (start + end)
        value, upper = quantity(start, middle, end)
        best = int(np.argmax(value))
        if value[best] > largest:
            largest, largest_s = float(value[best]), float(middle[best])
        go_on = (upper > largest + close) & (end - start > FINEST) & (count <= MOST)
        start, middle, end = start[go_on], middle[go_on], end[go_on]
        start, end = np.concatenate([start, middle]), np.concatenate([middle, end])
    return Highest(largest, largest_s, count)
