"""Watertight triangle meshes of convex pieces, for drawing."""

import math
from typing import NamedTuple, TypeAlias

import numpy as np
import numpy.typing as npt

from vrts.geometry.hull import faces
from vrts.geometry.shapes import Box, Cylinder, Hull, Piece, Shape

Array: TypeAlias = npt.NDArray[np.float64]
Indices: TypeAlias = npt.NDArray[np.int32]

FACETS = 48  # sides of a drawn cylinder


class Mesh(NamedTuple):
    """A closed surface of triangles, counter-clockwise seen from outside."""

    vertices: Array  # (n, 3) [m]
    triangles: Indices  # (m, 3), indices of vertices


def tessellate(piece: Piece, facets: int = FACETS) -> Mesh:
    """Return the surface of a piece in its body's frame O.

    Vertices are shared between triangles, so every edge belongs to exactly two triangles. A
    cylinder's drawn corners lie on its surface: the sides lie inside by r (1 - cos(pi/facets)).

    Args:
        piece: A convex piece.
        facets: Sides of a cylinder, at least 3.
    """
    local = surface(piece.shape, facets)
    rotation = np.array(piece.X_OP.rotation).reshape(3, 3)
    vertices = local.vertices @ rotation.T + np.array(piece.X_OP.translation)
    return Mesh(vertices, local.triangles)


def surface(shape: Shape, facets: int = FACETS) -> Mesh:
    """Return the surface of a shape in its own frame."""
    match shape:
        case Box(half_extents=(a, b, c)):
            corners = np.array([(x, y, z) for x in (-a, a) for y in (-b, b) for z in (-c, c)])
            return Mesh(corners, np.array(_BOX_TRIANGLES, dtype=np.int32))
        case Cylinder(radius=radius, half_length=half_length):
            return _cylinder(radius, half_length, facets)
        case Hull(points=points):
            hull = faces(np.array(points, dtype=np.float64))
            triangles = [
                (polygon[0], polygon[k], polygon[k + 1])
                for polygon in hull.polygons
                for k in range(1, len(polygon) - 1)
            ]
            return Mesh(hull.vertices, np.array(triangles, dtype=np.int32))


# corners are numbered 4 [x > 0] + 2 [y > 0] + [z > 0]
_BOX_TRIANGLES = (
    *((0, 1, 3), (0, 3, 2)),
    *((4, 6, 7), (4, 7, 5)),
    *((0, 4, 5), (0, 5, 1)),
    *((2, 3, 7), (2, 7, 6)),
    *((0, 2, 6), (0, 6, 4)),
    *((1, 5, 7), (1, 7, 3)),
)


def _cylinder(radius: float, half_length: float, facets: int) -> Mesh:
    angles = np.arange(facets) * (2.0 * math.pi / facets)
    ring = np.column_stack([radius * np.cos(angles), radius * np.sin(angles)])
    low = np.column_stack([ring, np.full(facets, -half_length)])
    high = np.column_stack([ring, np.full(facets, half_length)])
    here = np.arange(facets)
    there = (here + 1) % facets
    fan = np.arange(1, facets - 1)
    zero = np.zeros(facets - 2, dtype=np.int64)
    triangles = np.concatenate(
        [
            np.column_stack([here, there, there + facets]),
            np.column_stack([here, there + facets, here + facets]),
            np.column_stack([zero, fan + 1, fan]),
            np.column_stack([zero + facets, fan + facets, fan + 1 + facets]),
        ]
    )
    return Mesh(np.concatenate([low, high]), triangles.astype(np.int32))
