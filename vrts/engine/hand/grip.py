"""What the pads find between them.

Frame P stands between the pads: x across them, y from finger to finger, z along the approach. The
part of a body that counts is the part between the pads, a slab of their width and length.
"""

from collections.abc import Sequence
from typing import NamedTuple

from vrts.base.pose import X_AXIS, Z_AXIS, Pose
from vrts.base.remembered import is_remembering, remembered
from vrts.engine.hand.slab import slab_reach
from vrts.geometry.shapes import Piece
from vrts.geometry.support import Interval, extent_of
from vrts.robots.model import Gripper


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
        X_PS = X_PO @ piece.X_OP
        upper = slab_reach(piece.shape, X_PS, 1.0, half_width, half_length)
        lower = -slab_reach(piece.shape, X_PS, -1.0, half_width, half_length)
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
