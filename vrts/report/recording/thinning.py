"""Which rows of curves are enough, where straight lines are drawn between them."""

from typing import TypeAlias

import numpy as np
import numpy.typing as npt

from vrts.report.recording.names import Array

Mask: TypeAlias = npt.NDArray[np.bool_]

LONGEST = 8  # steps from one row to the next


def bends(times: Array, values: Array, tolerance: float) -> Mask:
    """Return the rows to keep, shape (n,): straight lines between them are nowhere farther off.

    Stretches of 2, 4, 8, ... rows are tried, each of which begins where a shorter one does. Of one
    that the line between its ends is near enough to, the rows between are left out.

    Args:
        times: Increasing, shape (n,) [s].
        values: Shape (n, k).
        tolerance: In the unit of the values.
    """
    keep = np.ones(len(times), np.bool_)
    curves = np.ascontiguousarray(values.T)
    size = 2
    while size <= LONGEST:
        count = (len(times) - 1) // size
        if not count:
            break
        rows = slice(0, count * size + 1, size)
        start_s, start = times[rows], curves[:, rows]
        length_s, rise = np.diff(start_s), np.diff(start)
        start_s, start = start_s[:-1], start[:, :-1]
        straight = np.ones(count, np.bool_)
        for k in range(1, size):
            inner = slice(k, count * size, size)
            line = start + (times[inner] - start_s) / length_s * rise
            straight &= (np.abs(curves[:, inner] - line) <= tolerance).all(axis=0)
        keep[: count * size].reshape(count, size)[straight, 1:] = False
        size *= 2
    return keep
