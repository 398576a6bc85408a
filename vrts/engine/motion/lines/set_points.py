"""Straight lines through the joints: set points by inverse kinematics, joined by cubics.

Set points stand every tick; between them each joint is the cubic with the exact velocity J^-1 x'
at both ends, so the tool stays on its line to a fraction of a thousandth of a millimetre.
"""

import math
from collections.abc import Callable, Sequence
from itertools import pairwise
from typing import NamedTuple

from vrts.base.pose import (
    Pose,
    Rotation,
    Vector,
    add,
    cross,
    multiply,
    rotate,
    scale,
    subtract,
)
from vrts.engine.motion.lines.passage import (
    Flange,
    Passage,
    Stand,
    crossing,
    farthest_out,
    passage,
    too_fast,
    turned,
)
from vrts.engine.motion.lines.path import Course, LinePath
from vrts.engine.motion.polynomials import Row
from vrts.robots.kinematics.kinematics import joint_velocity, tip
from vrts.robots.kinematics.limits import limit_violations, unlimited
from vrts.robots.kinematics.singular import singular_at
from vrts.robots.kinematics.tracking import track, usual_step
from vrts.robots.model import Arm, ArmBranch, Configuration, SphericalWristArm

Piece = tuple[float, float, tuple[Row, ...]]
"""Start and end in path time [s]; six rows of coefficients from the piece's start."""


MOST_TURNED = 0.5  # [rad] of a joint between set points; beyond it may be another solution

STILL: Configuration = (0.0, 0.0, 0.0, 0.0, 0.0, 0.0)


class Offset(NamedTuple):
    """What a joint motion adds to the joints of a line while one goes over into the other."""

    q: Configuration  # [rad]
    rate: Configuration  # [rad/s]


class Obstacle(NamedTuple):
    """Why a line cannot be followed."""

    kind: str  # "too far", "too close", "limit", "singular"
    at: int  # number of the last set point that can be reached
    met_s: float  # path time at which it is met, after that set point
    joint: int = 0  # from 1; 0: none
    value: float = 0.0  # [rad], [rad/s], or beyond reach [m]; at its worst on the rest of the line
    worst_s: float = 0.0  # path time of that value
    limits: tuple[float, float] = (0.0, 0.0)  # of the joint
    near: str = ""  # the singularity


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
    course: Callable[[float], Course],
    start: tuple[Configuration, Configuration, ArmBranch],
    offset: Callable[[float], Offset] | None = None,
) -> SetPoints:
    """Return set points along a course.

    The joints turn without a jump, so a joint that would have to come round from the other side is
    beyond its limit. A joint that is merely too fast stops nothing: the line is generated as
    commanded. A joint that is too fast near a singularity stops it, as on the controller.

    Args:
        arm: The arm.
        X_FT: The tool.
        times: Path times of the set points, the first that of the start [s].
        course: What is asked of the tool at a path time.
        start: Configuration, velocity and arm branch of the tool's course at the first time.
        offset: What is added to the joints at a path time.
    """
    X_TF = X_FT.inverse()
    lever = X_TF.translation  # flange seen from the tool, in T
    q, rate, branch = start
    first = branch
    free = unlimited(arm)
    begun = Offset(STILL, STILL) if offset is None else offset(times[0])
    points: list[Configuration] = [_plus(q, begun.q)]
    rates: list[Configuration | None] = [_plus(rate, begun.rate)]
    crossed, near = False, None

    def flange(time_s: float) -> Pose:
        return course(time_s).X_BT @ X_TF

    def added(time_s: float) -> Configuration:
        return STILL if offset is None else offset(time_s).q

    def stopped(obstacle: Obstacle) -> SetPoints:
        known = list(times[: obstacle.at + 1])
        return SetPoints(known, points, rates, branch, crossed, near, obstacle)

    usual = usual_step(arm) if isinstance(arm, SphericalWristArm) else None
    same: Rotation | None = None
    rotation: Rotation = X_TF.rotation  # of F in B
    carried: Vector = lever  # from T to F, in B
    for k in range(1, len(times)):
        now, step_s = times[k], times[k] - times[k - 1]
        X_BT, v, w = course(now)
        if X_BT.rotation is not same:  # a tool that does not turn has one rotation all along
            same = X_BT.rotation
            rotation, carried = multiply(same, X_TF.rotation), rotate(same, lever)
        position = add(carried, X_BT.translation)
        velocity = add(v, cross(w, carried))
        stands = velocity == w == (0.0, 0.0, 0.0)
        plus = None if offset is None else offset(now)
        if usual is not None:
            found_at_once = usual(rotation, position, velocity, w, branch, q, step_s)
            if found_at_once is not None:
                following, found_rate = found_at_once
                point = following if plus is None else _plus(following, plus.q)
                if not limit_violations(arm, point):
                    q = following
                    points.append(point)
                    if stands:
                        found_rate = STILL
                    rates.append(found_rate if plus is None else _plus(found_rate, plus.rate))
                    continue
        X_BF = Pose(rotation, position)
        found = track(free, X_BF, branch, q)
        if found is None or too_fast(arm, q, found[0], step_s):
            before = Stand(times[k - 1], q, branch)
            way = passage(free, flange, before, now)
            if way.lost_s is not None:
                return stopped(_lost(free, flange, times, k, way))
            found = way.last.q, way.last.branch
            turning = _met(arm, before, found[0], way, now)
            if turning is not None:
                return stopped(turning._replace(at=k - 1))
        following, branch_there = found
        point = following if plus is None else _plus(following, plus.q)
        violations = limit_violations(arm, point)
        if violations:
            before = Stand(times[k - 1], q, branch)
            met_s = crossing(arm, flange, before, now, added)
            joint, _, *limits = violations[0]
            reached = Stand(now, following, branch_there)
            value, worst_s = _worst(free, flange, times[k:], reached, added, joint, limits)
            return stopped(
                Obstacle("limit", k - 1, met_s, joint, value, worst_s, (limits[0], limits[1]))
            )
        branch = branch_there
        crossed = crossed or branch.wrist is not first.wrist
        near = near or singular_at(arm, following)
        q = following
        points.append(point)
        found_rate = STILL if stands else joint_velocity(arm, q, velocity, w)
        if found_rate is not None and plus is not None:
            found_rate = _plus(found_rate, plus.rate)
        rates.append(found_rate)
    return SetPoints(list(times), points, rates, branch, crossed, near, None)


