"""Rotation matrices as unit quaternions."""

from typing import TypeAlias

import numpy as np
import numpy.typing as npt

Array: TypeAlias = npt.NDArray[np.float64]


def quaternions(rotations: Array) -> npt.NDArray[np.float32]:
    """Return unit quaternions x, y, z, w, shape (n, 4), from the largest part of each.

    With q = (x, y, z, w), the matrix 4 q q' follows from the rotation without a root; its row of
    the largest part is a multiple of q.
    """
    xx, xy, xz, yx, yy, yz, zx, zy, zz = rotations.reshape(-1, 9).T.copy()
    x, y, z, w = 1 + xx - yy - zz, 1 - xx + yy - zz, 1 - xx - yy + zz, 1 + xx + yy + zz
    in_xy, in_xz, in_yz = yx + xy, zx + xz, zy + yz
    of_x, of_y, of_z = zy - yz, xz - zx, yx - xy
    upper, lower = np.maximum(x, y), np.maximum(z, w)
    first, third, above = x >= y, z >= w, upper >= lower
    q = np.empty((4, len(xx)))
    for part, (of_first, of_second, of_third, of_last) in enumerate(
        (
            (x, in_xy, in_xz, of_x),
            (in_xy, y, in_yz, of_y),
            (in_xz, in_yz, z, of_z),
            (of_x, of_y, of_z, w),
        )
    ):
        one, other = np.where(first, of_first, of_second), np.where(third, of_third, of_last)
        q[part] = np.where(above, one, other)
    q /= np.sqrt((q * q).sum(axis=0))
    return np.ascontiguousarray(q.T, np.float32)
