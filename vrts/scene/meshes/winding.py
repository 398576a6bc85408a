"""How often triangles go round a point, each by its share [Jacobson2013]_."""

import math
from typing import TypeAlias

import numpy as np
import numpy.typing as npt

Array: TypeAlias = npt.NDArray[np.float64]


def shares(corners: Array, point: Array) -> Array:
    """Return the share of a turn round a point that each triangle makes, shape (m,).

    The sum over a closed surface is 1 inside, where its normals point outward, and 0 outside.

    Args:
        corners: Shape (m, 3, 3).
        point: Shape (3,), in the same frame and unit.
    """
    a, b, c = (corners - point).transpose(1, 0, 2)
    la, lb, lc = (np.linalg.norm(side, axis=1) for side in (a, b, c))
    above = np.einsum("ij,ij->i", a, np.cross(b, c))
    below = la * lb * lc
    below += np.einsum("ij,ij->i", a, b) * lc
    below += np.einsum("ij,ij->i", b, c) * la + np.einsum("ij,ij->i", c, a) * lb
    return np.arctan2(above, below) / math.tau
