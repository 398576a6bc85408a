"""What the pads find between them.

Frame P stands between the pads: x across them, y from finger to finger, z along the approach. The
part of a body that counts is the part between the pads, a slab of their width and length: how wide
it is, and how long along a pad, is that of the union of its pieces, however a mesh was cut.
"""

from collections.abc import Iterable, Sequence
from typing import NamedTuple

from vrts.base.pose import X_AXIS, Z_AXIS, Pose, Vector
from vrts.base.remembered import is_remembering, remembered
from vrts.engine.hand.slab import X, Z, part_along, slab_reach
from vrts.geometry.shapes import Piece
from vrts.geometry.support import Bounds, Interval, extent_of
from vrts.robots.model import Gripper

JOINED = 1e-4  # [m] pieces nearer than this are one part


class Between(NamedTuple):
    """A body as the pads meet it."""

    across: Interval  # along y of P, of the part between the pads [m]
    overlap: float  # smaller of the lengths along x and z of what is between the pads [m]

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
    parts: list[Bounds] = []  # round what of each piece is between the pads
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
        along = [part_along(piece.shape, X_PS, axis, half_width, half_length) for axis in (X, Z)]
        (left, right), (back, front) = along
        parts.append(Bounds((left, lower, back), (right, upper, front)))
    if not parts:
        return None
    across = Interval(min(p.lower[1] for p in parts), max(p.upper[1] for p in parts))
    return Between(across, max(_common(whole) for whole in _joined(parts)))


def _common(part: Bounds) -> float:
    """Return the smaller of the lengths along x and z [m]."""
    return min(part.upper[0] - part.lower[0], part.upper[2] - part.lower[2])


def _joined(parts: Sequence[Bounds]) -> list[Bounds]:
    """Return boxes round parts that touch: where a mesh is cut into pieces is nobody's doing.

    Parts are asked whether they touch, and not boxes round several: those depend on the order.
    """
    groups: list[list[Bounds]] = []
    for part in parts:
        group, apart = [part], list[list[Bounds]]()
        for other in groups:
            if any(_touch(part, each) for each in other):
                group += other
            else:
                apart.append(other)
        groups = [*apart, group]
    return [
        Bounds(
            _vector(map(min, zip(*(part.lower for part in group), strict=True))),
            _vector(map(max, zip(*(part.upper for part in group), strict=True))),
        )
        for group in groups
    ]


def _touch(a: Bounds, b: Bounds) -> bool:
    return all(
        a.lower[k] <= b.upper[k] + JOINED and b.lower[k] <= a.upper[k] + JOINED for k in range(3)
    )


def _vector(values: Iterable[float]) -> Vector:
    x, y, z = values
    return (x, y, z)
