"""How far convex shapes reach in a direction, in plain Python.

The controller asks these questions at single instants (grasp, falling), so they need no numpy. The
signed distance of two convex shapes is the largest gap over all directions; each of these
functions gives one such gap exactly.
"""

import math
from collections.abc import Iterable, Sequence
from typing import NamedTuple

from vrts.base.pose import Pose, Rotation, Vector, dot, rotate, transpose
from vrts.geometry.shapes import Box, Cylinder, Hull, Piece, Shape

MOST_BOXES = 4096  # things whose boxes are kept, each where it was


class Interval(NamedTuple):
    """A range of lengths along a direction."""

    lower: float  # [m]
    upper: float  # [m]

    @property
    def length(self) -> float:
        """Upper minus lower end [m]."""
        return self.upper - self.lower

    def overlap(self, other: "Interval") -> float:
        """Return the common length with another interval; negative is the gap between them [m]."""
        return min(self.upper, other.upper) - max(self.lower, other.lower)


class Bounds(NamedTuple):
    """A box along the axes of a frame that holds shapes."""

    lower: Vector  # [m]
    upper: Vector  # [m]


def farthest(shape: Shape, direction: Vector) -> Vector:
    """Return a point of a shape that lies farthest in a direction, both in the shape's frame [m].

    The direction need not have unit length. Where a whole edge or face lies farthest, one of its
    points is returned: a corner of a box or hull, the middle of a cylinder's side or cap.
    """
    x, y, z = direction
    match shape:
        case Box(half_extents=(a, b, c)):
            return (math.copysign(a, x), math.copysign(b, y), math.copysign(c, z))
        case Cylinder(radius=radius, half_length=half_length):
            radial = math.hypot(x, y)
            along = 0.0 if z == 0.0 else math.copysign(half_length, z)
            if radial <= 1e-12 * abs(z):
                return (0.0, 0.0, along)
            return (radius * x / radial, radius * y / radial, along)
        case Hull(points=points):
            return max(points, key=lambda point: dot(point, direction))


def support(piece: Piece, X_WO: Pose, direction: Vector) -> Vector:
    """Return a point of a piece that lies farthest in a direction, both in W [m]."""
    X_WP = X_WO @ piece.X_OP
    return X_WP.apply(farthest(piece.shape, rotate(transpose(X_WP.rotation), direction)))


def reach(shape: Shape, direction: Vector) -> float:
    """Return the largest scalar product of a point of a shape with a direction.

    The direction is in the shape's frame; for a unit vector the result is a length in m.
    """
    x, y, z = direction
    match shape:
        case Box(half_extents=(a, b, c)):
            return a * abs(x) + b * abs(y) + c * abs(z)
        case Cylinder(radius=radius, half_length=half_length):
            return radius * math.hypot(x, y) + half_length * abs(z)
        case Hull(points=points):
            return max([x * px + y * py + z * pz for px, py, pz in points])


def span(shape: Shape, direction: Vector) -> tuple[float, float]:
    """Return the smallest and the largest scalar product of points of a shape with a direction."""
    match shape:
        case Hull(points=points):
            x, y, z = direction
            products = [x * px + y * py + z * pz for px, py, pz in points]
            return min(products), max(products)
        case _:  # symmetric
            largest = reach(shape, direction)
            return -largest, largest


def extent(piece: Piece, X_WO: Pose, direction: Vector) -> Interval:
    """Return the range that a piece covers along a unit vector of W, measured from W's origin."""
    X_WP = X_WO @ piece.X_OP
    local = rotate(transpose(X_WP.rotation), direction)
    offset = dot(X_WP.translation, direction)
    lower, upper = span(piece.shape, local)
    return Interval(offset + lower, offset + upper)


def extent_of(pieces: Iterable[Piece], X_WO: Pose, direction: Vector) -> Interval:
    """Return the range that a union of pieces covers along a unit vector of W.

    Raises:
        ValueError: There are no pieces.
    """
    extents = [extent(piece, X_WO, direction) for piece in pieces]
    return Interval(min(e.lower for e in extents), max(e.upper for e in extents))


def half_box(shape: Shape, rotation: Rotation) -> tuple[Vector, Vector]:
    """Return the lower and upper corner of the box along W's axes round a turned shape [m].

    Args:
        shape: In its frame P.
        rotation: Orientation of P in W; the corners are relative to P's origin.
    """
    rows = (rotation[0:3], rotation[3:6], rotation[6:9])
    (ax, bx), (ay, by), (az, bz) = [span(shape, row) for row in rows]
    return (ax, ay, az), (bx, by, bz)


def boxes_of(pieces: Sequence[Piece], X_WO: Pose) -> Sequence[Bounds]:
    """Return the box along the axes of W round each piece; what stands is asked about again."""
    key = id(pieces), X_WO
    known = _boxes.get(key)
    if known is None:
        if len(_boxes) >= MOST_BOXES:
            _boxes.clear()
        known = _boxes[key] = pieces, [_box(piece, X_WO) for piece in pieces]
    return known[1]


# by who the pieces are, and these are kept, lest others take the place of some that are gone
_boxes: dict[tuple[int, Pose], tuple[Sequence[Piece], list[Bounds]]] = {}


def _box(piece: Piece, X_WO: Pose) -> Bounds:
    X_WP = X_WO @ piece.X_OP
    lower, upper = half_box(piece.shape, X_WP.rotation)
    x, y, z = X_WP.translation
    return Bounds(
        (lower[0] + x, lower[1] + y, lower[2] + z), (upper[0] + x, upper[1] + y, upper[2] + z)
    )


def bounds(pieces: Iterable[Piece], X_WO: Pose) -> Bounds:
    """Return the smallest box along the axes of W that holds a union of pieces.

    Raises:
        ValueError: There are no pieces.
    """
    found = [_box(piece, X_WO) for piece in pieces]
    if not found:
        raise ValueError("no pieces")
    lowers, uppers = zip(*found, strict=True)
    return Bounds(
        (min(v[0] for v in lowers), min(v[1] for v in lowers), min(v[2] for v in lowers)),
        (max(v[0] for v in uppers), max(v[1] for v in uppers), max(v[2] for v in uppers)),
    )
