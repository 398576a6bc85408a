"""How near bodies are to each other and to the hand, at one instant.

Boxes along the axes decide most questions; what they leave open is proven by the shapes alone.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

from vrts.base.pose import Pose, translation
from vrts.geometry.proving.scalar import nearest
from vrts.geometry.shapes import Piece
from vrts.geometry.support import Bounds, bounds
from vrts.robots.kinematics.kinematics import link_poses
from vrts.robots.model import Configuration, Gripper, Robot, flange_in_hand
from vrts.scene.model import Body


@dataclass(frozen=True)
class Placed:
    """A named union of pieces at its place in W; the boxes round it are worked out once."""

    name: str
    pieces: tuple[Piece, ...]
    X_WO: Pose

    @cached_property
    def box(self) -> Bounds:
        """The box along the axes of W that holds all of it."""
        return bounds(self.pieces, self.X_WO)

    @cached_property
    def boxes(self) -> tuple[Bounds, ...]:
        """The same box of each piece."""
        return tuple(bounds((piece,), self.X_WO) for piece in self.pieces)


class Nearness(NamedTuple):
    """Two things and the signed distance between them."""

    part: str  # "the left finger", "the forearm"
    body: str
    clearance: float  # [m]; negative is overlap


def hand_pieces(gripper: Gripper, opening: float) -> tuple[tuple[str, tuple[Piece, ...]], ...]:
    """Return the named parts of the hand, in the flange frame, at an opening [m]."""
    parts: list[tuple[str, tuple[Piece, ...]]] = [("hand", gripper.body)]
    for finger in gripper.fingers:
        X_FF0 = translation(0.0, finger.side * opening / 2, 0.0)
        moved = tuple(Piece(piece.shape, X_FF0 @ piece.X_OP) for piece in finger.pieces)
        parts.append((finger.name, moved))
    return tuple(parts)


def placed_hand(gripper: Gripper, X_WF: Pose, opening: float) -> tuple[Placed, ...]:
    """Return the parts of the hand at a pose of the flange."""
    return tuple(Placed(name, pieces, X_WF) for name, pieces in hand_pieces(gripper, opening))


def placed_robot(robot: Robot, q: Configuration, opening: float) -> tuple[Placed, ...]:
    """Return links and hand at a configuration; W is the base frame."""
    poses = link_poses(robot.arm, q)
    links = tuple(
        Placed(link.name, link.pieces, poses[link.joint]) for link in robot.arm.links if link.pieces
    )
    X_WF = poses[6] @ flange_in_hand(robot.arm)
    return (*links, *placed_hand(robot.gripper, X_WF, opening))


def placed_body(body: Body) -> Placed:
    """Return a body where it stands at the start."""
    return Placed(body.name, body.pieces, body.X_WO)


def clearance(first: Placed, second: Placed, beyond: float = math.inf) -> float:
    """Return the signed distance [m] of two unions of pieces.

    Where it is certainly larger than `beyond`, a lower bound of it is returned instead.
    """
    apart = _apart(first.box, second.box)
    if apart > beyond:
        return apart
    least = math.inf
    for a, box_a in zip(first.pieces, first.boxes, strict=True):
        for b, box_b in zip(second.pieces, second.boxes, strict=True):
            apart = _apart(box_a, box_b)
            if apart > min(beyond, least):
                least = min(least, apart)
            else:
                least = min(least, nearest(a, first.X_WO, b, second.X_WO).lower)
    return least


def overlap_is_within(first: Placed, second: Placed, tolerance: float) -> bool:
    """Return whether two unions of pieces are at most `tolerance` [m] deep in each other."""
    for a, box_a in zip(first.pieces, first.boxes, strict=True):
        for b, box_b in zip(second.pieces, second.boxes, strict=True):
            if _apart(box_a, box_b) >= -tolerance:
                continue  # the boxes alone show it: the depth is the least overlap in a direction
            if nearest(a, first.X_WO, b, second.X_WO).lower < -tolerance:
                return False
    return True


def nearest_body(parts: Sequence[Placed], bodies: Sequence[Body]) -> Nearness | None:
    """Return the body nearest to any part, with that part; None without parts or bodies."""
    best: Nearness | None = None
    for body in bodies:
        other = placed_body(body)
        for part in parts:
            so_far = math.inf if best is None else best.clearance
            found = clearance(part, other, so_far)
            if found < so_far:
                best = Nearness(part.name, body.name, found)
    return best


def _apart(a: Bounds, b: Bounds) -> float:
    """Return a lower bound of the signed distance: the gap of two boxes, or the least overlap."""
    gaps = [max(b.lower[axis] - a.upper[axis], a.lower[axis] - b.upper[axis]) for axis in range(3)]
    open_gaps = [gap for gap in gaps if gap > 0.0]
    return math.hypot(*open_gaps) if open_gaps else max(gaps)
