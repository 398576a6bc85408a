"""Whether pieces hold the whole surface of a mesh: proven triangle by triangle.

A triangle is cut along the planes of a piece; what lies inside is held, for a piece is convex. What
no piece holds is left over as convex polygons. The distance to a convex piece is a convex function,
so its largest value on a polygon is that at a corner: that bounds how far the mesh stands out. A
polygon that is left over is held as soon as its corners are given to a piece.
"""

from collections.abc import Sequence
from typing import NamedTuple, TypeAlias

import numpy as np
import numpy.typing as npt

from vrts.scene.meshes.polytopes import Polytope
from vrts.scene.meshes.triangles import Triangles

Array: TypeAlias = npt.NDArray[np.float64]

ROUNDING = 1e-7  # [mm] that arithmetic may be wrong by
MOST_SHREDS = 4000  # of one triangle


class Shred(NamedTuple):
    """A convex part of a triangle that no piece holds."""

    corners: Array  # (n, 3) [mm]
    nearest: int  # the piece out of which it stands least
    excess: float  # upper bound of how far it stands out of that piece's planes [mm]


def left_over(mesh: Triangles, pieces: Sequence[Polytope]) -> tuple[Shred, ...]:
    """Return what of the surface no piece holds; nothing left is a proof that pieces hold it.

    Points count as held that are outside planes by at most `ROUNDING`.
    """
    corners = mesh.corners
    heights = np.array([piece.excess(corners.reshape(-1, 3)) for piece in pieces])
    outside = heights.reshape(len(pieces), -1, 3).max(axis=2)  # (pieces, triangles)
    crossing = np.nonzero(outside.min(axis=0) > ROUNDING)[0]
    boxes = [(piece.points.min(axis=0), piece.points.max(axis=0)) for piece in pieces]
    found: list[Shred] = []
    for number in crossing:
        triangle = corners[number]
        low, high = triangle.min(axis=0), triangle.max(axis=0)
        shreds = [triangle]
        for piece, (lower, upper) in zip(pieces, boxes, strict=True):
            if bool((low > upper).any()) or bool((high < lower).any()):
                continue
            shreds = [
                rest for shred in shreds for rest in without(shred, piece.normals, piece.offsets)
            ]
            if not shreds or len(shreds) > MOST_SHREDS:
                break
        found += [_told(shred, pieces) for shred in shreds]
    return tuple(found)


def _told(shred: Array, pieces: Sequence[Polytope]) -> Shred:
    out = [float(piece.excess(shred).max()) for piece in pieces]
    nearest = int(np.argmin(out))
    return Shred(shred, nearest, out[nearest])


def without(polygon: Array, normals: Array, offsets: Array) -> list[Array]:
    """Return the parts of a convex polygon outside a convex body, as `parted` does."""
    return parted(polygon, normals, offsets)[1]


def parted(polygon: Array, normals: Array, offsets: Array) -> tuple[Array | None, list[Array]]:
    """Return the part of a convex polygon inside a convex body, if any, and the parts outside.

    The body is where `normals @ x <= offsets`.

    Args:
        polygon: Shape (n, 3), in mm.
        normals: Outward unit vectors, shape (f, 3).
        offsets: Shape (f,), in mm.
    """
    heights = polygon @ normals.T - offsets  # (corners, planes)
    above = heights.max(axis=0)
    if bool((heights.min(axis=0) >= 0.0).any()):
        return None, [polygon]  # a plane has all of it outside
    outside: list[Array] = []
    rest = polygon
    for plane in np.nonzero(above > ROUNDING)[0]:
        side = rest @ normals[plane] - offsets[plane]
        if float(side.max()) <= ROUNDING:
            continue
        out, rest = _cut(rest, side)
        if out is not None:
            outside.append(out)
        if rest is None:
            return None, [polygon]  # nothing of it is inside
    return rest, outside


def _cut(polygon: Array, side: Array) -> tuple[Array | None, Array | None]:
    """Return the parts of a polygon above and below a plane; None where there is none."""
    above: list[Array] = []
    below: list[Array] = []
    count = len(polygon)
    for here in range(count):
        there = (here + 1) % count
        a, b = float(side[here]), float(side[there])
        if a >= 0.0:
            above.append(polygon[here])
        if a <= 0.0:
            below.append(polygon[here])
        if a * b < 0.0:
            point = polygon[here] + (a / (a - b)) * (polygon[there] - polygon[here])
            above.append(point)
            below.append(point)
    upper = np.array(above) if len(above) > 2 else None
    lower = np.array(below) if len(below) > 2 else None
    return upper, lower


def stands_out(shreds: Sequence[Shred], pieces: Sequence[Polytope]) -> float:
    """Return an upper bound of how far what is left over stands out of the pieces [mm].

    Args:
        shreds: Of `left_over`.
        pieces: The same pieces.
    """
    farthest = 0.0
    for shred in shreds:
        piece = pieces[shred.nearest]
        # the distance to a corner of the piece is one to a point of it: an upper bound
        gaps = np.linalg.norm(shred.corners[:, None] - piece.points[None], axis=2).min(axis=1)
        farthest = max(farthest, float(gaps.max()))
    return farthest
