"""Where a hand can hold what a mesh describes: as its file says, or found from its pieces.

Found are places with the hand straight down, the pads on two sides of something that stands between
them: the middle of the whole first, then the middles of its pieces, the nearest to its centre of
mass first. What is between the pads is exact for the pieces; whether it is strong is not asked.
"""

import math
from collections.abc import Sequence
from functools import lru_cache
from typing import NamedTuple, TypeAlias

import numpy as np
import numpy.typing as npt

from vrts.base.oat import rotation_from_oat
from vrts.base.pose import IDENTITY, Pose, Vector
from vrts.base.units import DEG
from vrts.geometry.clipping import above
from vrts.geometry.hull import faces
from vrts.geometry.shapes import Hull, Piece
from vrts.geometry.support import Interval, bounds, extent_of
from vrts.robots.model import Gripper
from vrts.scene.model import Body

Array: TypeAlias = npt.NDArray[np.float64]

TURNS = (90, 0, 45, 135, 30, 60, 120, 150)  # [degrees] in which the fingers close, in O
MOST_MIDDLES = 12  # pieces that are looked at
MOST_GRIPS = 24  # that are told
LEAST_PAD_GAP = 1e-3  # [m] between an open finger and the object
TIP_GAP = 10e-3  # [m] between the finger tips and what the object stands on
SAME = 1e-4  # [m] nearer than this, two grips are one


class _Pads(NamedTuple):
    """What of a hand counts here."""

    half_width: float  # of a pad [m]
    half_length: float  # [m]
    widest: float  # the hand opens [m]
    tips: float  # of the fingers, below the middle of the pads [m]
    overlap: float  # of pad and object, at least [m]


def mesh_grips(gripper: Gripper, body: Body) -> tuple[Pose, ...]:
    """Return poses X_OP of the middle between the pads, z of O up, the plainest first."""
    if body.grips:
        return body.grips
    pads = _Pads(
        gripper.pad_width / 2.0,
        gripper.pad_length / 2.0,
        gripper.opening_max,
        _tips(gripper),
        gripper.overlap_min,
    )
    return _found(pads, body.pieces, body.centre_of_mass)


def least_height(gripper: Gripper) -> float:
    """Return how high an object has to be for the fingers to get round it from above [m]."""
    return _tips(gripper) + TIP_GAP + gripper.overlap_min


def _tips(gripper: Gripper) -> float:
    """Return how far the tips of the fingers are below the middle of the pads [m]."""
    tips = max(extent_of(f.pieces, IDENTITY, (0.0, 0.0, 1.0)).upper for f in gripper.fingers)
    return tips - gripper.X_FP.translation[2]


@lru_cache(maxsize=64)
def _found(pads: _Pads, pieces: tuple[Piece, ...], mass: Vector) -> tuple[Pose, ...]:
    polygons = [_polygons(piece) for piece in pieces if isinstance(piece.shape, Hull)]
    middles = _middles(pieces, mass)
    low, high = pads.tips + TIP_GAP, bounds(pieces, IDENTITY).upper[2] - pads.overlap
    found: list[Pose] = []
    for x, y, z in middles:
        height = round(min(max(z, low), high), 3)
        if height < low - 1e-9:
            return ()  # too low for the fingers to get round it
        for turn in TURNS:
            across = (math.cos(turn * DEG), math.sin(turn * DEG))
            held = _between(pads, polygons, (x, y, height), across)
            if held is None or held.length + 2 * LEAST_PAD_GAP > pads.widest:
                continue
            shift = (held.lower + held.upper) / 2.0
            at = (x + shift * across[0], y + shift * across[1], height)
            for each in (turn, turn - 180):
                found.append(Pose(rotation_from_oat(each, 90.0, 0.0), at))
        if len(found) >= MOST_GRIPS:
            break
    return tuple(found[:MOST_GRIPS])


def _middles(pieces: Sequence[Piece], mass: Vector) -> list[Vector]:
    """Return where to look: at half height above the middle, then where pieces are."""
    (ax, ay, az), (bx, by, bz) = bounds(pieces, IDENTITY)
    half = (az + bz) / 2.0
    each = [bounds((piece,), IDENTITY) for piece in pieces]
    boxes = [tuple((a + b) / 2.0 for a, b in zip(lo, hi, strict=True)) for lo, hi in each]
    boxes.sort(key=lambda p: math.hypot(p[0] - mass[0], p[1] - mass[1]))
    wanted = [
        (mass[0], mass[1], half),
        ((ax + bx) / 2.0, (ay + by) / 2.0, half),
        *((x, y, level) for x, y, z in boxes[:MOST_MIDDLES] for level in (half, z)),
    ]
    kept: list[Vector] = []
    for point in wanted:
        if all(math.dist(point, other) > SAME for other in kept):
            kept.append(point)
    return kept


def _polygons(piece: Piece) -> list[Array]:
    """Return the faces of a piece, in O [m]."""
    assert isinstance(piece.shape, Hull)
    hull = faces(np.array([piece.X_OP.apply(point) for point in piece.shape.points]))
    return [hull.vertices[list(polygon)] for polygon in hull.polygons]


def _between(
    pads: _Pads, pieces: Sequence[Sequence[Array]], at: Vector, across: tuple[float, float]
) -> Interval | None:
    """Return what of an object lies between the pads of the open hand, along their way [m].

    None when it is nothing, or too little to hold. The farthest point along the way of what a
    convex piece has within the pads' slab lies on a face: the slab's sides run along the way.
    """
    side = np.array([-across[1], across[0], 0.0])
    way = np.array([across[0], across[1], 0.0])
    least, most, common = math.inf, -math.inf, 0.0
    for polygons in pieces:
        points: list[Vector] = []
        for polygon in polygons:
            seen = np.stack([(polygon - at) @ side, (polygon - at) @ way, polygon[:, 2] - at[2]], 1)
            corners: list[Vector] = [(x, y, z) for x, y, z in seen.tolist()]
            points += _clipped(_clipped(corners, 0, pads.half_width), 2, pads.half_length)
        if not points:
            continue
        part = np.array(points)
        low, high = part.min(axis=0), part.max(axis=0)
        if low[1] > pads.widest / 2.0 or high[1] < -pads.widest / 2.0:
            continue  # behind a finger, even with the hand wide open
        least, most = min(least, float(low[1])), max(most, float(high[1]))
        common = max(common, float(min(high[0] - low[0], high[2] - low[2])))
    if common < pads.overlap:
        return None
    return Interval(least, most)


def _clipped(polygon: list[Vector], axis: int, half: float) -> list[Vector]:
    """Return the part of a convex polygon within ± half along an axis."""
    for sign in (1.0, -1.0):
        polygon = above(polygon, [half - sign * corner[axis] for corner in polygon])
    return polygon
