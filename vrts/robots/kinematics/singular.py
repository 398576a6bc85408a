"""Where an arm is singular: directions in which the hand cannot move, however fast the joints.

What is measured is the Jacobian. That of the PUMA family falls into two of three rows: of the wrist
centre, whose determinant is a2 times the bend of the elbow times the reach of the shoulder, and of
the wrist, whose determinant is the sine of joint 5. Each factor has a unit of its own and a limit
of its own. Of other arms it is the smallest singular value of the whole, with lengths as shares of
the arm's extent [manual robots/branches#singular].
"""

import math

from vrts.base.pose import cross, scale, subtract
from vrts.robots.kinematics.branch import elbow_reach, shoulder_reach
from vrts.robots.kinematics.chain import fixed_frames, least_singular_value, link_poses
from vrts.robots.kinematics.kinematics import forward
from vrts.robots.kinematics.linear import least_right_vector
from vrts.robots.model import Arm, Configuration, SerialArm

NEAR_WRIST = math.radians(1.0)  # joint 5 nearer to zero counts as singular [assumed]
NEAR_ELBOW = math.radians(1.0)  # elbow nearer to straight counts as singular [assumed]
SINE_NEAR_ELBOW = math.sin(NEAR_ELBOW)
NEAR_SINGULAR = 0.01  # a smallest singular value below counts as singular [assumed]
NEAR_SHOULDER = 10e-3  # wrist nearer to the axis of joint 1 counts as singular [m] [assumed]


def singular_at(arm: Arm, q: Configuration) -> str | None:
    """Return which singularity a configuration is at.

    Returns:
        "wrist", "elbow" or "shoulder", and of arms without a spherical wrist "singular"; else None.
    """
    if isinstance(arm, SerialArm):
        least = least_singular_value(arm, q, NEAR_SINGULAR)
        return "singular" if least < NEAR_SINGULAR else None
    if abs(shoulder_reach(arm, q)) < NEAR_SHOULDER:
        return "shoulder"
    if abs(elbow_reach(arm, q)) < math.hypot(arm.a3, arm.d4) * SINE_NEAR_ELBOW:
        return "elbow"
    if abs(q[4]) < NEAR_WRIST:
        return "wrist"
    return None


def least_direction(arm: Arm, q: Configuration) -> list[float]:
    """Return the turns of the joints, as a unit vector, that move the hand least.

    It is the right singular vector of the smallest singular value of the flange's Jacobian, with
    lengths as shares of the lengths of the arm.
    """
    lengths = [math.hypot(*frame.translation) for frame in fixed_frames(arm)]
    length = math.fsum(lengths)
    flange = forward(arm, q).translation
    columns: list[tuple[float, ...]] = []
    for pose in link_poses(arm, q)[1:]:
        axis = pose.approach
        sweep = cross(axis, scale(subtract(flange, pose.translation), 1.0 / length))
        columns.append((*sweep, *axis))
    return least_right_vector(columns)
