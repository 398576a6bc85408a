"""How far pairs of solids are apart at least, by the boxes round them."""

from typing import TypeAlias

import numpy as np
import numpy.typing as npt

from vrts.geometry.solids import Places

Array: TypeAlias = npt.NDArray[np.float64]
Indices: TypeAlias = npt.NDArray[np.int64]


def outside(places: Places, a: Indices, b: Indices) -> Array:
    """Return a lower bound on signed distances, (r,), from the boxes along the axes.

    Boxes that overlap say little: the shapes in them cannot overlap deeper than the boxes do.
    """
    square = np.zeros(len(a))
    widest = np.full(len(a), -np.inf)
    for axis in range(3):
        centre = np.ascontiguousarray(places.centres[:, axis])
        half = np.ascontiguousarray(places.halves[:, axis])
        gap = np.abs(centre[a] - centre[b])
        gap -= half[a]
        gap -= half[b]
        np.maximum(widest, gap, out=widest)
        np.maximum(gap, 0.0, out=gap)
        gap *= gap
        square += gap
    return np.where(widest > 0.0, np.sqrt(square), widest)
