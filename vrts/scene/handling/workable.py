"""Where the hand can work: within reach with a margin, and with the fingers clear of neighbours."""

import math
from collections.abc import Iterable, Sequence
from typing import NamedTuple

from vrts.base.pose import Pose, add, scale
from vrts.base.units import DEG
from vrts.robots.model import Elbow, Shoulder
from vrts.scene.clearance import Placed, clearance, placed_body, placed_robot
from vrts.scene.model import Body, Scene
from vrts.scene.reach import branches

LEAST_MARGIN = 5.0 * DEG  # to the joint limits
GOOD_MARGIN = 20.0 * DEG  # enough not to look for another turn
APPROACH = 0.12  # [m] before a place that must be reachable too
ROUNDING = 1e-6  # [m] of gaps: what just fits does fit
LEAST_GAP = 5e-3  # [m] between the open hand and neighbours
LEAST_PAD_GAP = 1e-3  # [m] between an open finger and the object itself


class Place(NamedTuple):
    """Where the hand can work."""

    X_WT: Pose
    margin: float  # [rad] of the nearest joint limit


def best_place(
    scene: Scene, poses: Iterable[Pose], others: Sequence[Body], own: Sequence[Placed]
) -> Place | None:
    """Return the first good place, else the one with the largest margin, else None.

    Args:
        scene: The workspace.
        poses: X_WP of the middle between the pads, the plainest first.
        others: What the open hand stays clear of.
        own: What it is about to grip or has let go.
    """
    best: Place | None = None
    neighbours = [placed_body(other) for other in others]
    for X_WP in poses:
        place = tried(scene, X_WP, neighbours, own)
        if place is None:
            continue
        if place.margin >= GOOD_MARGIN:
            return place
        if best is None or place.margin > best.margin:
            best = place
    return best


def tried(
    scene: Scene, X_WP: Pose, others: Sequence[Placed], own: Sequence[Placed]
) -> Place | None:
    """Return a place with the pads at a pose, if the robot can work there."""
    robot = scene.robot
    X_WF = X_WP @ robot.gripper.X_FP.inverse()
    before = Pose(X_WF.rotation, add(X_WF.translation, scale(X_WF.approach, -APPROACH)))
    least = math.inf
    for X_BF in (before, X_WF):
        usual = [
            way
            for way in branches(robot, X_BF)
            if way.branch.shoulder is Shoulder.LEFTY and way.branch.elbow is Elbow.ABOVE
        ]
        way = max(usual, key=lambda way: way.margin.amount, default=None)
        if way is None or way.margin.amount < LEAST_MARGIN:
            return None
        least = min(least, way.margin.amount)
        parts = placed_robot(robot, way.configuration, robot.gripper.opening_max)
        moving = [part for part in parts if part.name != robot.arm.links[0].name]
        for part in moving:
            if any(near(part, other, LEAST_GAP) for other in others):
                return None
            if X_BF is X_WF and any(near(part, held, LEAST_PAD_GAP) for held in own):
                return None
    return Place(X_WF @ scene.X_FT, least)


def near(part: Placed, other: Placed, gap: float) -> bool:
    """Return whether two things are nearer to each other than a gap [m]."""
    return clearance(part, other, gap) < gap - ROUNDING
