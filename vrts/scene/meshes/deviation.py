"""How much more room pieces take than their mesh: an upper bound of it, and what was found.

The distance to the mesh changes by no more than one goes: on a triangle of a piece's surface it is
at most that at its middle plus the way to its farthest corner. And it is at most the distance to
one triangle of the mesh, which is a convex function: largest at a corner. Triangles with the
largest bounds are halved until the bound is near to the largest distance found.
"""

import math
from collections.abc import Sequence
from typing import NamedTuple, TypeAlias

import numpy as np
import numpy.typing as npt

from vrts.scene.meshes.covering import parted, without
from vrts.scene.meshes.polytopes import Polytope
from vrts.scene.meshes.space import Space, away
from vrts.scene.meshes.triangles import Triangles

Array: TypeAlias = npt.NDArray[np.float64]

NEAR_ENOUGH = 0.02  # [mm] of the bound to what was found
SHARE = 0.03  # or this share of the bound
BATCH = 600  # triangles halved at once
MOST_POINTS = 8_000  # at which the distance is asked for
SAMPLES = 20_000  # for volumes
FLUSH = 0.02  # [mm] a face of a piece this near to a triangle's plane lies in it
LINE = 1e-6  # [mm] a polygon this narrow is none
MOST_PRISMS = 60  # of one face
MOST_SHREDS = 3  # into which a part is cut by another piece: more are not worth it
LEAST_SHARE = 0.02  # of a face's area that a triangle has at least for the face to be cut by it


class Deviation(NamedTuple):
    """How far the surface of pieces is from their mesh; of what lies inside the mesh nothing."""

    found: float  # the largest distance found [mm]
    at_most: float  # proven [mm]


def deviation(mesh: Triangles, pieces: Sequence[Polytope]) -> Deviation:
    """Return how far the surface of convex pieces stands out of a mesh.

    Args:
        mesh: A closed surface.
        pieces: With their triangles, or polygons, as `polygons`.
    """
    space = Space(mesh)
    left, flush = _not_flush(mesh, pieces)
    fresh = np.array([cell for polygon in left for cell in _fan(polygon)]).reshape(-1, 3, 3)
    cells, bounds = fresh[:0], np.empty(0)
    asked, largest = 0, 0.0
    if not len(fresh):
        return Deviation(flush, flush)
    while True:
        middles = fresh.mean(axis=1)
        reach = np.linalg.norm(fresh - middles[:, None], axis=2).max(axis=1)
        values, nearest = space.distance(middles)
        asked += len(fresh)
        largest = max(largest, float(values.max()))
        cells = np.concatenate([cells, fresh])
        beside = space.to_one(fresh, nearest)
        bounds = np.concatenate([bounds, np.minimum(values + reach, beside)])
        wanted = largest + max(NEAR_ENOUGH, SHARE * largest)
        order = np.argsort(-bounds, kind="stable")
        worst = order[: min(BATCH, int((bounds > wanted).sum()))]
        if not len(worst) or asked > MOST_POINTS:
            return Deviation(max(largest, 0.0), max(largest, flush, float(bounds.max(initial=0.0))))
        fresh = _halved(cells[worst])
        kept = np.ones(len(cells), dtype=np.bool_)
        kept[worst] = False
        cells, bounds = cells[kept], bounds[kept]


def _not_flush(mesh: Triangles, pieces: Sequence[Polytope]) -> tuple[list[Array], float]:
    """Return the parts of faces that do not lie on triangles of the mesh, and how far others do.

    What is inside other pieces is no surface of their union, and left out; the narrow strips that
    this leaves beside edges are compared with triangles once more.
    """
    sides = _Sides(mesh)
    left: list[Array] = []
    farthest = 0.0
    for piece in pieces:
        for polygon in piece.polygons:
            rest, far = sides.cut(piece.points[list(polygon)])
            farthest = max(farthest, far)
            for part in _outside(rest, piece, pieces):
                strips, far = sides.cut(part)
                farthest = max(farthest, far)
                left += [strip for strip in strips if _is_seen(strip)]
    return left, farthest


