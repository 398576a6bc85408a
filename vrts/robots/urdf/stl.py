"""Corner points of an STL mesh, binary or text."""

import re
from typing import TypeAlias

import numpy as np
import numpy.typing as npt

Array: TypeAlias = npt.NDArray[np.float64]

HEADER = 84  # bytes before the triangles of a binary file
TRIANGLE = 50  # bytes of one
MOST_TRIANGLES = 500_000

_VERTEX = re.compile(rb"vertex\s+(\S+)\s+(\S+)\s+(\S+)")


def stl_points(data: bytes) -> Array | None:
    """Return the corners of the triangles, shape (n, 3), in the unit of the file.

    None when the data is no STL, has no triangle, too many, or a corner that is not a number.
    """
    points = _binary(data)
    if points is None:
        points = _text(data)
    if points is None or not len(points) or len(points) > 3 * MOST_TRIANGLES:
        return None
    return points if bool(np.isfinite(points).all()) else None


def _binary(data: bytes) -> Array | None:
    if len(data) < HEADER:
        return None
    count = int.from_bytes(data[80:84], "little")
    if len(data) != HEADER + TRIANGLE * count:
        return None
    rows = np.frombuffer(data, np.uint8, offset=HEADER).reshape(count, TRIANGLE)
    corners = np.ascontiguousarray(rows[:, 12:48]).view("<f4")
    return corners.reshape(-1, 3).astype(np.float64)


def _text(data: bytes) -> Array | None:
    if not data.lstrip().startswith(b"solid"):
        return None
    try:
        rows = [tuple(float(word) for word in match.groups()) for match in _VERTEX.finditer(data)]
    except ValueError:
        return None
    return np.array(rows, dtype=np.float64).reshape(-1, 3)
