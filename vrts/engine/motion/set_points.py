"""Straight lines through the joints: set points by inverse kinematics, joined by cubics.

Set points stand every tick; between them each joint is the cubic with the exact velocity J^-1 x'
at both ends, so the tool stays on its line to a fraction of a thousandth of a millimetre.
"""

import math
from collections.abc import Callable, Sequence
from typing import NamedTuple

from vrts.base.pose import (
    Pose,
    Rotation,
    Vector,
    add,
    cross,
    dot,
    multiply,
    rotate,
    scale,
    subtract,
)
from vrts.engine.motion.paths import Course, LinePath
from vrts.engine.motion.polynomials import Row
from vrts.robots.kinematics.branch import has_branches
from vrts.robots.kinematics.kinematics import (
    forward,
    joint_velocity,
    limit_violations,
    reach_error,
)
from vrts.robots.kinematics.singular import singular_at
from vrts.robots.kinematics.tracking import track
from vrts.robots.model import Arm, ArmBranch, Configuration

Piece = tuple[float, float, tuple[Row, ...]]
"""Start and end in path time [s]; six rows of coefficients from the piece's start."""


STILL: Configuration = (0.0, 0.0, 0.0, 0.0, 0.0, 0.0)


class Offset(NamedTuple):
    """What a joint motion adds to the joints of a line while one goes over into the other."""

    q: Configuration  # [rad]
    rate: Configuration  # [rad/s]


class Obstacle(NamedTuple):
    """Why a line cannot be followed."""

    kind: str  # "too far", "too close", "limit", "singular"
    at: int  # number of the last set point that can be reached
    detail: tuple[int, float, float, float]  # joint (or 0), value, lower, upper [rad or m]


class SetPoints(NamedTuple):
    """Configurations at equal times, with their velocities."""

    times: list[float]  # path time [s]
    q: list[Configuration]
    rates: list[Configuration | None]  # None at a singularity
    branch: ArmBranch  # at the end
    crossed_wrist: bool  # joint 5 passed through zero
    near: str | None  # the singularity it came near to
    obstacle: Obstacle | None


def follow(
    arm: Arm,
    X_FT: Pose,
    times: Sequence[float],
    courses: Callable[[int], Course],
    start: tuple[Configuration, Configuration, ArmBranch],
    offsets: Callable[[int], Offset] | None = None,
) -> SetPoints:
    """Return set points along a course.

    Args:
        arm: The arm.
        X_FT: The tool.
        times: Path times of the set points, the first that of the start [s].
        courses: What is asked of the tool at the k-th time.
        start: Configuration, velocity and arm branch of the tool's course at the first time.
        offsets: What is added to the joints at the k-th time.
    """
    X_TF = X_FT.inverse()
    lever = X_TF.translation  # flange seen from the tool, in T
    q, rate, branch = start
    first = branch
    points: list[Configuration] = [_plus(q, offsets(0).q) if offsets else q]
    rates: list[Configuration | None] = [_plus(rate, offsets(0).rate) if offsets else rate]
    crossed, near = False, None

    def stopped(kind: str, k: int, detail: tuple[int, float, float, float]) -> SetPoints:
        obstacle = Obstacle(kind, k - 1, detail)
        return SetPoints(list(times[:k]), points, rates, branch, crossed, near, obstacle)

    turned: Rotation | None = None
    rotation: Rotation = X_TF.rotation  # of F in B
    carried: Vector = lever  # from T to F, in B
    for k in range(1, len(times)):
        X_BT, v, w = courses(k)
        if X_BT.rotation is not turned:  # a tool that does not turn has one rotation all along
            turned = X_BT.rotation
            rotation, carried = multiply(turned, X_TF.rotation), rotate(turned, lever)
        X_BF = Pose(rotation, add(carried, X_BT.translation))
        found = track(arm, X_BF, branch, q)
        if found is None:
            kind, excess = reach_error(arm, X_BF) or ("too far", 0.0)
            return stopped(kind, k, (0, excess, 0.0, 0.0))
        following, branch = found
        jump = _jump(arm, q, following, times[k] - times[k - 1])
        offset = offsets(k) if offsets else None
        point = following if offset is None else _plus(following, offset.q)
        violations = limit_violations(arm, point)
        if violations:
            return stopped("limit", k, violations[0])
        if jump is not None:
            return stopped("singular", k, jump)
        crossed = crossed or branch.wrist is not first.wrist
        near = near or singular_at(arm, following)
        q = following
        points.append(point)
        velocity = add(v, cross(w, carried))
        stands = velocity == w == (0.0, 0.0, 0.0)
        found_rate = STILL if stands else joint_velocity(arm, q, velocity, w)
        if found_rate is not None and offset is not None:
            found_rate = _plus(found_rate, offset.rate)
        rates.append(found_rate)
    return SetPoints(list(times), points, rates, branch, crossed, near, None)


