"""Arm branches: which of the eight solutions of the inverse kinematics a configuration lies on.

Indicators are those of [Lee1984]_: the signed reach in the arm plane, the signed bend of the elbow
and the sign of joint 5. On a boundary their sign is noise, so the branch remembered from before
counts.
"""

import math

from vrts.controllers.model import Branches
from vrts.controllers.models import USUAL
from vrts.robots.model import (
    Arm,
    ArmBranch,
    Configuration,
    Elbow,
    Shoulder,
    SphericalWristArm,
    Wrist,
)

INITIAL_BRANCH = ArmBranch(Shoulder.LEFTY, Elbow.ABOVE, Wrist.NOFLIP)  # [assumed]

ALL_BRANCHES: tuple[ArmBranch, ...] = tuple(
    ArmBranch(shoulder, elbow, wrist) for shoulder in Shoulder for elbow in Elbow for wrist in Wrist
)


def has_branches(arm: Arm) -> bool:
    """Return whether LEFTY, ABOVE, FLIP and their like mean anything to an arm.

    They do where the elbow is one joint and the wrist a sphere: in the PUMA family.
    """
    return isinstance(arm, SphericalWristArm)


def shoulder_reach(arm: SphericalWristArm, q: Configuration) -> float:
    """Return the signed reach of the wrist centre in the arm plane [m]; negative is RIGHTY."""
    q23 = q[1] + q[2]
    return arm.a2 * math.cos(q[1]) + arm.a3 * math.cos(q23) + arm.d4 * math.sin(q23)


def elbow_reach(arm: SphericalWristArm, q: Configuration) -> float:
    """Return the signed bend of the elbow [m]; zero when the arm is straight."""
    return arm.d4 * math.cos(q[2]) - arm.a3 * math.sin(q[2])


def branch_of(
    arm: Arm,
    q: Configuration,
    previous: ArmBranch | None = None,
    rules: Branches = USUAL.branches,
) -> ArmBranch:
    """Return the arm branch of a configuration.

    On a boundary the branch remembered from before counts; without one the bare sign does. READY
    lies on all three boundaries. Arms without branches keep what they have.

    Args:
        arm: The arm.
        q: The configuration [rad].
        previous: The branch remembered from before.
        rules: How wide the boundaries are [manual robots/branches#boundary].
    """
    if not isinstance(arm, SphericalWristArm):
        return previous or INITIAL_BRANCH
    reach, bend = shoulder_reach(arm, q), elbow_reach(arm, q)
    shoulder = Shoulder.RIGHTY if reach < 0.0 else Shoulder.LEFTY
    if previous is not None and abs(reach) < rules.shoulder_boundary_m:
        shoulder = previous.shoulder
    above = bend > 0.0 if shoulder is Shoulder.RIGHTY else bend < 0.0
    elbow = Elbow.ABOVE if above else Elbow.BELOW
    if previous is not None and abs(bend) < rules.elbow_boundary_m:
        elbow = previous.elbow
    wrist = Wrist.FLIP if q[4] < 0.0 else Wrist.NOFLIP
    if previous is not None and abs(q[4]) < math.radians(rules.wrist_boundary_deg):
        wrist = previous.wrist
    return ArmBranch(shoulder, elbow, wrist)
