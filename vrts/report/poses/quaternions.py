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
    rows = np.array(
        [
            [1 + xx - yy - zz, yx + xy, zx + xz, zy - yz],
            [yx + xy, 1 - xx + yy - zz, zy + yz, xz - zx],
            [zx + xz, zy + yz, 1 - xx - yy + zz, yx - xy],
            [zy - yz, xz - zx, yx - xy, 1 + xx + yy + zz],
        ]
    )
    largest = np.argmax(np.einsum("iin->in", rows), axis=0)
    q = rows[largest, :, np.arange(len(largest))]
    return (q / np.linalg.norm(q, axis=1, keepdims=True)).astype(np.float32)
