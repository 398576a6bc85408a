"""The distance of two shapes, proven, in plain Python: for single questions and a few at a time.

Points x of A and y of B are found whose distance is an upper bound, and a direction n along which
A and B are apart by a lower bound [GJK1988]_; where the shapes overlap, by `polytope`. It starts
from the shapes' own frames unless told otherwise, so the same question has the same answer, bit
for bit, whoever asks.
"""

import math
from typing import NamedTuple

from vrts.base.pose import Pose, Vector, distance, scale, subtract
from vrts.geometry.proving.placed import Support, placed
from vrts.geometry.proving.polytope import corner, depth
from vrts.geometry.proving.simplex import Corner
from vrts.geometry.proving.simplex import nearest as nearest_of
from vrts.geometry.shapes import Piece, Shape

TIGHT = 1e-9  # [m] bounds this near to each other are one distance
MOST = 64  # steps; boxes need less than ten
TOUCHING = 1e-9  # [m] nearer than this the direction between two points means nothing


class Proven(NamedTuple):
    """What is known for certain of two shapes, up to rounding."""

    lower: float  # they are at least so far apart; below zero they overlap at most so deep [m]
    upper: float  # and at most so far apart; below zero they overlap at least so deep [m]
    first: Vector  # point of A: nearest to B, or deepest in it [m]
    second: Vector  # point of B
    normal: Vector  # unit vector, A to B, along which `lower` holds

    @property
    def distance(self) -> float:
        """The signed distance, known to `error` [m]."""
        return 0.5 * (self.lower + self.upper)

    @property
    def error(self) -> float:
        """By how much `distance` may be wrong [m]."""
        return 0.5 * (self.upper - self.lower)


def nearest(first: Piece, X_WA: Pose, second: Piece, X_WB: Pose, *, tight: float = TIGHT) -> Proven:
    """Return the signed distance of two pieces of bodies A and B, with points in W.

    Args:
        first: Piece of A.
        X_WA: Where A is.
        second: Piece of B.
        X_WB: Where B is.
        tight: Bounds this near to each other are near enough [m].
    """
    return between(first.shape, X_WA @ first.X_OP, second.shape, X_WB @ second.X_OP, tight=tight)


def between(
    first: Shape,
    X_WA: Pose,
    second: Shape,
    X_WB: Pose,
    *,
    tight: float = TIGHT,
    start: Vector | None = None,
) -> Proven:
    """Return the signed distance of two shapes, each in its own frame; see `nearest`.

    Args:
        first: A.
        X_WA: Its frame in W.
        second: B.
        X_WB: Its frame in W.
        tight: Bounds this near to each other are near enough [m].
        start: Direction to begin with, A to B; the answer is as right with any.
    """
    way = subtract(X_WB.translation, X_WA.translation) if start is None else start
    length = math.hypot(*way)
    unit = scale(way, 1.0 / length) if 1e-12 < length < math.inf else (0.0, 0.0, 1.0)
    return of_supports(placed(first, X_WA), placed(second, X_WB), unit, tight)


def of_supports(
    a: Support,
    b: Support,
    start: Vector,
    tight: float,
    *,
    apart: float = math.inf,
    deep: float = -math.inf,
) -> Proven:
    """Return the signed distance of shapes of which only the supports are known.

    Args:
        a: Of A.
        b: Of B.
        start: Unit vector.
        tight: Bounds this near to each other are near enough [m].
        apart: A lower bound of so much is enough, however far the upper one is [m].
        deep: So is an upper bound of so little [m].
    """
    way = start
    corners: list[Corner] = []
    lower, upper, normal = -math.inf, math.inf, start
    points = (0.0, 0.0, 0.0), (0.0, 0.0, 0.0)
    overlap = False
    for _ in range(MOST):
        far = corner(a, b, (-way[0], -way[1], -way[2]))
        gap = far.x * way[0] + far.y * way[1] + far.z * way[2]
        if gap > lower:
            lower, normal = gap, way
        if upper - lower <= tight or lower >= apart:
            break
        found = nearest_of([*corners, far])
        corners = [*found.corners]
        point = found.point
        size = math.hypot(*point)
        if size >= upper:  # rounding allows no more
            break
        upper, points = size, found.points
        overlap = len(corners) == 4 or size <= TOUCHING
        if overlap:
            break
        way = (point[0] / size, point[1] / size, point[2] / size)
    if upper - lower > tight and lower < apart and (overlap or lower <= 0.0):
        inner = depth(a, b, corners, tight, deep)
        if inner is not None:
            if inner.lower > lower:
                lower, normal = inner.lower, inner.normal
            if inner.upper < upper:
                upper, points = inner.upper, (inner.first, inner.second)
    if 0.0 <= upper < math.inf:
        upper = distance(*points)
    return Proven(min(lower, upper), upper, *points, normal)
