"""Random shapes at random places, some of them exactly where rounding hurts most."""

import math

import numpy as np
import numpy.typing as npt

from vrts.base.pose import Pose, Rotation
from vrts.geometry.shapes import Box, Cylinder, Hull, Shape


def rotation(chance: np.random.Generator) -> Rotation:
    """Return a random rotation."""
    w, x, y, z = (q := chance.normal(size=4)) / np.linalg.norm(q)
    rows = (
        (1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)),
        (2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)),
        (2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)),
    )
    return tuple(float(v) for row in rows for v in row)  # type: ignore[return-value]


def shape(chance: np.random.Generator) -> Shape:
    """Return a random box, cylinder or hull, up to 0.4 m large."""
    match int(chance.integers(3)):
        case 0:
            a, b, c = chance.uniform(0.005, 0.2, 3).tolist()
            return Box((a, b, c))
        case 1:
            radius, half_length = chance.uniform(0.005, 0.2, 2).tolist()
            return Cylinder(radius, half_length)
        case _:
            points = chance.normal(size=(int(chance.integers(5, 40)), 3))
            points *= chance.uniform(0.01, 0.15)
            return Hull(tuple((x, y, z) for x, y, z in points.tolist()))


def corners(of: Shape, X_WP: Pose) -> npt.NDArray[np.float64]:
    """Return the corners of a box or hull in W, shape (n, 3)."""
    match of:
        case Box(half_extents=(a, b, c)):
            points = [(i * a, j * b, k * c) for i in (-1, 1) for j in (-1, 1) for k in (-1, 1)]
        case Hull(points=own):
            points = list(own)
        case Cylinder():
            raise ValueError("round")
    return np.array([X_WP.apply(point) for point in points])


def pose(chance: np.random.Generator, spread: float = 0.2) -> Pose:
    """Return a random pose, its origin within a cube."""
    x, y, z = chance.uniform(-spread, spread, 3).tolist()
    return Pose(rotation(chance), (x, y, z))


def turned(angle: float) -> Rotation:
    """Return a turn about z [rad]."""
    c, s = math.cos(angle), math.sin(angle)
    return (c, -s, 0.0, s, c, 0.0, 0.0, 0.0, 1.0)
