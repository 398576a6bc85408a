"""Where an arm is singular: directions in which the hand cannot move, however fast the joints."""

import math

from vrts.robots.kinematics.branch import elbow_reach, shoulder_reach
from vrts.robots.kinematics.chain import near_singular
from vrts.robots.model import Arm, Configuration, SerialArm

NEAR_WRIST = math.radians(1.0)  # joint 5 nearer to zero counts as singular [assumed]
NEAR_ELBOW = math.radians(1.0)  # elbow nearer to straight counts as singular [assumed]
SINE_NEAR_ELBOW = math.sin(NEAR_ELBOW)
NEAR_SHOULDER = 10e-3  # wrist nearer to the axis of joint 1 counts as singular [m] [assumed]


def singular_at(arm: Arm, q: Configuration) -> str | None:
    """Return which singularity a configuration is at.

    Returns:
        "wrist", "elbow" or "shoulder", and of arms without a spherical wrist "singular"; else None.
    """
    if isinstance(arm, SerialArm):
        return "singular" if near_singular(arm, q) else None
    if abs(shoulder_reach(arm, q)) < NEAR_SHOULDER:
        return "shoulder"
    if abs(elbow_reach(arm, q)) < math.hypot(arm.a3, arm.d4) * SINE_NEAR_ELBOW:
        return "elbow"
    if abs(q[4]) < NEAR_WRIST:
        return "wrist"
    return None
