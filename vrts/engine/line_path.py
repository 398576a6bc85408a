"""Straight-line motion of the tool: set points by inverse kinematics, joined by cubic pieces.

Position is linear in the path parameter u; orientation turns the approach vector about one fixed
axis while the hand turns about the approach vector, both linear in u [Paul1981]_. Set points stand
every tick; between them each joint is the cubic with the exact velocity J^-1 v at both ends.
"""

import math
from typing import NamedTuple

from vrts.base.pose import (
    Y_AXIS,
    Z_AXIS,
    Pose,
    Rotation,
    Vector,
    add,
    cross,
    distance,
    dot,
    multiply,
    rotate,
    rotation_about,
    scale,
    subtract,
    transpose,
)
from vrts.engine.joint_path import Piece
from vrts.engine.profile import Profile, profile
from vrts.robots.branch import elbow_reach, shoulder_reach
from vrts.robots.kinematics import (
    forward,
    joint_velocity,
    limit_violations,
    reach_error,
    solve,
)
from vrts.robots.model import ArmBranch, Configuration, SphericalWristArm, Wrist

NEAR_WRIST = math.radians(1.0)  # joint 5 nearer to zero counts as singular [puma.md 3.4]
NEAR_ELBOW = math.radians(1.0)  # elbow nearer to straight counts as singular [puma.md 3.4]
NEAR_SHOULDER = 10e-3  # wrist nearer to the axis of joint 1 counts as singular [m] [puma.md 3.4]


class Line(NamedTuple):
    """A path of the tool T in the base frame B, and the tool in the flange frame."""

    X_BT0: Pose
    X_BT1: Pose
    X_FT: Pose

    @property
    def length(self) -> float:
        """Distance of the ends [m]."""
        return distance(self.X_BT0.translation, self.X_BT1.translation)


class Turning(NamedTuple):
    """Paul's two rotations: about y of a frame turned by psi, and about the approach vector."""

    psi: float  # [rad]
    theta: float  # of the approach vector [rad]
    phi: float  # about the approach vector [rad]


class Obstacle(NamedTuple):
    """Why a straight line cannot be followed to its end."""

    kind: str  # "too far", "too close", "limit", "singular"
    u: float  # path parameter of the last set point that can be reached
    detail: tuple[int, float, float, float]  # joint (or 0), value, lower, upper [rad or m]


class Course(NamedTuple):
    """A straight line as generated, up to its end or to the obstacle."""

    pieces: list[Piece]
    goal: Configuration
    duration: float  # [s]
    deviation_m: float  # of the polynomials from the line
    crossed_wrist: bool  # joint 5 passed through zero
    obstacle: Obstacle | None


def turning(start: Rotation, goal: Rotation) -> Turning:
    """Return the two rotations that carry one orientation into another."""
    d = multiply(transpose(start), goal)
    theta = math.atan2(math.hypot(d[2], d[5]), d[8])
    if theta < 1e-12:
        return Turning(0.0, 0.0, math.atan2(d[3], d[0]))
    psi = math.atan2(d[5], d[2])
    phi = math.atan2(d[7], -d[6]) + psi
    return Turning(psi, theta, math.remainder(phi, math.tau))


def line_profile(
    arm: SphericalWristArm, line: Line, speed_m_s: float, angular_rad_s: float
) -> Profile:
    """Return the time scaling of a line at a tool speed and a turning speed."""
    turn = turning(line.X_BT0.rotation, line.X_BT1.rotation)
    turned = max(turn.theta, abs(turn.phi))
    needed = max(line.length / speed_m_s, turned / angular_rad_s)
    return profile(needed, arm.acceleration_time, arm.tick)


def tool_at(line: Line, turn: Turning, u: float) -> Pose:
    """Return X_BT at a path parameter."""
    (x0, y0, z0), (x1, y1, z1) = line.X_BT0.translation, line.X_BT1.translation
    position = (x0 + (x1 - x0) * u, y0 + (y1 - y0) * u, z0 + (z1 - z0) * u)
    if turn.theta == 0.0 and turn.phi == 0.0:
        return Pose(line.X_BT0.rotation, position)
    tilted = multiply(
        rotation_about(Z_AXIS, turn.psi),
        multiply(
            rotation_about(Y_AXIS, u * turn.theta),
            rotation_about(Z_AXIS, u * turn.phi - turn.psi),
        ),
    )
    return Pose(multiply(line.X_BT0.rotation, tilted), position)


