"""How far a point of the hand can be from the axis of each joint, in any configuration."""

import math

from vrts.base.pose import IDENTITY, Vector
from vrts.robots.kinematics.chain import fixed_frames
from vrts.robots.model import Arm, SphericalWristArm, flange_in_hand

Levers = tuple[float, float, float, float, float, float]


def levers(arm: Arm, point: Vector) -> Levers:
    """Return bounds on the distance of a point from the axes of joints 1 to 6 [m].

    They hold for the arm as it stands.

    Args:
        arm: The arm.
        point: In the flange frame F [m].
    """
    tool = math.hypot(*point)
    if arm.built is None and isinstance(arm, SphericalWristArm):
        wrist = arm.d6 + tool
        forearm = math.hypot(arm.a3, arm.d4) + wrist
        upper = arm.a2 + forearm
        return (upper + arm.d2, upper + arm.d2, forearm + arm.d2, wrist, wrist, tool)
    # from the hand inwards: a point stays as far from a joint's origin as the links between allow
    last = math.hypot(*flange_in_hand(arm).apply(point))
    found = [last]
    for frame in fixed_frames(arm)[:0:-1]:
        last += math.dist(frame.translation, IDENTITY.translation)
        found.append(last)
    six, five, four, three, two, one = found
    return (one, two, three, four, five, six)
