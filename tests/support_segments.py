"""Segments of any degree made by hand: blends, and motions slowed down inside of them."""

import math
from collections.abc import Sequence

import numpy as np
import numpy.typing as npt

from vrts.engine.memory.records import Segment

Array = npt.NDArray[np.float64]
Row = tuple[float, ...]


def blend(start: float, before: float, after: float, duration: float) -> Row:
    """A quartic that goes over from one velocity to another with no acceleration at both ends."""
    change = after - before
    return (start, before, 0.0, change / duration**2, -change / (2.0 * duration**3))


def slowed(row: Sequence[float], rate: float, change: float) -> Row:
    """The same path under time that passes at a rate which changes steadily: row(s(t)).

    Args:
        row: In powers of s.
        rate: ds/dt at the start.
        change: d2s/dt2 [1/s].
    """
    inner = np.polynomial.Polynomial([0.0, rate, 0.5 * change])
    found = np.polynomial.Polynomial(row)(inner)
    coefficients: list[float] = found.coef.tolist()
    return tuple(coefficients)


def sampled(row: Sequence[float], times: Array, order: int = 0) -> Array:
    """A polynomial or a derivative at times; by another way than the code under test."""
    found = np.zeros_like(times)
    for power, c in enumerate(row):
        if power >= order:
            found += c * math.perm(power, order) * times ** (power - order)
    return found


def segment(*rows: Row, start_s: float = 0.0, length: float = 1.0) -> Segment:
    """A segment of motion 0 in which coordinates without a row stand still at 0.1."""
    still = (0.1,)
    return Segment(start_s, start_s + length, (*rows, *(still,) * (7 - len(rows))), 0)
