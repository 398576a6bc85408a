"""Where the surface of a mesh is nearest to points, and on which side of it they are."""

import math
from typing import TypeAlias

import numpy as np
import numpy.typing as npt

from vrts.scene.meshes.triangles import Triangles
from vrts.scene.meshes.winding import shares

Array: TypeAlias = npt.NDArray[np.float64]
Indices: TypeAlias = npt.NDArray[np.int64]

AT_ONCE = 2_000_000  # numbers of a matrix
EDGE = 1e-9  # share of a triangle: nearer to its edge, it does not tell inside from outside


class Space:
    """Signed distances of points to a closed surface."""

    def __init__(self, mesh: Triangles) -> None:
        """Keep the triangles, and the balls round them."""
        self.corners = mesh.corners
        self.middles = self.corners.mean(axis=1)
        self.radii = np.linalg.norm(self.corners - self.middles[:, None], axis=2).max(axis=1)

    def distance(self, points: Array) -> tuple[Array, Indices]:
        """Return how far points are from the surface, inside negative, and the nearest triangle.

        Where the surface meets itself, points inside may count as outside, never the reverse.

        Args:
            points: Shape (n, 3), in mm.

        Returns:
            Distances in mm and numbers of triangles, each of shape (n,).
        """
        found = np.empty(len(points))
        triangles = np.empty(len(points), dtype=np.int64)
        step = max(1, AT_ONCE // len(self.middles))
        for first in range(0, len(points), step):
            some = points[first : first + step]
            square = (
                (some**2).sum(axis=1)[:, None]
                - 2.0 * some @ self.middles.T
                + (self.middles**2).sum(axis=1)
            )
            away = np.sqrt(np.maximum(square, 0.0))
            near = away - self.radii <= away.min(axis=1, keepdims=True) + 1e-6
            for row, point in enumerate(some):
                candidates = np.nonzero(near[row])[0]
                found[first + row], best = self._one(point, candidates)
                triangles[first + row] = candidates[best]
        return found, triangles

    def to_one(self, cells: Array, triangles: Indices) -> Array:
        """Return the largest distance of cells to one triangle each, shape (n,), in mm."""
        chosen = self.corners[triangles]
        return np.max([away(cells[:, k], chosen) for k in range(3)], axis=0)

    def _one(self, point: Array, candidates: Indices) -> tuple[float, int]:
        nearest, weights = nearest_points(point, self.corners[candidates])
        away = np.linalg.norm(nearest - point, axis=1)
        best = int(np.argmin(away))
        if float(weights[best].min()) > EDGE:
            a, b, c = self.corners[candidates[best]]
            outside = float((point - a) @ np.cross(b - a, c - a)) > 0.0
        else:
            outside = self._winding(point) < 0.5
        return (float(away[best]) if outside else -float(away[best])), best

    def _winding(self, point: Array) -> float:
        """Return how often the surface goes round a point: 0 outside."""
        return float(shares(self.corners, point).sum())


def away(points: Array, triangles: Array) -> Array:
    """Return the distance of each point to the triangle with it, shape (n,), in mm."""
    return np.linalg.norm(nearest_points(points, triangles)[0] - points, axis=1)


def nearest_points(point: Array, triangles: Array) -> tuple[Array, Array]:
    """Return the nearest point of each triangle, and its weights of the corners [Ericson2005].

    Args:
        point: One for all triangles, shape (3,), or one for each, shape (n, 3).
        triangles: Shape (n, 3, 3).
    """
    a, b, c = triangles.transpose(1, 0, 2)
    ab, ac, bc = b - a, c - a, c - b
    normal = np.cross(ab, ac)
    size = np.maximum(np.einsum("ij,ij->i", normal, normal), 1e-300)
    ap = point - a
    v = np.einsum("ij,ij->i", np.cross(ap, ac), normal) / size
    w = np.einsum("ij,ij->i", np.cross(ab, ap), normal) / size
    weights = np.stack([1.0 - v - w, v, w], axis=1)
    inside = weights.min(axis=1) >= 0.0
    sides: list[Array] = []
    for start, way, first, second in ((a, ab, 0, 1), (b, bc, 1, 2), (a, ac, 0, 2)):
        length = np.maximum(np.einsum("ij,ij->i", way, way), 1e-300)
        share = np.clip(np.einsum("ij,ij->i", point - start, way) / length, 0.0, 1.0)
        rows = np.zeros_like(weights)
        rows[:, first], rows[:, second] = 1.0 - share, share
        sides.append(rows)
    options = np.stack([*sides, weights])  # (4, n, 3)
    places = np.einsum("kni,nij->knj", options, triangles)
    away = np.linalg.norm(places - point, axis=2)
    away[3, ~inside] = math.inf
    best = away.argmin(axis=0)
    rows = np.arange(len(triangles))
    return places[best, rows], options[best, rows]