def _lost(arm: Arm, flange: Flange, times: Sequence[float], k: int, way: Passage) -> Obstacle:
    """Return what ends a line between two set points, where no solution goes on."""
    lost_s = way.lost_s
    assert lost_s is not None
    out = farthest_out(arm, flange, [lost_s, *times[k:]], way.last.q)
    if out is None:
        near = singular_at(arm, way.last.q) or "singular"
        return Obstacle("singular", k - 1, lost_s, worst_s=lost_s, near=near)
    kind, excess, worst_s = out
    return Obstacle(kind, k - 1, lost_s, 0, excess, worst_s)


def _worst(
    arm: Arm,
    flange: Flange,
    times: Sequence[float],
    stand: Stand,
    added: Callable[[float], Configuration],
    joint: int,
    limits: Sequence[float],
) -> tuple[float, float]:
    """Return where a joint would be, farthest beyond its limits, and when; as far as it gets on."""
    lower, upper = limits
    q, branch = stand.q, stand.branch
    worst = q[joint - 1] + added(stand.time_s)[joint - 1]
    worst_s = stand.time_s
    for time_s in times[1:]:
        found = track(arm, flange(time_s), branch, q)
        if found is None or turned(q, found[0]) > MOST_TURNED:
            break
        q, branch = found
        value = q[joint - 1] + added(time_s)[joint - 1]
        if max(lower - value, value - upper) > max(lower - worst, worst - upper):
            worst, worst_s = value, time_s
    return worst, worst_s


