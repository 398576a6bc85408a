"""Closed-form kinematics of the PUMA family in VAL's joint convention, for one pose at a time.

The wrist centre decouples position from orientation [Pieper1968]_; arm branches are those of
[Lee1984]_. Plain Python: for many configurations at once see `batch`.
"""

import math
from collections.abc import Callable
from typing import TypeAlias

from vrts.base.pose import Pose, Vector
from vrts.robots.kinematics.limits import all_turned
from vrts.robots.model import (
    ArmBranch,
    Configuration,
    Elbow,
    Shoulder,
    SphericalWristArm,
    Wrist,
)

REACH_TOLERANCE = 1e-10  # relative; a pose on the border of the workspace is within reach
WRIST_SINGULAR = 1e-9  # sine of joint 5 below which joints 4 and 6 share one axis
SINGULAR = 1e-7  # [m], or sine of joint 5: below, joint velocities are undefined

Turn: TypeAlias = Callable[[float], float]


def forward(
    arm: SphericalWristArm, q: Configuration, sin: Turn = math.sin, cos: Turn = math.cos
) -> Pose:
    """Return X_BF, the pose of the flange in the base frame.

    All else is sums and products: with `sin` and `cos` of columns it takes columns of angles.
    """
    q1, q2, q3, q4, q5, q6 = q
    s1, c1 = sin(q1), cos(q1)
    s23, c23 = sin(q2 + q3), cos(q2 + q3)
    s4, c4 = sin(q4), cos(q4)
    s5, c5 = sin(q5), cos(q5)
    s6, c6 = sin(q6), cos(q6)
    rho = arm.a2 * cos(q2) + arm.a3 * c23 + arm.d4 * s23
    height = -arm.a2 * sin(q2) - arm.a3 * s23 + arm.d4 * c23
    # columns of Rz(q4) Ry(q5) Rz(q6)
    nx, ny, nz = c4 * c5 * c6 - s4 * s6, s4 * c5 * c6 + c4 * s6, -s5 * c6
    ox, oy, oz = -c4 * c5 * s6 - s4 * c6, -s4 * c5 * s6 + c4 * c6, s5 * s6
    ax, ay, az = c4 * s5, s4 * s5, c5
    # turned by the forearm, in the plane of the arm
    nu, nw = c23 * nx + s23 * nz, c23 * nz - s23 * nx
    ou, ow = c23 * ox + s23 * oz, c23 * oz - s23 * ox
    au, aw = c23 * ax + s23 * az, c23 * az - s23 * ax
    r13, r23 = c1 * au - s1 * ay, s1 * au + c1 * ay
    d2, d6 = arm.d2, arm.d6
    return Pose(
        (
            c1 * nu - s1 * ny,
            c1 * ou - s1 * oy,
            r13,
            s1 * nu + c1 * ny,
            s1 * ou + c1 * oy,
            r23,
            nw,
            ow,
            aw,
        ),
        (c1 * rho - s1 * d2 + d6 * r13, s1 * rho + c1 * d2 + d6 * r23, height + d6 * aw),
    )


def on_axis(arm: SphericalWristArm, height: float) -> Callable[[Configuration], Vector]:
    """Return what tells where a point on the axis of joint 6 is, so high above the flange [m].

    The same operations as those of `forward`, without what turns about that axis.
    """
    a2, a3, d2, d4, d6 = arm.a2, arm.a3, arm.d2, arm.d4, arm.d6
    sin, cos = math.sin, math.cos

    def where(q: Configuration) -> Vector:
        q1, q2, q3, q4, q5, _ = q
        s1, c1 = sin(q1), cos(q1)
        s23, c23 = sin(q2 + q3), cos(q2 + q3)
        s5, az = sin(q5), cos(q5)
        rho = a2 * cos(q2) + a3 * c23 + d4 * s23
        up = -a2 * sin(q2) - a3 * s23 + d4 * c23
        ax, ay = cos(q4) * s5, sin(q4) * s5
        au, aw = c23 * ax + s23 * az, c23 * az - s23 * ax
        r13, r23 = c1 * au - s1 * ay, s1 * au + c1 * ay
        return (
            r13 * height + (c1 * rho - s1 * d2 + d6 * r13),
            r23 * height + (s1 * rho + c1 * d2 + d6 * r23),
            aw * height + (up + d6 * aw),
        )

    return where


