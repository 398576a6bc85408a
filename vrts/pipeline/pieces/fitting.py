"""Convex parts of a mesh made to hold all of its surface, and written on a grid.

The library that splits a mesh may leave some of it out: parts are made larger until the proof of
`scene.meshes.covering` finds nothing left over, as they will stand in the file.
"""

from collections.abc import Sequence
from typing import TypeAlias

import numpy as np
import numpy.typing as npt

from vrts.geometry.thin import thinned
from vrts.pipeline.pieces.qhull import FlatPoints, hulled, volume
from vrts.scene.meshes.covering import left_over
from vrts.scene.meshes.polytopes import Polytope, polytope
from vrts.scene.meshes.triangles import MeshFault, Triangles

Array: TypeAlias = npt.NDArray[np.float64]

SKIN = 3e-3  # [mm] by which a piece is made larger, beside what rounding takes away
THINNEST = 0.02  # [mm] of a piece; flatter ones are made this thick
MOST_POINTS = 64  # of a piece before it is made to hold what stands out
FEWER = 2e-3  # of the size of the mesh: what fewer corners may add to a piece
DECIMALS = (3, 2, 1)  # of a coordinate [mm]: coarser where a hull is not sound
ROUNDS = 4  # of making pieces hold what is left over
SOUND = 1e-6  # share of a volume that two ways to a hull may differ by


def fitted(mesh: Triangles, parts: Sequence[Array]) -> tuple[Array, ...]:
    """Return the corners of convex pieces that hold the surface of a mesh, proven.

    Args:
        mesh: The surface, in mm.
        parts: Corners of the convex parts it was split into, each of shape (n, 3).

    Raises:
        MeshFault: No such pieces were found.
    """
    lower, upper = mesh.vertices.min(axis=0), mesh.vertices.max(axis=0)
    tolerance = FEWER * float(np.ptp(mesh.vertices, axis=0).max())
    pieces = [_simplified(part, tolerance) for part in parts if len(part) > 2]
    for _ in range(ROUNDS):
        written = [_written(piece, lower, upper) for piece in pieces]
        sound = [polytope(points) for points in written]
        shreds = left_over(mesh, sound)
        if not shreds:
            return tuple(written)
        more: dict[int, list[Array]] = {}
        for shred in shreds:
            more.setdefault(shred.nearest, []).append(shred.corners)
        pieces = [
            hulled(np.concatenate([piece.points, *more.get(number, [])]))
            for number, piece in enumerate(pieces)
        ]
    raise MeshFault(
        "no convex pieces were found that hold the whole mesh",
        "repair the mesh, or save it with fewer triangles",
    )


def _solid(points: Array) -> Polytope:
    """Return the hull of points; of points in a plane, nearly, one that is a little thicker."""
    try:
        found = hulled(points)
    except FlatPoints:
        found = None
    if found is not None:
        heights = points @ found.normals.T - found.offsets
        if float(heights.min(axis=0).max()) < -THINNEST / 2:
            return found
    around = np.array([(x, y, z) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)])
    return hulled((points[:, None, :] + 0.5 * THINNEST * around).reshape(-1, 3))


def _simplified(points: Array, tolerance: float) -> Polytope:
    """Return the hull of points, with fewer corners where there are many, that still holds all."""
    found = _solid(points)
    if len(found.points) <= MOST_POINTS:
        return found
    few = _solid(thinned(found.points, tolerance))
    while (out := float(few.excess(points).max())) > 0.0:
        few = grown(few, 1.01 * out + SKIN)
    return few


def grown(piece: Polytope, by: float) -> Polytope:
    """Return a piece that holds every point nearer than a length to another one.

    Every corner is moved so that each of its planes moves by `by` at least. The new piece reaches
    farther than the old one by `by` in every direction: a direction is a sum of normals of one
    corner's planes, with factors that are at least 1 together.
    """
    centre = piece.points.mean(axis=0)
    heights = piece.points @ piece.normals.T - piece.offsets
    moved = piece.points.copy()
    for corner, row in enumerate(heights):
        normals = piece.normals[row > -1e-6]
        best = piece.points[corner] - centre
        for away in (normals.sum(axis=0), np.linalg.pinv(normals) @ np.ones(len(normals))):
            if _rate(normals, away) > _rate(normals, best):
                best = away
        moved[corner] += by * best / (np.linalg.norm(best) * _rate(normals, best))
    return hulled(moved)


def _rate(normals: Array, away: Array) -> float:
    """Return how fast the slowest plane moves with a corner that goes a way."""
    length = float(np.linalg.norm(away))
    return -1.0 if length < 1e-12 else float((normals @ away).min()) / length


def _written(piece: Polytope, lower: Array, upper: Array) -> Array:
    """Return the corners of a slightly larger piece, rounded, of a hull that all ways agree on.

    Corners that lie in a side of the box round the mesh are put into one plane just outside it, so
    that what stands on the ground stands on whole faces.

    Args:
        piece: The piece.
        lower: Of the box round the mesh, shape (3,).
        upper: See `lower`.
    """
    for decimals in DECIMALS:
        grid = 10.0**-decimals
        points = grown(piece, SKIN + grid).points
        near = 3.0 * (SKIN + grid)
        low = np.floor((lower - SKIN) / grid) * grid
        high = np.ceil((upper + SKIN) / grid) * grid
        points = np.where(np.abs(points - low) < near, low, points)
        points = np.where(np.abs(points - high) < near, high, points)
        points = np.unique(np.round(points, decimals).astype(np.float64) + 0.0, axis=0)
        corners = hulled(points).points
        if _is_sound(corners):
            return corners
    raise MeshFault(
        "a convex piece of the mesh is too thin to be told from a plane",
        "repair the mesh, or save it with fewer triangles",
    )


def _is_sound(points: Array) -> bool:
    """Return whether the faces that runs find are those of the hull."""
    try:
        found = polytope(points)
    except ValueError:
        return False
    middle = found.points.mean(axis=0)
    whole = 0.0
    for polygon in found.polygons:
        ring = found.points[list(polygon)] - middle
        for k in range(1, len(ring) - 1):
            whole += float(ring[0] @ np.cross(ring[k], ring[k + 1])) / 6.0
    expected = volume(points)
    return abs(whole - expected) <= SOUND * expected
