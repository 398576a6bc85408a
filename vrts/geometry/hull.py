"""The faces of a convex hull, by gift wrapping.

The hulls of robots and objects have few points and many of them lie in one plane (rings, boxes), so
faces are found as whole polygons: turn a plane about an edge until it meets points again.
"""

import math
from typing import NamedTuple, TypeAlias

import numpy as np
import numpy.typing as npt

Array: TypeAlias = npt.NDArray[np.float64]

FLAT = 1e-9  # points this near to a plane lie in it, as a share of the size of the hull


class Faces(NamedTuple):
    """A convex polyhedron: polygons over the points that are corners of it."""

    vertices: Array  # (n, 3) [m]
    polygons: tuple[tuple[int, ...], ...]  # counter-clockwise seen from outside


def faces(points: Array) -> Faces:
    """Return the faces of the convex hull of points.

    Args:
        points: Shape (n, 3), in m; points inside the hull, on its faces, or doubled are dropped.

    Raises:
        ValueError: The points lie in one plane.
    """
    points = np.unique(points, axis=0)
    if len(points) < 4:
        raise ValueError("fewer than four points")
    size = float(np.ptp(points, axis=0).max())
    normal = _first_normal(points, size)
    if float(np.ptp(points @ normal)) <= 4 * FLAT * size:
        raise ValueError("the points lie in one plane")
    found: list[tuple[int, ...]] = []
    first = _polygon(points, normal, size)
    pending = [(first, normal)]
    owner: dict[tuple[int, int], int] = {}
    while pending:
        polygon, normal = pending.pop()
        if all((a, b) in owner for a, b in _edges(polygon)):
            continue
        for edge in _edges(polygon):
            owner[edge] = len(found)
        found.append(polygon)
        for a, b in _edges(polygon):
            if (b, a) not in owner:
                turned = _turn(points, a, b, normal, size)
                pending.append((_polygon(points, turned, size), turned))
    used = sorted({corner for polygon in found for corner in polygon})
    number = {corner: index for index, corner in enumerate(used)}
    polygons = tuple(tuple(number[corner] for corner in polygon) for polygon in found)
    return Faces(points[used], polygons)


def _edges(polygon: tuple[int, ...]) -> list[tuple[int, int]]:
    return list(zip(polygon, polygon[1:] + polygon[:1], strict=True))


def _first_normal(points: Array, size: float) -> Array:
    """Return the normal of one face: turn a plane at the lowest x twice."""
    normal = np.array([-1.0, 0.0, 0.0])
    flat = points[points[:, 0] <= points[0, 0] + FLAT * size]
    if len(flat) > 2 and np.linalg.matrix_rank(flat - flat[0], tol=FLAT * size) == 2:
        return normal
    # turn about an axis through the lowest point until a second point lies in the plane
    axis = np.array([0.0, 1.0, 0.0])
    if len(flat) > 1:
        axis = flat[-1] - flat[0]
        axis /= np.linalg.norm(axis)
    normal = _wrap(points, points[0], axis, normal, size)
    flat = points[(points - points[0]) @ normal >= -FLAT * size]
    rank = np.linalg.matrix_rank(flat - flat[0], tol=FLAT * size)
    if rank < 2:
        far = flat[np.argmax(np.linalg.norm(flat - points[0], axis=1))]
        axis = (far - points[0]) / np.linalg.norm(far - points[0])
        normal = _wrap(points, points[0], axis, normal, size)
    return normal


def _turn(points: Array, a: int, b: int, normal: Array, size: float) -> Array:
    """Return the normal of the face on the other side of the edge from a to b."""
    axis = points[b] - points[a]
    axis = axis / np.linalg.norm(axis)
    turned = _wrap(points, points[a], axis, normal, size)
    in_plane = points[(points - points[a]) @ turned >= -FLAT * size]
    return _fitted(in_plane, turned)


def _wrap(points: Array, origin: Array, axis: Array, normal: Array, size: float) -> Array:
    """Return the normal after turning a plane about an axis until it meets another point.

    The plane through `origin` has all points behind it; turning is from `normal` away from the
    face, about the axis, until the first point off the axis is met.
    """
    side = np.cross(axis, normal)  # in the plane, away from the face that is left
    offsets = points - origin
    outward = offsets @ side
    depth = -(offsets @ normal)
    off_axis = np.hypot(outward, depth) > 10 * FLAT * size
    angles = np.arctan2(depth, outward)
    angles[~off_axis] = math.inf
    # points of the face that is left lie at pi; rounding may put them at -pi
    angles[angles < -math.pi / 2] += 2 * math.pi
    angle = float(angles.min())
    if not math.isfinite(angle):
        raise ValueError("the points lie on one line")
    return normal * math.cos(angle) + side * math.sin(angle)


def _fitted(in_plane: Array, normal: Array) -> Array:
    """Return the normal of the plane through points, on the side of a rough normal."""
    centred = in_plane - in_plane.mean(axis=0)
    if len(in_plane) < 3:
        raise ValueError("the points lie in one plane")
    best = np.linalg.svd(centred, full_matrices=False)[2][2]
    return best if best @ normal > 0 else -best


def _polygon(points: Array, normal: Array, size: float) -> tuple[int, ...]:
    """Return the corners, counter-clockwise, of the face of the hull with an outward normal."""
    heights = points @ normal
    indices = np.nonzero(heights >= heights.max() - 4 * FLAT * size)[0]
    least = int(np.argmin(np.abs(normal)))
    u = np.cross(normal, np.eye(3)[least])
    u /= np.linalg.norm(u)
    v = np.cross(normal, u)
    flat = [(float(points[i] @ u), float(points[i] @ v), int(i)) for i in indices]
    flat.sort()
    tolerance = (10 * FLAT * size) * size

    def chain(ordered: list[tuple[float, float, int]]) -> list[tuple[float, float, int]]:
        kept: list[tuple[float, float, int]] = []
        for point in ordered:
            while len(kept) > 1 and _area(kept[-2], kept[-1], point) <= tolerance:
                kept.pop()
            kept.append(point)
        return kept[:-1]

    corners = chain(flat) + chain(flat[::-1])
    if len(corners) < 3:
        raise ValueError("the points lie in one plane")
    return tuple(corner[2] for corner in corners)


def _area(
    a: tuple[float, float, int], b: tuple[float, float, int], c: tuple[float, float, int]
) -> float:
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
