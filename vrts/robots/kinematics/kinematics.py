"""Kinematics of any arm, for one pose at a time: closed form where there is one, else numeric.

Plain Python: for many configurations at once see `batch`.
"""

from collections.abc import Callable

from vrts.base.pose import Pose, Vector
from vrts.robots.kinematics import chain, serial_solutions, spherical_wrist
from vrts.robots.kinematics.branch import branch_of
from vrts.robots.kinematics.chain import link_poses
from vrts.robots.kinematics.limits import limit_violations
from vrts.robots.model import Arm, ArmBranch, Configuration, SphericalWristArm

__all__ = [
    "branch_of",
    "forward",
    "hand_pose",
    "joint_velocity",
    "limit_violations",
    "link_poses",
    "reach_error",
    "solve",
    "tip",
]


def forward(arm: Arm, q: Configuration) -> Pose:
    """Return X_BF, the pose of the flange in the base frame, as the controller counts."""
    if isinstance(arm, SphericalWristArm):
        return spherical_wrist.forward(arm, q)
    return chain.forward(arm, q)


def tip(arm: Arm, point: Vector) -> Callable[[Configuration], Vector]:
    """Return what tells where a point of the flange is, for configurations [rad], in B [m].

    It is `forward(arm, q).apply(point)`, bit for bit but for the sign of zeros, at half the cost
    for a point on the axis of joint 6, where tools usually are.
    """
    if isinstance(arm, SphericalWristArm) and point[:2] == (0.0, 0.0):
        return spherical_wrist.on_axis(arm, point[2])
    return lambda q: forward(arm, q).apply(point)


def hand_pose(arm: Arm, q: Configuration) -> Pose:
    """Return where the flange really is, in the base frame: with the arm as it stands.

    `forward` tells where its controller takes it to be.
    """
    if arm.built is None:
        return forward(arm, q)
    return link_poses(arm, q)[6] @ arm.built.X_LF


def solve(arm: Arm, X_BF: Pose, branch: ArmBranch, near: Configuration) -> Configuration | None:
    """Return the configuration that puts the flange at a pose.

    Every joint is given the turn nearest `near` within its limits. Where no turn is within them,
    the one that exceeds them least is returned: `limit_violations` tells.

    Args:
        arm: The arm.
        X_BF: Pose of the flange in the base frame.
        branch: The branch the solution must lie on; arms without branches take the solution
            nearest `near`, those within limits first.
        near: The present configuration.

    Returns:
        Six joint positions [rad]; None when the pose is out of reach.
    """
    if isinstance(arm, SphericalWristArm):
        return spherical_wrist.solve(arm, X_BF, branch, near)
    return next(iter(serial_solutions.solutions(arm, X_BF, near)), None)


def reach_error(arm: Arm, X_BF: Pose) -> tuple[str, float] | None:
    """Return why a pose is out of reach, and by how much, joint limits apart.

    Returns:
        ("too far" or "too close", by how much [m]), or None when it is in reach. The amount is
        that of the wrist centre; for arms without a closed form that of the flange.
    """
    if isinstance(arm, SphericalWristArm):
        return spherical_wrist.reach_error(arm, X_BF)
    return serial_solutions.reach_error(arm, X_BF)


def joint_velocity(arm: Arm, q: Configuration, v: Vector, w: Vector) -> Configuration | None:
    """Return the joint velocities that give the flange a velocity: J(q)^-1 (v, w).

    Args:
        arm: The arm.
        q: Configuration.
        v: Linear velocity of the flange's origin, in B [m/s].
        w: Angular velocity of the flange, in B [rad/s].

    Returns:
        Six joint velocities [rad/s]; None at a singularity.
    """
    if isinstance(arm, SphericalWristArm):
        return spherical_wrist.joint_velocity(arm, q, v, w)
    return chain.joint_velocity(arm, q, v, w)
