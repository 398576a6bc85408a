"""What a convex piece covers when it is looked at along an axis: drawings and support polygons."""

import math
from collections.abc import Iterable, Sequence
from itertools import product
from typing import TypeAlias

from vrts.base.pose import Pose, Vector, dot
from vrts.geometry.shapes import Box, Cylinder, Hull, Piece

Point: TypeAlias = tuple[float, float]  # [m]
Polygon: TypeAlias = tuple[Point, ...]  # convex, counter-clockwise

SIDES = 64  # of the polygon drawn for a circle; its corners lie on the circle


def outline(pieces: Iterable[Piece], X_WO: Pose, right: Vector, up: Vector) -> Polygon:
    """Return the convex outline of pieces of a body O, seen along right x up.

    Args:
        pieces: In O. One piece gives its exact outline, several their common hull.
        X_WO: Pose of the body.
        right: Unit vector of W that points right in the picture.
        up: Unit vector of W that points up in the picture.
    """
    points: list[Point] = []
    for piece in pieces:
        X_WP = X_WO @ piece.X_OP
        for corner in corners(piece):
            at = X_WP.apply(corner)
            points.append((dot(at, right), dot(at, up)))
    return hull(points)


def plan(pieces: Iterable[Piece], X_WO: Pose) -> Polygon:
    """Return the outline of pieces seen from above: x to the right, y up."""
    return outline(pieces, X_WO, (1.0, 0.0, 0.0), (0.0, 1.0, 0.0))


def corners(piece: Piece) -> Sequence[Vector]:
    """Return points of a piece, in its own frame, whose hull is the piece [m]."""
    match piece.shape:
        case Box(half_extents=(a, b, c)):
            return [(x * a, y * b, z * c) for x, y, z in product((-1, 1), repeat=3)]
        case Cylinder(radius=radius, half_length=half_length):
            turns = [math.tau * number / SIDES for number in range(SIDES)]
            return [
                (radius * math.cos(turn), radius * math.sin(turn), end * half_length)
                for turn in turns
                for end in (-1, 1)
            ]
        case Hull(points=points):
            return points


def hull(points: Iterable[Point]) -> Polygon:
    """Return the convex hull of points in a plane (monotone chain)."""
    ordered = sorted({(round(x, 9), round(y, 9)) for x, y in points})
    if len(ordered) < 3:
        return tuple(ordered)
    lower = _chain(ordered)
    upper = _chain(ordered[::-1])
    return (*lower[:-1], *upper[:-1])


def contains(polygon: Polygon, point: Point, *, slack: float = 0.0) -> bool:
    """Return whether a point lies in a polygon widened by `slack` [m]."""
    if len(polygon) < 3:
        return False
    x, y = point
    for (ax, ay), (bx, by) in zip(polygon, (*polygon[1:], polygon[0]), strict=True):
        length = math.hypot(bx - ax, by - ay)
        if (bx - ax) * (y - ay) - (by - ay) * (x - ax) < -slack * length:
            return False
    return True


def _chain(ordered: Sequence[Point]) -> list[Point]:
    chain: list[Point] = []
    for point in ordered:
        while len(chain) > 1 and _turn(chain[-2], chain[-1], point) <= 0.0:
            chain.pop()
        chain.append(point)
    return chain


def _turn(a: Point, b: Point, c: Point) -> float:
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
