"""Inverse kinematics of any arm by Levenberg's and Marquardt's method, from one start.

Each step solves (J^T J + e^2 I) dq = J^T error with the analytic Jacobian; the damping vanishes
with the error, so the last steps are Newton's and the result is exact up to rounding. No random
numbers: the same start gives the same end.
"""

import math
from typing import NamedTuple, cast

from vrts.base.pose import Pose, Vector, multiply, transpose
from vrts.robots.kinematics.chain import chain, columns, extent
from vrts.robots.kinematics.linear import solve_symmetric
from vrts.robots.model import Configuration, SerialArm

EXACT = 1e-10  # [m] and [rad] below this a pose is reached
LEAST_DAMPING = 1e-12  # of the scaled equations
LARGEST_STEP = 0.8  # [rad] a joint turns in one step


class Approach(NamedTuple):
    """How far a start led."""

    configuration: Configuration  # [rad], turns not reduced
    gap_m: float  # of the flange's origin from where it shall be
    turn_rad: float  # of its orientation
    reached: bool


def approach(
    arm: SerialArm,
    X_BF: Pose,
    start: Configuration,
    most_steps: int,
    *,
    length: float | None = None,
) -> Approach:
    """Return where the steps from a start lead, limits not enforced.

    Args:
        arm: The arm.
        X_BF: Where the flange shall be.
        start: A configuration.
        most_steps: After which the nearest configuration so far is returned.
        length: Of position that counts as much as a radian of orientation [m]; None: the arm's
            extent. It matters only where the pose is out of reach.
    """
    length = length or extent(arm)
    q = start
    best: Approach | None = None
    for _ in range(most_steps + 1):
        at = chain(arm, q)
        (x, y, z), (fx, fy, fz) = X_BF.translation, at.X_BF.translation
        turn = rotation_vector(multiply(X_BF.rotation, transpose(at.X_BF.rotation)))
        error = ((x - fx) / length, (y - fy) / length, (z - fz) / length, *turn)
        gap, angle = math.dist(X_BF.translation, at.X_BF.translation), math.hypot(*turn)
        if best is None or gap / length + angle < best.gap_m / length + best.turn_rad:
            best = Approach(q, gap, angle, gap < EXACT and angle < EXACT)
        if best.reached:
            return best
        damping = 0.5 * sum([part * part for part in error]) + LEAST_DAMPING
        step = solve_symmetric(columns(at, length), error, damping)
        largest = max(map(abs, step))
        share = LARGEST_STEP / largest if largest > LARGEST_STEP else 1.0
        q = cast(Configuration, tuple([a + share * b for a, b in zip(q, step, strict=True)]))
    assert best is not None
    return best


def rotation_vector(rotation: tuple[float, ...]) -> Vector:
    """Return axis times angle [rad] of a rotation."""
    r0, r1, r2, r3, r4, r5, r6, r7, r8 = rotation
    x, y, z = 0.5 * (r7 - r5), 0.5 * (r2 - r6), 0.5 * (r3 - r1)
    sine, cosine = math.sqrt(x * x + y * y + z * z), 0.5 * (r0 + r4 + r8 - 1.0)
    if sine > 1e-6:
        factor = math.atan2(sine, cosine) / sine
        return (factor * x, factor * y, factor * z)
    if cosine > 0.0:
        return (x, y, z)
    # half a turn: R + 1 is twice the axis times itself
    column = max(((r0 + 1.0, r3, r6), (r1, r4 + 1.0, r7), (r2, r5, r8 + 1.0)), key=_square)
    size = math.sqrt(_square(column))
    return (
        math.pi * column[0] / size,
        math.pi * column[1] / size,
        math.pi * column[2] / size,
    )


def _square(v: Vector) -> float:
    return v[0] * v[0] + v[1] * v[1] + v[2] * v[2]
