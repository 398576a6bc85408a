"""The solution that continues a straight line, from one set point of the controller to the next."""

import math
from collections.abc import Callable
from typing import TypeAlias

from vrts.base.pose import Pose, Rotation, Vector
from vrts.robots.kinematics.approach import approach
from vrts.robots.kinematics.limits import SURELY_NEAREST, limit_violations
from vrts.robots.kinematics.singular import NEAR_SHOULDER, NEAR_WRIST, SINE_NEAR_ELBOW
from vrts.robots.kinematics.spherical_wrist import SINGULAR, WRIST_SINGULAR, solve
from vrts.robots.model import (
    Arm,
    ArmBranch,
    Configuration,
    Elbow,
    SerialArm,
    Shoulder,
    SphericalWristArm,
    Wrist,
)

UsualStep: TypeAlias = Callable[
    [Rotation, Vector, Vector, Vector, ArmBranch, Configuration, float],
    tuple[Configuration, Configuration] | None,
]
"""Of X_BF, its velocities in B, the branch, the configuration before, and the seconds since."""

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


def usual_step(arm: SphericalWristArm) -> UsualStep:
    """Return what does at once, for a set point with nothing about it, all that is done for one.

    The function returns configuration [rad] and joint velocities [rad/s]: the same numbers, bit
    for bit, as `track` of an arm without limits and `joint_velocity`, which share most of their
    sines and cosines. It returns None where somebody has to look closely: out of reach, near a
    singularity, where the wrist may turn over, or where a joint is faster than it may be.
    """
    a2, a3, d2, d4, d6 = arm.a2, arm.a3, arm.d2, arm.d4, arm.d6
    sin, cos, atan2, sqrt = math.sin, math.cos, math.atan2, math.sqrt
    forearm2, squared_d2, squared_a2 = a3 * a3 + d4 * d4, d2 * d2, a2 * a2
    twice = 2.0 * a2 * sqrt(forearm2)
    straight = atan2(d4, a3)
    near_elbow = math.hypot(a3, d4) * SINE_NEAR_ELBOW
    s1_, s2_, s3_, s4_, s5_, s6_ = arm.speed
    longest = 0.9 * SURELY_NEAREST / max(arm.speed)  # [s] in which no joint comes round

    def step(
        rotation: Rotation,
        position: Vector,
        v: Vector,
        w: Vector,
        branch: ArmBranch,
        near: Configuration,
        step_s: float,
    ) -> tuple[Configuration, Configuration] | None:
        r11, r12, r13, r21, r22, r23, r31, r32, r33 = rotation
        px, py, pz = position
        n1, n2, n3, n4, n5, n6 = near
        if step_s > longest or -WRIST_MAY_TURN <= n5 <= WRIST_MAY_TURN:
            return None
        # as `spherical_wrist.solve` has it
        x, y, z = px - d6 * r13, py - d6 * r23, pz - d6 * r33
        rho2 = x * x + y * y - squared_d2
        if rho2 < 0.0:
            return None
        bend = (rho2 + z * z - squared_a2 - forearm2) / twice
        if not -1.0 <= bend <= 1.0:
            return None
        shoulder, elbow, wrist = branch
        lefty = shoulder is Shoulder.LEFTY
        rho = sqrt(rho2) if lefty else -sqrt(rho2)
        opening = math.acos(bend)
        t3 = straight + opening if lefty is (elbow is Elbow.ABOVE) else straight - opening
        s3, c3 = sin(t3), cos(t3)
        t1 = atan2(y, x) - atan2(d2, rho)
        t2 = atan2(-z, rho) - atan2(a3 * s3 - d4 * c3, a2 + a3 * c3 + d4 * s3)
        t23 = t2 + t3
        s1, c1 = sin(t1), cos(t1)
        s23, c23 = sin(t23), cos(t23)
        au = c1 * r13 + s1 * r23
        ax, ay, az = c23 * au - s23 * r33, c1 * r23 - s1 * r13, s23 * au + c23 * r33
        s5 = sqrt(ax * ax + ay * ay)
        if s5 <= WRIST_SINGULAR:
            return None
        if wrist is Wrist.FLIP:
            t4, t5 = atan2(-ay, -ax), atan2(-s5, az)
        else:
            t4, t5 = atan2(ay, ax), atan2(s5, az)
        s4, c4 = sin(t4), cos(t4)
        nx, ny = c23 * (c1 * r11 + s1 * r21) - s23 * r31, c1 * r21 - s1 * r11
        ox, oy = c23 * (c1 * r12 + s1 * r22) - s23 * r32, c1 * r22 - s1 * r12
        t6 = atan2(c4 * ny - s4 * nx, c4 * oy - s4 * ox)
        if not (
            abs(t1 - n1) <= s1_ * step_s
            and abs(t2 - n2) <= s2_ * step_s
            and abs(t3 - n3) <= s3_ * step_s
            and abs(t4 - n4) <= s4_ * step_s
            and abs(t5 - n5) <= s5_ * step_s
            and abs(t6 - n6) <= s6_ * step_s
            and t1  # of zeros the sign would matter
            and t2
            and t3
            and t23
            and t4
        ):
            return None
        # as `singular_at` and `spherical_wrist.joint_velocity` have it
        s2, c2, s5, c5 = sin(t2), cos(t2), sin(t5), cos(t5)
        fore_u, fore_w = a3 * c23 + d4 * s23, d4 * c23 - a3 * s23
        rho = a2 * c2 + a3 * c23 + d4 * s23
        height = -a2 * s2 - a3 * s23 + d4 * c23
        determinant = height * -fore_u + fore_w * rho
        if (
            -NEAR_SHOULDER < rho < NEAR_SHOULDER
            or abs(d4 * c3 - a3 * s3) < near_elbow
            or -NEAR_WRIST < t5 < NEAR_WRIST
            or -SINGULAR < determinant < SINGULAR
            or -SINGULAR < s5 < SINGULAR
        ):
            return None
        ax, ay, az = c4 * s5, s4 * s5, c5
        au, aw = c23 * ax + s23 * az, c23 * az - s23 * ax
        vx, vy, cz = v
        wx, wy, wz = w
        vu, vy = c1 * vx + s1 * vy, c1 * vy - s1 * vx
        wu, wy = c1 * wx + s1 * wy, c1 * wy - s1 * wx
        cu = vu - d6 * (wy * aw - wz * ay)
        cy = vy - d6 * (wz * au - wu * aw)
        cz -= d6 * (wu * ay - wy * au)
        d1 = cy / rho
        ru = cu + d2 * d1
        rate2 = (ru * -fore_u - fore_w * cz) / determinant
        rate3 = (height * cz + rho * ru) / determinant
        ly, rz = wy - rate2 - rate3, wz - d1
        lx, lz = c23 * wu - s23 * rz, s23 * wu + c23 * rz
        rate6 = (c4 * lx + s4 * ly) / s5
        rates = (d1, rate2, rate3, lz - c5 * rate6, c4 * ly - s4 * lx, rate6)
        return (t1, t2, t3, t4, t5, t6 + 0.0), rates

    return step