class _Sides:
    """The triangles of a mesh with the prisms over them."""

    def __init__(self, mesh: Triangles) -> None:
        corners = mesh.corners
        a, b, c = corners.transpose(1, 0, 2)
        normals = np.cross(b - a, c - a)
        sizes = np.linalg.norm(normals, axis=1)
        self.corners = corners[sizes > 0.0]
        self.normals = normals[sizes > 0.0] / sizes[sizes > 0.0, None]
        self.areas = sizes[sizes > 0.0] / 2.0
        self.low, self.high = self.corners.min(axis=1) - FLUSH, self.corners.max(axis=1) + FLUSH
        self.heights = np.einsum("tk,tk->t", self.corners[:, 0], self.normals)

    def cut(self, polygon: Array) -> tuple[list[Array], float]:
        """Return the parts of a polygon that lie on no triangle, and how far the others do, in mm.

        A polygon that is as good as in the plane of a triangle is cut along the prism over it; what
        is inside is convex, so no farther from the triangle than its corners are.
        """
        touching = (polygon.min(axis=0) <= self.high) & (polygon.max(axis=0) >= self.low)
        some = np.nonzero(touching.all(axis=1) & (self.areas >= LEAST_SHARE * _area(polygon)))[0]
        above = np.abs(polygon @ self.normals[some].T - self.heights[some]).max(axis=0)
        rest, farthest = [polygon], 0.0
        for triangle in some[above <= FLUSH][:MOST_PRISMS]:
            corners, normal = self.corners[triangle], self.normals[triangle]
            sides = np.cross(np.roll(corners, -1, axis=0) - corners, normal)
            sides /= np.linalg.norm(sides, axis=1, keepdims=True)
            reach = np.einsum("ij,ij->i", sides, corners) + FLUSH
            kept: list[Array] = []
            for one in rest:
                inside, outside = parted(one, sides, reach)
                far = 0.0 if inside is None else _farthest(inside, corners)
                if far > 2.0 * FLUSH:  # past a sharp corner
                    kept.append(one)
                    continue
                farthest = max(farthest, far)
                kept += outside
            rest = kept
        return rest, farthest


def _outside(parts: list[Array], own: Polytope, pieces: Sequence[Polytope]) -> list[Array]:
    """Return what of parts of a face no other piece covers."""
    for other in pieces:
        if other is own or not parts:
            continue
        kept: list[Array] = []
        for one in parts:
            outside = without(one, other.normals, other.offsets)
            kept += outside if len(outside) <= MOST_SHREDS else [one]
        parts = kept
    return [part for part in parts if _is_seen(part)]


def _farthest(polygon: Array, triangle: Array) -> float:
    """Return the largest distance of a convex polygon to a triangle [mm]."""
    return float(away(polygon, np.repeat(triangle[None], len(polygon), axis=0)).max())


def _is_seen(polygon: Array) -> bool:
    """Return whether a polygon is more than a line that cutting has left."""
    return _area(polygon) > LINE * float(np.linalg.norm(polygon - polygon[0], axis=1).max())


def _area(polygon: Array) -> float:
    spokes = polygon - polygon[0]
    return float(np.linalg.norm(np.cross(spokes[1:-1], spokes[2:]).sum(axis=0)) / 2.0)


def _fan(polygon: Array) -> list[Array]:
    return [polygon[[0, k, k + 1]] for k in range(1, len(polygon) - 1)]


def _halved(cells: Array) -> Array:
    """Return both halves of triangles, cut through the middle of their longest side."""
    sides = np.linalg.norm(cells - np.roll(cells, -1, axis=1), axis=2)
    order = (sides.argmax(axis=1)[:, None] + np.arange(3)) % 3
    a, b, c = np.take_along_axis(cells, order[:, :, None], axis=1).transpose(1, 0, 2)
    middle = (a + b) / 2.0
    return np.concatenate([np.stack([a, middle, c], axis=1), np.stack([middle, b, c], axis=1)])


def united_volume(pieces: Sequence[Polytope]) -> float:
    """Return the volume of a union of pieces [mm^3], measured with 20,000 points of a box."""
    corners = np.concatenate([piece.points for piece in pieces])
    lower, upper = corners.min(axis=0), corners.max(axis=0)
    number = np.arange(1, SAMPLES + 1)
    # the plastic number's multiples fill a box evenly, and are the same everywhere
    plastic = 1.2207440846057596
    spread = (0.5 + number[:, None] * (1.0 / plastic ** np.arange(1, 4))) % 1.0
    points = lower + spread * (upper - lower)
    inside = np.zeros(SAMPLES, dtype=np.bool_)
    for piece in pieces:
        low, high = piece.points.min(axis=0), piece.points.max(axis=0)
        near = np.nonzero(~inside & ((points >= low) & (points <= high)).all(axis=1))[0]
        inside[near] = piece.excess(points[near]) <= 0.0
    return float(np.count_nonzero(inside)) / SAMPLES * math.prod((upper - lower).tolist())
