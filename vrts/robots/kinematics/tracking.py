"""The solution that continues a straight line, from one set point of the controller to the next."""

from vrts.base.pose import Pose
from vrts.robots.kinematics.approach import approach
from vrts.robots.kinematics.limits import limit_violations
from vrts.robots.kinematics.singular import NEAR_WRIST
from vrts.robots.kinematics.spherical_wrist import solve
from vrts.robots.model import Arm, ArmBranch, Configuration, SerialArm, Wrist

WRIST_MAY_TURN = 10 * NEAR_WRIST  # [rad] of joint 5; farther from zero it keeps its sign
MOST_STEPS = 12  # from one set point to the next; two or three are usual


def track(
    arm: Arm, X_BF: Pose, branch: ArmBranch, near: Configuration
) -> tuple[Configuration, ArmBranch] | None:
    """Return the solution that continues from the set point before.

    Shoulder and elbow stay. The wrist follows continuity, so joint 5 may pass through zero. Arms
    without branches go on from `near` step by step.

    Args:
        arm: The arm.
        X_BF: Where the flange shall be.
        branch: The branch of the set point before.
        near: The configuration of the set point before.

    Returns:
        The configuration [rad], which may violate limits, and its branch; None when the pose is
        out of reach.
    """
    if isinstance(arm, SerialArm):
        found = approach(arm, X_BF, near, MOST_STEPS)
        return (found.configuration, branch) if found.reached else None
    same = solve(arm, X_BF, branch, near)
    if same is None:
        return None
    if abs(near[4]) > WRIST_MAY_TURN and not limit_violations(arm, same):
        return same, branch
    turned = branch._replace(wrist=Wrist.NOFLIP if branch.wrist is Wrist.FLIP else Wrist.FLIP)
    other = solve(arm, X_BF, turned, near)
    if other is None or _wrist_step(other, near) >= _wrist_step(same, near):
        return same, branch
    return other, turned


def _wrist_step(q: Configuration, near: Configuration) -> float:
    return max(abs(q[k] - near[k]) for k in (3, 4, 5))