def solve(
    arm: SphericalWristArm, X_BF: Pose, branch: ArmBranch, near: Configuration
) -> Configuration | None:
    """Return the configuration that puts the flange at a pose, on one arm branch.

    Every joint is given the turn nearest `near` within its limits. Where no turn is within them,
    the one that exceeds them least is returned: `limit_violations` tells. With joint 5 at zero
    joints 4 and 6 share one axis; joint 4 then stays where `near` has it.

    Args:
        arm: The arm.
        X_BF: Pose of the flange in the base frame.
        branch: The branch the solution must lie on.
        near: The present configuration.

    Returns:
        Six joint positions [rad]; None when the wrist centre is out of reach.
    """
    (r11, r12, r13, r21, r22, r23, r31, r32, r33), (px, py, pz) = X_BF
    a2, a3, d2, d4, d6 = arm.a2, arm.a3, arm.d2, arm.d4, arm.d6
    x, y, z = px - d6 * r13, py - d6 * r23, pz - d6 * r33  # wrist centre
    level = x * x + y * y
    rho2 = level - d2 * d2
    if rho2 < 0.0:
        if rho2 < -REACH_TOLERANCE * (level + d2 * d2):
            return None
        rho2 = 0.0
    forearm2 = a3 * a3 + d4 * d4
    forearm = math.sqrt(forearm2)
    bend = (rho2 + z * z - a2 * a2 - forearm2) / (2.0 * a2 * forearm)
    if bend > 1.0 or bend < -1.0:
        if abs(bend) > 1.0 + REACH_TOLERANCE:
            return None
        bend = math.copysign(1.0, bend)
    shoulder, elbow, wrist = branch
    lefty = shoulder is Shoulder.LEFTY
    rho = math.sqrt(rho2) if lefty else -math.sqrt(rho2)
    opening = math.acos(bend)
    straight = math.atan2(d4, a3)
    t3 = straight + opening if lefty is (elbow is Elbow.ABOVE) else straight - opening
    s3, c3 = math.sin(t3), math.cos(t3)
    t1 = math.atan2(y, x) - math.atan2(d2, rho)
    t2 = math.atan2(-z, rho) - math.atan2(a3 * s3 - d4 * c3, a2 + a3 * c3 + d4 * s3)
    s1, c1 = math.sin(t1), math.cos(t1)
    s23, c23 = math.sin(t2 + t3), math.cos(t2 + t3)
    # the hand seen from the forearm
    au = c1 * r13 + s1 * r23
    ax, ay, az = c23 * au - s23 * r33, c1 * r23 - s1 * r13, s23 * au + c23 * r33
    s5 = math.sqrt(ax * ax + ay * ay)
    if s5 > WRIST_SINGULAR:
        if wrist is Wrist.FLIP:
            t4, t5 = math.atan2(-ay, -ax), math.atan2(-s5, az)
        else:
            t4, t5 = math.atan2(ay, ax), math.atan2(s5, az)
    else:
        t4, t5 = near[3], (0.0 if az > 0.0 else math.pi)
    s4, c4 = math.sin(t4), math.cos(t4)
    nx, ny = c23 * (c1 * r11 + s1 * r21) - s23 * r31, c1 * r21 - s1 * r11
    ox, oy = c23 * (c1 * r12 + s1 * r22) - s23 * r32, c1 * r22 - s1 * r12
    t6 = math.atan2(c4 * ny - s4 * nx, c4 * oy - s4 * ox)
    return all_turned((t1, t2, t3, t4, t5, t6), near, arm.lower, arm.upper)