def follow(
    arm: SphericalWristArm, line: Line, start: Configuration, branch: ArmBranch, scaling: Profile
) -> Course:
    """Generate a line from rest to rest.

    Shoulder and elbow stay; the wrist follows continuity, and joint 5 may pass through zero.
    """
    turn = turning(line.X_BT0.rotation, line.X_BT1.rotation)
    X_TF = line.X_FT.inverse()
    lever = X_TF.translation  # flange seen from the tool, in T
    travel = subtract(line.X_BT1.translation, line.X_BT0.translation)
    tilt_axis = rotate(multiply(line.X_BT0.rotation, rotation_about(Z_AXIS, turn.psi)), Y_AXIS)
    count = round(scaling.total / arm.tick)
    points: list[Configuration] = [start]
    rates: list[Configuration | None] = [(0.0,) * 6]  # type: ignore[list-item]
    wrist, crossed, q, last_u = branch.wrist, False, start, 0.0
    for k in range(1, count + 1):
        u, rate = scaling.at(k * arm.tick) if k < count else (1.0, 0.0)
        X_BT = tool_at(line, turn, u)
        X_BF = X_BT @ X_TF
        found = _continue(arm, X_BF, branch, wrist, q)
        if found is None:
            kind, excess = reach_error(arm, X_BF) or ("too far", 0.0)
            obstacle = Obstacle(kind, last_u, (0, excess, 0.0, 0.0))
            return Course([], q, 0.0, 0.0, crossed, obstacle)
        following, now_wrist = found
        violations = limit_violations(arm, following)
        if violations:
            return Course([], q, 0.0, 0.0, crossed, Obstacle("limit", last_u, violations[0]))
        jump = _jump(arm, q, following)
        if jump is not None:
            return Course([], q, 0.0, 0.0, crossed, Obstacle("singular", last_u, jump))
        crossed = crossed or now_wrist is not wrist
        q, wrist, last_u = following, now_wrist, u
        points.append(q)
        spin = add(scale(tilt_axis, rate * turn.theta), scale(X_BT.approach, rate * turn.phi))
        velocity = add(scale(travel, rate), cross(spin, rotate(X_BT.rotation, lever)))
        rates.append(joint_velocity(arm, q, velocity, spin))
    pieces = _hermite(points, rates, arm.tick)
    return Course(pieces, q, count * arm.tick, _deviation(arm, line, pieces), crossed, None)


def singular_at(arm: SphericalWristArm, q: Configuration) -> str | None:
    """Return which singularity a configuration is at: "wrist", "elbow" or "shoulder"."""
    if abs(shoulder_reach(arm, q)) < NEAR_SHOULDER:
        return "shoulder"
    if abs(elbow_reach(arm, q)) < math.hypot(arm.a3, arm.d4) * math.sin(NEAR_ELBOW):
        return "elbow"
    if abs(q[4]) < NEAR_WRIST:
        return "wrist"
    return None


def _continue(
    arm: SphericalWristArm, X_BF: Pose, branch: ArmBranch, wrist: Wrist, near: Configuration
) -> tuple[Configuration, Wrist] | None:
    """Return the solution nearest the last set point; the other wrist only near its singularity."""
    same = solve(arm, X_BF, ArmBranch(branch.shoulder, branch.elbow, wrist), near)
    if same is None:
        return None
    if abs(near[4]) > 10 * NEAR_WRIST and not limit_violations(arm, same):
        return same, wrist
    opposite = Wrist.NOFLIP if wrist is Wrist.FLIP else Wrist.FLIP
    other = solve(arm, X_BF, ArmBranch(branch.shoulder, branch.elbow, opposite), near)
    if other is None or _step(other, near) >= _step(same, near):
        return same, wrist
    return other, opposite


def _step(q: Configuration, near: Configuration) -> float:
    return max(abs(q[k] - near[k]) for k in (3, 4, 5))


def _jump(
    arm: SphericalWristArm, before: Configuration, after: Configuration
) -> tuple[int, float, float, float] | None:
    """Return the joint that would have to jump between two set points, near a singularity.

    Elsewhere a step above the joint's speed is a finding of the speed check, not a stop.
    """
    if singular_at(arm, before) is None and singular_at(arm, after) is None:
        return None
    for joint in range(6):
        step = abs(after[joint] - before[joint])
        if step > arm.speed[joint] * arm.tick:
            return (joint + 1, step / arm.tick, 0.0, arm.speed[joint])
    return None


def _hermite(
    points: list[Configuration], rates: list[Configuration | None], tick: float
) -> list[Piece]:
    """Return cubic pieces through set points; velocities are estimated where undefined."""
    known: list[tuple[float, ...]] = []
    for k, rate in enumerate(rates):
        if rate is None:
            before, after = points[max(k - 1, 0)], points[min(k + 1, len(points) - 1)]
            span = (min(k + 1, len(points) - 1) - max(k - 1, 0)) * tick
            known.append(tuple((b - a) / span for a, b in zip(before, after, strict=True)))
        else:
            known.append(rate)
    known[-1] = (0.0,) * 6
    pieces: list[Piece] = []
    for k in range(len(points) - 1):
        rows = tuple(
            (
                a,
                va,
                (3.0 * (b - a) / tick - 2.0 * va - vb) / tick,
                (va + vb - 2.0 * (b - a) / tick) / (tick * tick),
            )
            for a, b, va, vb in zip(points[k], points[k + 1], known[k], known[k + 1], strict=True)
        )
        pieces.append((k * tick, (k + 1) * tick, rows))
    return pieces


def _deviation(arm: SphericalWristArm, line: Line, pieces: list[Piece]) -> float:
    """Return the largest distance of the tool from the line, half-way between set points [m]."""
    if line.length < 1e-9:
        return 0.0
    direction = scale(subtract(line.X_BT1.translation, line.X_BT0.translation), 1.0 / line.length)
    largest = 0.0
    for start, end, rows in pieces:
        h = 0.5 * (end - start)
        q = tuple(c[0] + h * (c[1] + h * (c[2] + h * c[3])) for c in rows)
        tool = (forward(arm, q) @ line.X_FT).translation  # type: ignore[arg-type]
        offset: Vector = subtract(tool, line.X_BT0.translation)
        along = dot(offset, direction)
        largest = max(largest, math.sqrt(max(0.0, dot(offset, offset) - along * along)))
    return largest
