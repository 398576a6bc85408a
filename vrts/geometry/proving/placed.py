"""How far placed shapes reach, in plain Python: one closure for each.

For single questions; `rows` answers the same for many at once.
"""

import math
from collections.abc import Callable
from typing import TypeAlias

from vrts.base.pose import Pose, Vector
from vrts.geometry.shapes import Box, Cylinder, Hull, Shape

# of a direction in W, of any length but zero: a point of the shape that lies farthest in it, in W
Support: TypeAlias = Callable[[float, float, float], Vector]


def placed(shape: Shape, X_WP: Pose) -> Support:
    """Return the support function of a shape in frame P, for directions in W."""
    match shape:
        case Box(half_extents=half):
            return _box(half, X_WP)
        case Cylinder(radius=radius, half_length=half_length):
            return _cylinder(radius, half_length, X_WP)
        case Hull(points=points):
            return _hull(points, X_WP)


def _box(half: Vector, X_WP: Pose) -> Support:
    r = X_WP.rotation
    a, b, c = half
    ax, ay, az = a * r[0], a * r[3], a * r[6]
    bx, by, bz = b * r[1], b * r[4], b * r[7]
    cx, cy, cz = c * r[2], c * r[5], c * r[8]
    ox, oy, oz = X_WP.translation

    def support(x: float, y: float, z: float) -> Vector:
        i = -1.0 if ax * x + ay * y + az * z < 0.0 else 1.0
        j = -1.0 if bx * x + by * y + bz * z < 0.0 else 1.0
        k = -1.0 if cx * x + cy * y + cz * z < 0.0 else 1.0
        return (
            ox + i * ax + j * bx + k * cx,
            oy + i * ay + j * by + k * cy,
            oz + i * az + j * bz + k * cz,
        )

    return support


def _cylinder(radius: float, half_length: float, X_WP: Pose) -> Support:
    ax, bx, ux, ay, by, uy, az, bz, uz = X_WP.rotation
    ox, oy, oz = X_WP.translation

    def support(x: float, y: float, z: float) -> Vector:
        h = -half_length if ux * x + uy * y + uz * z < 0.0 else half_length
        # by the axes across, so that what is nearly along the cylinder stays on its cap
        i = ax * x + ay * y + az * z
        j = bx * x + by * y + bz * z
        across = math.sqrt(i * i + j * j)
        s = radius / across if across > 0.0 else 0.0
        i *= s
        j *= s
        return (
            ox + h * ux + i * ax + j * bx,
            oy + h * uy + i * ay + j * by,
            oz + h * uz + i * az + j * bz,
        )

    return support


def _hull(points: tuple[Vector, ...], X_WP: Pose) -> Support:
    r0, r1, r2, r3, r4, r5, r6, r7, r8 = X_WP.rotation

    def support(x: float, y: float, z: float) -> Vector:
        u = r0 * x + r3 * y + r6 * z
        v = r1 * x + r4 * y + r7 * z
        w = r2 * x + r5 * y + r8 * z
        heights = [u * a + v * b + w * c for a, b, c in points]
        return X_WP.apply(points[heights.index(max(heights))])

    return support