def joined(points: SetPoints) -> list[Piece]:
    """Return the cubics through set points; velocities are estimated where undefined."""
    times, q = points.times, points.q
    rates = [_estimated(points, k) if rate is None else rate for k, rate in enumerate(points.rates)]
    pieces: list[Piece] = []
    for k in range(len(times) - 1):
        step = times[k + 1] - times[k]
        inverse = 1.0 / step
        rows = [
            (
                a,
                va,
                (3.0 * (change := b - a) * inverse - 2.0 * va - vb) * inverse,
                (va + vb - 2.0 * change * inverse) * inverse * inverse,
            )
            for a, b, va, vb in zip(q[k], q[k + 1], rates[k], rates[k + 1], strict=True)
        ]
        pieces.append((times[k], times[k + 1], tuple(rows)))
    return pieces


def deviation(arm: Arm, X_FT: Pose, path: LinePath, pieces: Sequence[Piece]) -> float:
    """Return the largest distance of the tool from a line, half-way between set points [m]."""
    if path.length < 1e-9:
        return 0.0
    origin = path.X_BT0.translation
    direction = scale(subtract(path.X_BT1.translation, origin), 1.0 / path.length)
    largest = 0.0
    for start, end, rows in pieces:
        h = 0.5 * (end - start)
        q = tuple([c[0] + h * (c[1] + h * (c[2] + h * c[3])) for c in rows])
        offset = subtract(forward(arm, q).apply(X_FT.translation), origin)  # type: ignore[arg-type]
        along = dot(offset, direction)
        largest = max(largest, dot(offset, offset) - along * along)
    return math.sqrt(max(largest, 0.0))


def _estimated(points: SetPoints, k: int) -> Configuration:
    before, after = max(k - 1, 0), min(k + 1, len(points.times) - 1)
    span = points.times[after] - points.times[before]
    return tuple([(b - a) / span for a, b in zip(points.q[before], points.q[after], strict=True)])  # type: ignore[return-value]


def _jump(
    arm: Arm, before: Configuration, after: Configuration, step_s: float
) -> tuple[int, float, float, float] | None:
    """Return the joint that would have to jump between two set points.

    On arms of the PUMA family only near a singularity: elsewhere a step above the joint's speed is
    a finding of the speed check, not a stop.
    """
    fast = None
    for joint, (a, b, speed) in enumerate(zip(before, after, arm.speed, strict=True), 1):
        if abs(b - a) > speed * step_s:
            fast = (joint, abs(b - a) / step_s, 0.0, speed)
            break
    if fast is None or not has_branches(arm):
        return fast
    if singular_at(arm, before) is None and singular_at(arm, after) is None:
        return None
    return fast


def _plus(a: Configuration, b: Configuration) -> Configuration:
    a1, a2, a3, a4, a5, a6 = a
    b1, b2, b3, b4, b5, b6 = b
    return (a1 + b1, a2 + b2, a3 + b3, a4 + b4, a5 + b5, a6 + b6)
