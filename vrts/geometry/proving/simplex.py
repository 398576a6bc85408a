"""The point of a simplex that is nearest to the origin, in plain Python.

A simplex is up to four points of the difference of two shapes; each remembers the points of the
shapes that it comes from. Weights are those of a convex combination whatever the rounding, so a
point made with them lies inside.
"""

import math
from collections.abc import Sequence
from typing import NamedTuple

from vrts.base.pose import Vector


class Corner(NamedTuple):
    """A point y - x of the difference of two shapes A and B."""

    x: float
    y: float
    z: float
    first: Vector  # x, of A
    second: Vector  # y, of B


class Nearest(NamedTuple):
    """A convex combination of corners, all of weight above zero."""

    corners: tuple[Corner, ...]
    weights: tuple[float, ...]

    @property
    def point(self) -> Vector:
        """The combination itself."""
        x = y = z = 0.0
        for corner, weight in zip(self.corners, self.weights, strict=True):
            x += weight * corner.x
            y += weight * corner.y
            z += weight * corner.z
        return (x, y, z)

    @property
    def points(self) -> tuple[Vector, Vector]:
        """The same combination of the points of A, and of those of B."""
        return (
            _mixed([corner.first for corner in self.corners], self.weights),
            _mixed([corner.second for corner in self.corners], self.weights),
        )


def nearest(corners: Sequence[Corner]) -> Nearest:
    """Return the point of the hull of one to four corners that is nearest to the origin."""
    match len(corners):
        case 1:
            return Nearest((corners[0],), (1.0,))
        case 2:
            return _of_edge(corners[0], corners[1])
        case 3:
            return of_triangle(corners[0], corners[1], corners[2])
        case _:
            return _of_tetrahedron(corners[0], corners[1], corners[2], corners[3])


def _mixed(points: Sequence[Vector], weights: Sequence[float]) -> Vector:
    return (
        math.fsum([w * p[0] for w, p in zip(weights, points, strict=True)]),
        math.fsum([w * p[1] for w, p in zip(weights, points, strict=True)]),
        math.fsum([w * p[2] for w, p in zip(weights, points, strict=True)]),
    )


def _of_edge(a: Corner, b: Corner) -> Nearest:
    x, y, z = b.x - a.x, b.y - a.y, b.z - a.z
    along = -(a.x * x + a.y * y + a.z * z)
    if along <= 0.0:
        return Nearest((a,), (1.0,))
    square = x * x + y * y + z * z
    if along >= square:
        return Nearest((b,), (1.0,))
    t = along / square
    return Nearest((a, b), (1.0 - t, t))


def of_triangle(a: Corner, b: Corner, c: Corner) -> Nearest:
    """Return the point of a triangle that is nearest to the origin: by its regions.

    [Ericson2005]_, section 5.1.5.
    """
    ax, ay, az = a.x, a.y, a.z
    ux, uy, uz = b.x - ax, b.y - ay, b.z - az
    vx, vy, vz = c.x - ax, c.y - ay, c.z - az
    d1 = -(ux * ax + uy * ay + uz * az)
    d2 = -(vx * ax + vy * ay + vz * az)
    if d1 <= 0.0 and d2 <= 0.0:
        return Nearest((a,), (1.0,))
    d3 = -(ux * b.x + uy * b.y + uz * b.z)
    d4 = -(vx * b.x + vy * b.y + vz * b.z)
    if d3 >= 0.0 and d4 <= d3:
        return Nearest((b,), (1.0,))
    vc = d1 * d4 - d3 * d2
    if vc <= 0.0 and d1 >= 0.0 and d3 <= 0.0:
        return _of_edge(a, b)
    d5 = -(ux * c.x + uy * c.y + uz * c.z)
    d6 = -(vx * c.x + vy * c.y + vz * c.z)
    if d6 >= 0.0 and d5 <= d6:
        return Nearest((c,), (1.0,))
    vb = d5 * d2 - d1 * d6
    if vb <= 0.0 and d2 >= 0.0 and d6 <= 0.0:
        return _of_edge(a, c)
    va = d3 * d6 - d5 * d4
    if va <= 0.0 and d4 - d3 >= 0.0 and d5 - d6 >= 0.0:
        return _of_edge(b, c)
    whole = va + vb + vc
    if not (whole > 0.0 and va > 0.0 and vb > 0.0 and vc > 0.0):  # thin beyond rounding
        return _best([_of_edge(a, b), _of_edge(a, c), _of_edge(b, c)])
    return Nearest((a, b, c), (va / whole, vb / whole, vc / whole))


def _of_tetrahedron(a: Corner, b: Corner, c: Corner, d: Corner) -> Nearest:
    """Return the origin where the corners hold it, else the nearest of the four triangles."""
    abc, abd = _volume(a, b, c), _volume(a, d, b)
    acd, bdc = _volume(a, c, d), _volume(b, d, c)
    whole = abc + abd + acd + bdc
    volumes = (bdc, acd, abd, abc)  # opposite to a, b, c, d
    if whole != 0.0 and all(volume / whole > 0.0 for volume in volumes):
        return Nearest((a, b, c, d), (bdc / whole, acd / whole, abd / whole, abc / whole))
    return _best(
        [of_triangle(a, b, c), of_triangle(a, b, d), of_triangle(a, c, d), of_triangle(b, c, d)]
    )


def _volume(a: Corner, b: Corner, c: Corner) -> float:
    """Return six times the volume of a triangle and the origin, with a sign."""
    return (
        a.x * (b.y * c.z - b.z * c.y)
        + a.y * (b.z * c.x - b.x * c.z)
        + a.z * (b.x * c.y - b.y * c.x)
    )


def _best(found: Sequence[Nearest]) -> Nearest:
    return min(found, key=lambda one: math.hypot(*one.point))
