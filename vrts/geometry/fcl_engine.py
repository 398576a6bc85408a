"""Distance between two convex pieces, by python-fcl: a second opinion.

The same functions as in `coal_engine`, from another code base. Discrete questions only: fcl's
continuous collision gives different answers in identical runs. Where shapes touch exactly it may
throw through C++ and end the process, so no process asks it but one that may die.
"""

from functools import lru_cache
from typing import TypeAlias

import fcl
import numpy as np
import numpy.typing as npt

from vrts.base.pose import Pose, Vector
from vrts.geometry.hull import faces
from vrts.geometry.nearest import Nearest
from vrts.geometry.shapes import Box, Cylinder, Hull, Piece, Shape

Array: TypeAlias = npt.NDArray[np.float64]

NAME = "fcl"
ERROR = 3e-4  # [m] of pieces that lie anyhow; face to face up to 36e-3, always too far


def solid(shape: Shape) -> fcl.CollisionGeometry:
    """Return fcl's form of a shape."""
    match shape:
        case Box(half_extents=(a, b, c)):
            return fcl.Box(2 * a, 2 * b, 2 * c)
        case Cylinder(radius=radius, half_length=half_length):
            return fcl.Cylinder(radius, 2 * half_length)
        case Hull(points=points):
            hull = faces(np.array(points, dtype=np.float64))
            flat = [value for polygon in hull.polygons for value in (len(polygon), *polygon)]
            return fcl.Convex(hull.vertices, len(hull.polygons), np.array(flat, dtype=np.int32))


def transform(rotation: Array, translation: Array) -> fcl.Transform:
    """Return a placement from arrays of shape (3, 3) and (3,)."""
    return fcl.Transform(rotation, translation)


def placed(X_WP: Pose) -> fcl.Transform:
    """Return a placement from a pose."""
    return fcl.Transform(np.array(X_WP.rotation).reshape(3, 3), np.array(X_WP.translation))


_REQUEST = fcl.DistanceRequest(enable_nearest_points=True, enable_signed_distance=True)


class Pair:
    """Two shapes whose distance is asked for again and again."""

    __slots__ = ("_first", "_normal", "_second")

    def __init__(self, first: Shape, second: Shape) -> None:
        """Make the two objects once."""
        self._first = fcl.CollisionObject(solid(first), fcl.Transform())
        self._second = fcl.CollisionObject(solid(second), fcl.Transform())
        self._normal = np.zeros(3)

    def distance(self, first: fcl.Transform, second: fcl.Transform) -> float:
        """Return the signed distance [m] of the shapes at two placements in one frame."""
        return self.nearest(first, second).distance

    def nearest(self, first: fcl.Transform, second: fcl.Transform) -> Nearest:
        """Return the signed distance with the points between which it is measured.

        The normal is the direction between the points; none, (0, 0, 0), where they coincide.
        """
        self._first.setTransform(first)
        self._second.setTransform(second)
        result = fcl.DistanceResult()
        distance = fcl.distance(self._first, self._second, _REQUEST, result)
        a, b = result.nearest_points
        between = b - a if distance >= 0.0 else a - b
        length = float(np.linalg.norm(between))
        self._normal = between / length if length > 0.0 else np.zeros(3)
        return Nearest(distance, _vector(a), _vector(b), _vector(self._normal))

    @property
    def normal(self) -> Array:
        """Unit normal of the last query, first to second, (3,); zero where there is none."""
        return self._normal

    def closer_than(self, first: fcl.Transform, second: fcl.Transform, margin: float) -> bool:
        """Return whether the signed distance is below a margin [m]."""
        return self.distance(first, second) < margin


@lru_cache(maxsize=65536)
def pair(first: Shape, second: Shape) -> Pair:
    """Return the `Pair` of two shapes; equal shapes share one."""
    return Pair(first, second)


def nearest(first: Piece, X_WA: Pose, second: Piece, X_WB: Pose) -> Nearest:
    """Return the signed distance of two pieces of bodies A and B, and its points in W."""
    return pair(first.shape, second.shape).nearest(
        placed(X_WA @ first.X_OP), placed(X_WB @ second.X_OP)
    )


def distance(first: Piece, X_WA: Pose, second: Piece, X_WB: Pose) -> float:
    """Return the signed distance [m] of two pieces of bodies A and B."""
    return nearest(first, X_WA, second, X_WB).distance


def _vector(values: Array) -> Vector:
    x, y, z = values.tolist()
    return (x, y, z)
