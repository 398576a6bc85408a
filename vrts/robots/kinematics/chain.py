"""Kinematics of any arm of six turning joints: frames, Jacobian, joint velocities.

Plain Python, for one configuration at a time: for many see `batch`.
"""

import math
from typing import NamedTuple

from vrts.base.pose import IDENTITY, Pose, Vector
from vrts.robots.kinematics.linear import largest_singular_value, solve_linear
from vrts.robots.model import Arm, Configuration, SerialArm


class Chain(NamedTuple):
    """Where joints and flange are at a configuration, in B."""

    axes: tuple[Vector, ...]  # unit vectors of joints 1 to 6
    points: tuple[Vector, ...]  # on them: the origins of L_1 to L_6 [m]
    X_BF: Pose


def fixed_frames(arm: Arm) -> tuple[Pose, ...]:
    """Return the poses of L_k in L_(k-1), k = 1 to 6, of the arm as it stands, joint k at zero."""
    if arm.built is not None:
        return arm.built.joints
    if isinstance(arm, SerialArm):
        return arm.joints
    offsets = ((0.0, 0.0), (0.0, 0.0), (arm.a2, arm.d2), (arm.a3, 0.0), (0.0, arm.d4), (0.0, 0.0))
    return tuple(
        Pose(_QUARTER_TURNS[twist], (a, 0.0, d))
        for (a, d), twist in zip(offsets, (0, -1, 0, 1, -1, 1), strict=True)
    )


_QUARTER_TURNS = {
    0: (1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0),
    1: (1.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 1.0, 0.0),
    -1: (1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, -1.0, 0.0),
}  # about x


def link_poses(arm: Arm, q: Configuration) -> tuple[Pose, ...]:
    """Return the poses in B of L_0 .. L_6 of the arm as it stands, each after its joint's turn."""
    pose = IDENTITY
    poses = [pose]
    for angle, before in zip(q, fixed_frames(arm), strict=True):
        c, s = math.cos(angle), math.sin(angle)
        pose = pose @ before @ Pose((c, -s, 0.0, s, c, 0.0, 0.0, 0.0, 1.0), (0.0, 0.0, 0.0))
        poses.append(pose)
    return tuple(poses)


def chain(arm: SerialArm, q: Configuration) -> Chain:
    """Return axes, points on them and the flange at a configuration."""
    r0 = r4 = r8 = 1.0
    r1 = r2 = r3 = r5 = r6 = r7 = 0.0
    px = py = pz = 0.0
    axes: list[Vector] = []
    points: list[Vector] = []
    for angle, ((j0, j1, j2, j3, j4, j5, j6, j7, j8), (x, y, z)) in zip(q, arm.joints, strict=True):
        px += r0 * x + r1 * y + r2 * z
        py += r3 * x + r4 * y + r5 * z
        pz += r6 * x + r7 * y + r8 * z
        c, s = math.cos(angle), math.sin(angle)
        # columns of what the joint puts behind its parent, turned about its third
        nx, ny, nz = c * j0 + s * j1, c * j3 + s * j4, c * j6 + s * j7
        ox, oy, oz = c * j1 - s * j0, c * j4 - s * j3, c * j7 - s * j6
        r0, r1, r2, r3, r4, r5, r6, r7, r8 = (
            r0 * nx + r1 * ny + r2 * nz,
            r0 * ox + r1 * oy + r2 * oz,
            r0 * j2 + r1 * j5 + r2 * j8,
            r3 * nx + r4 * ny + r5 * nz,
            r3 * ox + r4 * oy + r5 * oz,
            r3 * j2 + r4 * j5 + r5 * j8,
            r6 * nx + r7 * ny + r8 * nz,
            r6 * ox + r7 * oy + r8 * oz,
            r6 * j2 + r7 * j5 + r8 * j8,
        )
        axes.append((r2, r5, r8))
        points.append((px, py, pz))
    X_BL = Pose((r0, r1, r2, r3, r4, r5, r6, r7, r8), (px, py, pz))
    return Chain(tuple(axes), tuple(points), X_BL @ arm.X_LF)


def forward(arm: SerialArm, q: Configuration) -> Pose:
    """Return X_BF, the pose of the flange in the base frame."""
    return chain(arm, q).X_BF


def columns(at: Chain, length: float) -> list[tuple[float, ...]]:
    """Return the columns of the flange's Jacobian, linear velocities as shares of a length.

    Args:
        at: The arm.
        length: By which lengths are divided [m], so that rows can be compared.
    """
    fx, fy, fz = at.X_BF.translation
    found: list[tuple[float, ...]] = []
    for (ax, ay, az), (px, py, pz) in zip(at.axes, at.points, strict=True):
        x, y, z = (fx - px) / length, (fy - py) / length, (fz - pz) / length
        found.append((ay * z - az * y, az * x - ax * z, ax * y - ay * x, ax, ay, az))
    return found


def extent(arm: SerialArm) -> float:
    """Return a length no shorter than the reach of the flange from joint 2 [m]."""
    lengths = [math.hypot(*frame.translation) for frame in (*arm.joints[2:], arm.X_LF)]
    return math.fsum(lengths)


def joint_velocity(arm: SerialArm, q: Configuration, v: Vector, w: Vector) -> Configuration | None:
    """Return the joint velocities that give the flange a velocity: J(q)^-1 (v, w).

    Args:
        arm: The arm.
        q: Configuration.
        v: Linear velocity of the flange's origin, in B [m/s].
        w: Angular velocity of the flange, in B [rad/s].

    Returns:
        Six joint velocities [rad/s]; None at a singularity.
    """
    length = extent(arm)
    wanted = (*(part / length for part in v), *w)
    found = solve_linear(columns(chain(arm, q), length), (wanted,))
    if found is None:
        return None
    q1, q2, q3, q4, q5, q6 = found[0]
    return (q1, q2, q3, q4, q5, q6)


def least_singular_value(arm: SerialArm, q: Configuration, enough: float = math.inf) -> float:
    """Return how fast the hand moves at least, when the joints turn by 1 rad/s together.

    It is the smallest singular value of the flange's Jacobian, with lengths as shares of the arm's
    extent, so that its rows can be compared. The inverse tells: 1/s is its largest singular value,
    which lies between its Frobenius norm and that by the root of six.

    Args:
        arm: The arm.
        q: Configuration.
        enough: Above it the exact value does not matter: any bound from below that is larger will
            do, and costs less.
    """
    unit = [tuple(float(row == column) for row in range(6)) for column in range(6)]
    inverse = solve_linear(columns(chain(arm, q), extent(arm)), unit)
    if inverse is None:
        return 0.0
    norm = math.sqrt(math.fsum(x * x for column in inverse for x in column))
    return 1.0 / norm if norm * enough < 1.0 else 1.0 / largest_singular_value(inverse)
