"""What the pads find between them.

Frame P stands between the pads: x across them, y from finger to finger, z along the approach. The
part of a body that counts is the part between the pads, a slab of their width and length.
"""

import math
from collections.abc import Callable, Sequence
from typing import NamedTuple

from vrts.base.pose import X_AXIS, Z_AXIS, Pose, Vector, dot, rotate, transpose
from vrts.base.remembered import is_remembering, remembered
from vrts.geometry.shapes import Piece
from vrts.geometry.support import Interval, extent_of, reach
from vrts.robots.model import Gripper

SEARCH = 1.5  # multipliers of the slab's bounds are looked for within this
STEPS = 26  # of a golden-section search: to 1e-5 of its range
NUDGE = 1e-3
GOLDEN = (math.sqrt(5.0) - 1.0) / 2.0


class Between(NamedTuple):
    """A body as the pads meet it."""

    across: Interval  # along y of P, of the part between the pads [m]
    overlap: float  # smaller of the common lengths with a pad along x and z [m]

    @property
    def width(self) -> float:
        """The opening at which both pads touch [m]."""
        return self.across.length

    @property
    def centred(self) -> bool:
        """Whether each pad has some of the body on its side."""
        return self.across.lower < 0.0 < self.across.upper


def between(gripper: Gripper, pieces: Sequence[Piece], X_PO: Pose) -> Between | None:
    """Return how a body lies between the pads; None when no part of it does."""
    if not is_remembering():
        return _between(gripper, pieces, X_PO)
    key = ("between", id(gripper), id(pieces), X_PO)
    return remembered(key, lambda: _between(gripper, pieces, X_PO), alive=(gripper, pieces))


def _between(gripper: Gripper, pieces: Sequence[Piece], X_PO: Pose) -> Between | None:
    half_width, half_length = gripper.pad_width / 2.0, gripper.pad_length / 2.0
    half_opening = gripper.opening_max / 2.0
    found: list[Interval] = []
    overlap = 0.0
    for piece in pieces:
        x = extent_of((piece,), X_PO, X_AXIS).overlap(Interval(-half_width, half_width))
        z = extent_of((piece,), X_PO, Z_AXIS).overlap(Interval(-half_length, half_length))
        if min(x, z) <= 0.0:
            continue
        upper = _slab_reach(piece, X_PO, 1.0, half_width, half_length)
        lower = -_slab_reach(piece, X_PO, -1.0, half_width, half_length)
        if upper < lower:
            continue  # the piece passes the slab by, past one of its edges
        if lower > half_opening or upper < -half_opening:
            continue  # behind a finger, even with the hand wide open: the far wall of a dish
        found.append(Interval(lower, upper))
        overlap = max(overlap, min(x, z))
    if not found:
        return None
    across = Interval(min(i.lower for i in found), max(i.upper for i in found))
    return Between(across, overlap)


def _slab_reach(
    piece: Piece, X_PO: Pose, sign: float, half_width: float, half_length: float
) -> float:
    """Return how far the part of a convex piece within the slab reaches along +y or -y of P.

    The largest y over a convex set cut by |x| <= a, |z| <= b is the smallest value over multipliers
    (s, t) of h(s, 1, t) + a |s| + b |t|, with h the reach of the set (convex duality).
    """
    X_PS = X_PO @ piece.X_OP
    back = transpose(X_PS.rotation)

    def bound(s: float, t: float) -> float:
        direction: Vector = (s, sign, t)
        outward = reach(piece.shape, rotate(back, direction)) + dot(X_PS.translation, direction)
        return outward + half_width * abs(s) + half_length * abs(t)

    centre = bound(0.0, 0.0)
    around = ((1, 0), (-1, 0), (0, 1), (0, -1), (1, 1), (1, -1), (-1, 1), (-1, -1))
    if all(bound(NUDGE * s, NUDGE * t) >= centre - 1e-12 for s, t in around):
        return centre
    return _smallest(lambda s: _smallest(lambda t: bound(s, t)))


def _smallest(function: Callable[[float], float]) -> float:
    """Return the smallest value of a convex function on the search range."""
    low, high = -SEARCH, SEARCH
    a, b = high - GOLDEN * (high - low), low + GOLDEN * (high - low)
    at_a, at_b = function(a), function(b)
    for _ in range(STEPS):
        if at_a <= at_b:
            high, b, at_b = b, a, at_a
            a = high - GOLDEN * (high - low)
            at_a = function(a)
        else:
            low, a, at_a = a, b, at_b
            b = low + GOLDEN * (high - low)
            at_b = function(b)
    return min(at_a, at_b)
