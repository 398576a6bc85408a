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
    size = 2
    while size <= LONGEST:
        ends = np.arange(0, len(times), size)
        inner = ends[:-1, None] + np.arange(1, size)
        if not inner.size:
            break
        start, end = ends[:-1], ends[1:]
        share = (times[inner] - times[start, None]) / (times[end] - times[start])[:, None]
        line = values[start, None] + share[:, :, None] * (values[end] - values[start])[:, None]
        straight = (np.abs(values[inner] - line) <= tolerance).all(axis=(1, 2))
        keep[inner[straight]] = False
        size *= 2
    return keep
