"""Exact distance between two convex pieces, by coal.

Nothing that is told rests on it: it only proposes. Signed distances come from GJK and EPA: positive
is the gap, negative the depth of penetration. Error at most `ERROR` in all that was seen.
"""

from functools import lru_cache
from typing import TypeAlias

import coal
import numpy as np
import numpy.typing as npt

from vrts.base.pose import Pose, Vector
from vrts.geometry.nearest import Nearest
from vrts.geometry.shapes import Box, Cylinder, Hull, Piece, Shape

Array: TypeAlias = npt.NDArray[np.float64]

NAME = "coal"
ERROR = 3e-6  # [m]; largest difference seen from closed forms and other engines is 1.3e-6 m

FAILED = -1e300  # [m]; coal answers with the least number there is where it finds no depth

Transform: TypeAlias = coal.Transform3s


@lru_cache(maxsize=4096)
def solid(shape: Shape) -> coal.CollisionGeometry:
    """Return coal's form of a shape; equal shapes share one."""
    match shape:
        case Box(half_extents=(a, b, c)):
            return coal.Box(2 * a, 2 * b, 2 * c)
        case Cylinder(radius=radius, half_length=half_length):
            return coal.Cylinder(radius, 2 * half_length)
        case Hull(points=points):
            vectors = coal.StdVec_Vec3s()
            vectors.extend([np.array(point) for point in points])
            return coal.Convex.convexHull(vectors, False, "Qt")


def transform(rotation: Array, translation: Array) -> Transform:
    """Return a placement from arrays of shape (3, 3) and (3,)."""
    made = coal.Transform3s.Identity()  # a sixth of the time of finding the right constructor
    made.setTransform(rotation, translation)
    return made


def placed(X_WP: Pose) -> Transform:
    """Return a placement from a pose."""
    return transform(
        np.array(X_WP.rotation).reshape(3, 3), np.array(X_WP.translation, dtype=np.float64)
    )


_REQUEST = coal.DistanceRequest()
_REQUEST.enable_signed_distance = True


class Pair:
    """Two shapes whose distance is asked for again and again."""

    __slots__ = ("_compute", "_result", "_solids")

    def __init__(self, first: Shape, second: Shape) -> None:
        """Choose the algorithm for two shapes once."""
        self._solids = (solid(first), solid(second))  # coal keeps bare pointers to them
        self._compute = coal.ComputeDistance(*self._solids)
        self._result = coal.DistanceResult()

    def distance(self, first: Transform, second: Transform) -> float:
        """Return the signed distance [m] of the shapes at two placements in one frame."""
        self._result.clear()
        distance = self._compute(first, second, _REQUEST, self._result)
        if distance < FAILED:
            found = self._other_way(first, second)
            self._result.normal = np.array(found.normal)
            return found.distance
        return distance

    def _other_way(self, first: Transform, second: Transform) -> Nearest:
        """Return what is measured from the second shape to the first.

        Where edges touch that are parallel but for rounding, coal gives up in one order. Should it
        in both, its answer stays: deep overlap, so that no contact is missed.
        """
        result = coal.DistanceResult()
        compute = coal.ComputeDistance(self._solids[1], self._solids[0])
        distance = compute(second, first, _REQUEST, result)
        return Nearest(
            distance,
            _vector(result.getNearestPoint2()),
            _vector(result.getNearestPoint1()),
            _vector(-result.normal),
        )

    @property
    def normal(self) -> Array:
        """Unit normal of the last query, first to second, (3,). The next query overwrites it."""
        return self._result.normal

    def nearest(self, first: Transform, second: Transform) -> Nearest:
        """Return the signed distance with the points between which it is measured."""
        result = self._result
        result.clear()
        distance = self._compute(first, second, _REQUEST, result)
        if distance < FAILED:
            return self._other_way(first, second)
        return Nearest(
            distance,
            _vector(result.getNearestPoint1()),
            _vector(result.getNearestPoint2()),
            _vector(result.normal),
        )

    def told_into(
        self, first: Transform, second: Transform, normal: Array, a: Array, b: Array
    ) -> None:
        """Write the normal and the points of `nearest` into rows of arrays, each of shape (3,)."""
        result = self._result
        result.clear()
        if self._compute(first, second, _REQUEST, result) < FAILED:
            found = self._other_way(first, second)
            normal[:], a[:], b[:] = found.normal, found.first, found.second
            return
        normal[:], a[:], b[:] = result.normal, result.getNearestPoint1(), result.getNearestPoint2()

    def closer_than(self, first: Transform, second: Transform, margin: float) -> bool:
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
    return pair(first.shape, second.shape).distance(
        placed(X_WA @ first.X_OP), placed(X_WB @ second.X_OP)
    )


def _vector(values: Array) -> Vector:
    x, y, z = values.tolist()
    return (x, y, z)
