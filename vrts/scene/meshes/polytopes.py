"""Convex pieces by their planes, and how far points stand out of one.

A piece is the hull of its points. Its planes are `normals @ x <= offsets`; a point stands out by
the largest excess. All lengths in mm, in the frame of the mesh.
"""

from typing import NamedTuple, TypeAlias

import numpy as np
import numpy.typing as npt

from vrts.geometry.hull import faces

Array: TypeAlias = npt.NDArray[np.float64]

OUT = 1e-6  # [mm] by which a point of a hull may be outside its planes


class Polytope(NamedTuple):
    """A convex piece."""

    points: Array  # (n, 3), its corners [mm]
    normals: Array  # (f, 3), outward unit vectors
    offsets: Array  # (f,) [mm]
    polygons: tuple[tuple[int, ...], ...]  # corners of the faces, or of triangles of them

    def excess(self, points: Array) -> Array:
        """Return by how much points stand out of the farthest plane, shape (n,); inside negative.

        Never more than the distance to the piece.
        """
        return (points @ self.normals.T - self.offsets).max(axis=1)


def polytope(points: Array) -> Polytope:
    """Return the hull of points. Its planes are fitted to whole faces, and hold all points.

    Faces that lie on the hull and close round it are all of its faces. Where points are within
    rounding of a plane, one may be left out: the planes would hold more than the hull, and be no
    proof that the hull holds a mesh.

    Raises:
        ValueError: The points lie in one plane, or so nearly that faces do not close.
    """
    hull = faces(points)
    edges = [
        edge
        for polygon in hull.polygons
        for edge in zip(polygon, polygon[1:] + polygon[:1], strict=True)
    ]
    if len(set(edges)) != len(edges) or {(b, a) for a, b in edges} != set(edges):
        raise ValueError("the faces of the hull do not close")
    normals: list[Array] = []
    for polygon in hull.polygons:
        ring = hull.vertices[list(polygon)]
        middle = ring.mean(axis=0)
        spokes = ring - middle
        area = np.cross(spokes, np.roll(spokes, -1, axis=0)).sum(axis=0)
        normals.append(area / np.linalg.norm(area))
    array = np.array(normals)
    offsets = (hull.vertices @ array.T).max(axis=0)
    found = Polytope(hull.vertices, array, offsets, hull.polygons)
    if float(found.excess(points).max()) > OUT:
        raise ValueError("the faces of the hull leave a point out")
    return found