def joined(points: SetPoints) -> list[Piece]:
    """Return the cubics through set points; velocities are estimated where undefined."""
    times, q = points.times, points.q
    rates = [_estimated(points, k) if rate is None else rate for k, rate in enumerate(points.rates)]
    pieces: list[Piece] = []
    starts = zip(pairwise(times), pairwise(q), pairwise(rates), strict=True)
    for (start, end), (before, after), (leaving, coming) in starts:
        a1, a2, a3, a4, a5, a6 = before
        b1, b2, b3, b4, b5, b6 = after
        v1, v2, v3, v4, v5, v6 = leaving
        w1, w2, w3, w4, w5, w6 = coming
        n = 1.0 / (end - start)
        d1, d2, d3, d4, d5, d6 = b1 - a1, b2 - a2, b3 - a3, b4 - a4, b5 - a5, b6 - a6
        rows = (
            (a1, v1, (3.0 * d1 * n - 2.0 * v1 - w1) * n, (v1 + w1 - 2.0 * d1 * n) * n * n),
            (a2, v2, (3.0 * d2 * n - 2.0 * v2 - w2) * n, (v2 + w2 - 2.0 * d2 * n) * n * n),
            (a3, v3, (3.0 * d3 * n - 2.0 * v3 - w3) * n, (v3 + w3 - 2.0 * d3 * n) * n * n),
            (a4, v4, (3.0 * d4 * n - 2.0 * v4 - w4) * n, (v4 + w4 - 2.0 * d4 * n) * n * n),
            (a5, v5, (3.0 * d5 * n - 2.0 * v5 - w5) * n, (v5 + w5 - 2.0 * d5 * n) * n * n),
            (a6, v6, (3.0 * d6 * n - 2.0 * v6 - w6) * n, (v6 + w6 - 2.0 * d6 * n) * n * n),
        )
        pieces.append((start, end, rows))
    return pieces


def deviation(arm: Arm, X_FT: Pose, path: LinePath, pieces: Sequence[Piece]) -> float:
    """Return the largest distance of the tool from a line, half-way between set points [m]."""
    if path.length < 1e-9:
        return 0.0
    origin = path.X_BT0.translation
    direction = scale(subtract(path.X_BT1.translation, origin), 1.0 / path.length)
    largest = 0.0
    where = tip(arm, X_FT.translation)
    (x0, y0, z0), (nx, ny, nz) = origin, direction
    for start, end, ((a1, b1, c1, d1), (a2, b2, c2, d2), (a3, b3, c3, d3), *wrist) in pieces:
        (a4, b4, c4, d4), (a5, b5, c5, d5), (a6, b6, c6, d6) = wrist
        h = 0.5 * (end - start)
        x, y, z = where(
            (
                a1 + h * (b1 + h * (c1 + h * d1)),
                a2 + h * (b2 + h * (c2 + h * d2)),
                a3 + h * (b3 + h * (c3 + h * d3)),
                a4 + h * (b4 + h * (c4 + h * d4)),
                a5 + h * (b5 + h * (c5 + h * d5)),
                a6 + h * (b6 + h * (c6 + h * d6)),
            )
        )
        x, y, z = x - x0, y - y0, z - z0
        along = x * nx + y * ny + z * nz
        off = x * x + y * y + z * z - along * along
        if off > largest:
            largest = off
    return math.sqrt(max(largest, 0.0))


def _estimated(points: SetPoints, k: int) -> Configuration:
    before, after = max(k - 1, 0), min(k + 1, len(points.times) - 1)
    span = points.times[after] - points.times[before]
    return tuple([(b - a) / span for a, b in zip(points.q[before], points.q[after], strict=True)])  # type: ignore[return-value]


def _met(arm: Arm, before: Stand, q: Configuration, way: Passage, end_s: float) -> Obstacle | None:
    """Return the singularity that stops a line, if it makes a joint too fast for the whole step."""
    if way.met is None:
        return None
    name, there, joint = way.met
    limit = arm.speed[joint]
    speed = abs(q[joint] - before.q[joint]) / (end_s - before.time_s)
    if speed <= limit:
        return None
    return Obstacle("singular", 0, there, joint + 1, speed, there, (-limit, limit), name)


def _plus(a: Configuration, b: Configuration) -> Configuration:
    a1, a2, a3, a4, a5, a6 = a
    b1, b2, b3, b4, b5, b6 = b
    return (a1 + b1, a2 + b2, a3 + b3, a4 + b4, a5 + b5, a6 + b6)
