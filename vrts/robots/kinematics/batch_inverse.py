"""Closed-form inverse kinematics of the PUMA family for many poses at once, in numpy.

The same formulas as `spherical_wrist.solve`, by columns.
"""

from typing import TypeAlias

import numpy as np
import numpy.typing as npt

from vrts.robots.kinematics.limits import HALF_TURN_BIAS, LIMIT_TOLERANCE, TAU
from vrts.robots.kinematics.spherical_wrist import REACH_TOLERANCE, WRIST_SINGULAR
from vrts.robots.model import ArmBranch, Elbow, Shoulder, SphericalWristArm, Wrist

Array: TypeAlias = npt.NDArray[np.float64]


def solve_batch(
    arm: SphericalWristArm, rotations: Array, origins: Array, branch: ArmBranch, near: Array
) -> Array:
    """Return the configurations that put the flange at poses, on one arm branch.

    Every joint is given the turn nearest `near` within its limits; where none is within them, the
    one that exceeds them least.

    Args:
        arm: The arm.
        rotations: Of the flange in B, shape (n, 3, 3).
        origins: Of the flange in B, shape (n, 3), in m.
        branch: The branch the solutions must lie on.
        near: Present configurations, shape (n, 6) or (6,) [rad].

    Returns:
        Shape (n, 6) [rad]; rows of NaN where the wrist centre is out of reach.
    """
    count = len(origins)
    start: Array = np.broadcast_to(near, (count, 6)).T
    r11, r12, r13, r21, r22, r23, r31, r32, r33 = rotations.reshape(count, 9).T
    a2, a3, d2, d4, d6 = arm.a2, arm.a3, arm.d2, arm.d4, arm.d6
    px, py, pz = origins.T
    x, y, z = px - d6 * r13, py - d6 * r23, pz - d6 * r33  # wrist centre
    level = x * x + y * y
    rho2 = level - d2 * d2
    forearm2 = a3 * a3 + d4 * d4
    bend = (rho2 + z * z - a2 * a2 - forearm2) / (2.0 * a2 * np.sqrt(forearm2))
    lost = (rho2 < -REACH_TOLERANCE * (level + d2 * d2)) | (np.abs(bend) > 1.0 + REACH_TOLERANCE)
    lefty = branch.shoulder is Shoulder.LEFTY
    rho = np.sqrt(np.maximum(rho2, 0.0)) * (1.0 if lefty else -1.0)
    opening = np.arccos(np.clip(bend, -1.0, 1.0))
    t3 = np.arctan2(d4, a3) + (opening if lefty is (branch.elbow is Elbow.ABOVE) else -opening)
    s3, c3 = np.sin(t3), np.cos(t3)
    t1 = np.arctan2(y, x) - np.arctan2(d2, rho)
    t2 = np.arctan2(-z, rho) - np.arctan2(a3 * s3 - d4 * c3, a2 + a3 * c3 + d4 * s3)
    s1, c1 = np.sin(t1), np.cos(t1)
    s23, c23 = np.sin(t2 + t3), np.cos(t2 + t3)
    # the hand seen from the forearm
    au = c1 * r13 + s1 * r23
    ax, ay, az = c23 * au - s23 * r33, c1 * r23 - s1 * r13, s23 * au + c23 * r33
    s5 = np.sqrt(ax * ax + ay * ay)
    sign = -1.0 if branch.wrist is Wrist.FLIP else 1.0
    straight = s5 <= WRIST_SINGULAR
    t4: Array = np.arctan2(sign * ay, sign * ax)
    t5: Array = np.arctan2(sign * s5, az)
    if straight.any():
        t4[straight] = start[3][straight]
        t5[straight] = np.pi * (az[straight] <= 0.0)
    s4, c4 = np.sin(t4), np.cos(t4)
    nx, ny = c23 * (c1 * r11 + s1 * r21) - s23 * r31, c1 * r21 - s1 * r11
    ox, oy = c23 * (c1 * r12 + s1 * r22) - s23 * r32, c1 * r22 - s1 * r12
    t6 = np.arctan2(c4 * ny - s4 * nx, c4 * oy - s4 * ox)
    q: Array = np.stack([t1, t2, t3, t4, t5, t6])
    for joint in range(6):
        q[joint] = _turned(q[joint], start[joint], arm.lower[joint], arm.upper[joint])
    q[:, lost] = np.nan
    return q.T


def _turned(angle: Array, near: Array, lower: float, upper: float) -> Array:
    """Return the turns of angles nearest `near` within limits, as `limits.turned` does."""
    nearest = angle + TAU * np.round((near - angle) / TAU - HALF_TURN_BIAS)
    beyond = (nearest < lower - LIMIT_TOLERANCE) | (nearest > upper + LIMIT_TOLERANCE)
    which = np.nonzero(beyond)[0]
    if not len(which):
        return nearest
    turns = TAU * np.array([-2.0, -1.0, 0.0, 1.0, 2.0])
    candidates = nearest[which, None] + turns
    over = np.maximum(lower - candidates, candidates - upper)
    apart = np.abs(candidates - near[which, None])
    within = over <= LIMIT_TOLERANCE
    over = np.where(within, LIMIT_TOLERANCE - 1.0 / (1.0 + apart), over)
    nearest[which] = candidates[np.arange(len(which)), over.argmin(axis=1)]
    return nearest