def reach_error(arm: SphericalWristArm, X_BF: Pose) -> tuple[str, float] | None:
    """Return why no branch reaches a pose, and by how much, joint limits apart.

    Returns:
        ("too far" or "too close", excess of the wrist centre [m]), or None when it is in reach.
    """
    ax, ay, az = X_BF.approach
    px, py, pz = X_BF.translation
    x, y, z = px - arm.d6 * ax, py - arm.d6 * ay, pz - arm.d6 * az
    level = x * x + y * y
    rho2 = level - arm.d2 * arm.d2
    if rho2 < -REACH_TOLERANCE * (level + arm.d2 * arm.d2):
        return ("too close", arm.d2 - math.sqrt(level))
    forearm = math.hypot(arm.a3, arm.d4)
    reach = math.sqrt(max(rho2, 0.0) + z * z)
    slack = REACH_TOLERANCE * arm.a2 * forearm
    if reach * reach > (arm.a2 + forearm) ** 2 + 2.0 * slack:
        return ("too far", reach - arm.a2 - forearm)
    if reach * reach < (arm.a2 - forearm) ** 2 - 2.0 * slack:
        return ("too close", abs(arm.a2 - forearm) - reach)
    return None


def joint_velocity(
    arm: SphericalWristArm, q: Configuration, v: Vector, w: Vector
) -> Configuration | None:
    """Return the joint velocities that give the flange a velocity: J(q)^-1 (v, w).

    The wrist centre takes the first three joints, the hand's turning relative to the forearm the
    last three, so the 6 x 6 system falls into two of 3 x 3 solved in closed form [Pieper1968]_.

    Args:
        arm: The arm.
        q: Configuration.
        v: Linear velocity of the flange's origin, in B [m/s].
        w: Angular velocity of the flange, in B [rad/s].

    Returns:
        Six joint velocities [rad/s]; None at a singularity.
    """
    q1, q2, q3, q4, q5, _ = q
    s1, c1 = math.sin(q1), math.cos(q1)
    s23, c23 = math.sin(q2 + q3), math.cos(q2 + q3)
    s4, c4 = math.sin(q4), math.cos(q4)
    s5, c5 = math.sin(q5), math.cos(q5)
    rho = arm.a2 * math.cos(q2) + arm.a3 * c23 + arm.d4 * s23
    height = -arm.a2 * math.sin(q2) - arm.a3 * s23 + arm.d4 * c23
    fore_u, fore_w = arm.a3 * c23 + arm.d4 * s23, arm.d4 * c23 - arm.a3 * s23
    # approach vector: in the forearm, then in the arm plane (u outwards, y sideways, z up)
    ax, ay, az = c4 * s5, s4 * s5, c5
    au, aw = c23 * ax + s23 * az, c23 * az - s23 * ax
    vu, vy, vz = c1 * v[0] + s1 * v[1], c1 * v[1] - s1 * v[0], v[2]
    wu, wy, wz = c1 * w[0] + s1 * w[1], c1 * w[1] - s1 * w[0], w[2]
    # velocity of the wrist centre: flange minus w x (d6 a)
    d6 = arm.d6
    cu = vu - d6 * (wy * aw - wz * ay)
    cy = vy - d6 * (wz * au - wu * aw)
    cz = vz - d6 * (wu * ay - wy * au)
    # J: joint 1 gives (-d2, rho, 0); joint 2 (height, 0, -rho); joint 3 (fore_w, 0, -fore_u)
    determinant = height * -fore_u + fore_w * rho
    if abs(rho) < SINGULAR or abs(determinant) < SINGULAR or abs(s5) < SINGULAR:
        return None
    d1 = cy / rho
    ru = cu + arm.d2 * d1
    t2 = (ru * -fore_u - fore_w * cz) / determinant
    t3 = (height * cz + rho * ru) / determinant
    # what is left for the wrist, seen from the forearm: axes z; (-s4, c4, 0); (c4 s5, s4 s5, c5)
    ru, ry, rz = wu, wy - t2 - t3, wz - d1
    lx, ly, lz = c23 * ru - s23 * rz, ry, s23 * ru + c23 * rz
    d6_rate = (c4 * lx + s4 * ly) / s5
    d5_rate = c4 * ly - s4 * lx
    d4_rate = lz - c5 * d6_rate
    return (d1, t2, t3, d4_rate, d5_rate, d6_rate)
