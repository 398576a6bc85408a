"""The two kinds of path between two points, as functions of a parameter u from 0 to 1.

A joint path is linear in the joints. On a line the tool's position is linear in u; its orientation
turns the approach vector about one fixed axis while the hand turns about the approach vector, both
linear in u [Paul1981]_, or all of it about one axis, as the controller model has it.
"""

import math
from typing import NamedTuple, TypeAlias

from vrts.base.pose import (
    Y_AXIS,
    Z_AXIS,
    Pose,
    Rotation,
    Vector,
    add,
    distance,
    dot,
    multiply,
    rotate,
    rotation_about,
    scale,
    subtract,
    transpose,
)
from vrts.controllers.model import LineTurn, TurnMeasure
from vrts.robots.kinematics.limits import TIE
from vrts.robots.model import Configuration

NO_TURN = 1e-12  # [rad] less is rounding


class JointPath(NamedTuple):
    """From one configuration to another."""

    start: Configuration
    goal: Configuration

    def needed(self, speeds: Configuration, fraction: float) -> float:
        """Return the time the slowest joint needs at a share of its full speed [s]."""
        return max(
            abs(b - a) / (v * fraction)
            for a, b, v in zip(self.start, self.goal, speeds, strict=True)
        )

    @property
    def change(self) -> Configuration:
        """Goal minus start [rad]."""
        return tuple([b - a for a, b in zip(self.start, self.goal, strict=True)])  # type: ignore[return-value]


class Turning(NamedTuple):
    """Paul's two rotations: about y of a frame turned by psi, and about the approach vector.

    Or one, by theta about an axis; psi and phi are 0 then.
    """

    psi: float  # [rad]
    theta: float  # of the approach vector [rad]
    phi: float  # about the approach vector [rad]
    axis: Vector | None = None  # of the one rotation, in the tool's frame at the start

    def angle(self, measure: TurnMeasure) -> float:
        """Return the angle that the limit of turning speed is for [rad].

        The approach vector turns about an axis that stays at right angles to it, so the true
        angle of two turns at once is the root of the sum of their squares.
        """
        theta, phi = self.theta, abs(self.phi)
        match measure:
            case TurnMeasure.LARGER:
                return max(theta, phi)
            case TurnMeasure.SUM:
                return theta + phi
            case TurnMeasure.TRUE:
                return math.hypot(theta, phi)


class Course(NamedTuple):
    """What is asked of the tool at an instant."""

    X_BT: Pose
    v: Vector  # of T, in B [m/s]
    w: Vector  # in B [rad/s]


class LinePath(NamedTuple):
    """A path of the tool T in the base frame B."""

    X_BT0: Pose
    X_BT1: Pose
    turn: Turning

    @property
    def length(self) -> float:
        """Distance of the ends [m]."""
        return distance(self.X_BT0.translation, self.X_BT1.translation)

    @property
    def turned(self) -> float:
        """The larger of the two turns [rad]."""
        return max(self.turn.theta, abs(self.turn.phi))

    def needed(self, speed_m_s: float, angular_rad_s: float, measure: TurnMeasure) -> float:
        """Return the time at a speed of the tool and of its turning [s]."""
        return max(self.length / speed_m_s, self.turn.angle(measure) / angular_rad_s)

    def pose(self, u: float) -> Pose:
        """Return X_BT."""
        (x0, y0, z0), (x1, y1, z1) = self.X_BT0.translation, self.X_BT1.translation
        position = (x0 + (x1 - x0) * u, y0 + (y1 - y0) * u, z0 + (z1 - z0) * u)
        psi, theta, phi, axis = self.turn
        if theta == 0.0 and phi == 0.0:
            return Pose(self.X_BT0.rotation, position)
        if axis is not None:
            turned = rotation_about(axis, u * theta)
            return Pose(multiply(self.X_BT0.rotation, turned), position)
        tilted = multiply(
            rotation_about(Z_AXIS, psi),
            multiply(rotation_about(Y_AXIS, u * theta), rotation_about(Z_AXIS, u * phi - psi)),
        )
        return Pose(multiply(self.X_BT0.rotation, tilted), position)

    def course(self, u: float, rate: float) -> Course:
        """Return pose and velocity at u, with du/dt given [1/s]."""
        X_BT = self.pose(u)
        travel = subtract(self.X_BT1.translation, self.X_BT0.translation)
        psi, theta, phi, about = self.turn
        if theta == 0.0 and phi == 0.0:
            return Course(X_BT, scale(travel, rate), (0.0, 0.0, 0.0))
        if about is not None:
            spin = scale(rotate(self.X_BT0.rotation, about), rate * theta)
            return Course(X_BT, scale(travel, rate), spin)
        axis = rotate(multiply(self.X_BT0.rotation, rotation_about(Z_AXIS, psi)), Y_AXIS)
        spin = add(scale(axis, rate * theta), scale(X_BT.approach, rate * phi))
        return Course(X_BT, scale(travel, rate), spin)

    def part(self, u: float) -> "LinePath":
        """Return the first part of the path, up to u."""
        kind = LineTurn.TWO_TURNS if self.turn.axis is None else LineTurn.ONE_AXIS
        return line(self.X_BT0, self.pose(u), kind)


Path: TypeAlias = JointPath | LinePath


def line(X_BT0: Pose, X_BT1: Pose, turn: LineTurn) -> LinePath:
    """Return the straight path between two poses of the tool."""
    turns = turning if turn is LineTurn.TWO_TURNS else turning_about_one_axis
    return LinePath(X_BT0, X_BT1, turns(X_BT0.rotation, X_BT1.rotation))


def turning(start: Rotation, goal: Rotation) -> Turning:
    """Return the two rotations that carry one orientation into another.

    Where the approach vector turns right round, any way is as short: the one that needs no turn
    about it, which is a turn about one axis.
    """
    d = multiply(transpose(start), goal)
    theta = math.atan2(math.hypot(d[2], d[5]), d[8])
    if theta < NO_TURN:
        phi = _shorter(math.atan2(d[3], d[0]))
        return Turning(0.0, 0.0, phi if abs(phi) > NO_TURN else 0.0)
    if theta > math.pi - TIE:
        return _half_turn(d)
    psi = math.atan2(d[5], d[2])
    phi = math.atan2(d[7], -d[6]) + psi
    return Turning(psi, theta, _shorter(phi))


def turning_about_one_axis(start: Rotation, goal: Rotation) -> Turning:
    """Return the one rotation that carries one orientation into another, the shorter way round."""
    d = multiply(transpose(start), goal)
    twice = (d[7] - d[5], d[2] - d[6], d[3] - d[1])  # the axis, times twice the sine
    sine = math.sqrt(dot(twice, twice))
    angle = math.atan2(sine, d[0] + d[4] + d[8] - 1.0)
    if angle < NO_TURN:
        return Turning(0.0, 0.0, 0.0)
    if angle > math.pi - TIE:
        return _half_turn(d)
    return Turning(0.0, angle, 0.0, scale(twice, 1.0 / sine))


def _shorter(angle: float) -> float:
    """Return the turn that does what an angle does, the shorter way; half a turn is positive."""
    turn = math.remainder(angle, math.tau)
    return turn + math.tau if turn < TIE - math.pi else turn


def _half_turn(d: Rotation) -> Turning:
    """Return a rotation by half a turn, or a little more or less, about one axis.

    Both ways round are as long, so the axis is the one whose largest part is positive: rounding
    must not choose.
    """
    cosine = 0.5 * (d[0] + d[4] + d[8] - 1.0)
    xy, xz, yz = 0.5 * (d[1] + d[3]), 0.5 * (d[2] + d[6]), 0.5 * (d[5] + d[7])
    # 1 - cosine times the axis by itself; a column of it is along the axis
    columns = (
        (d[0] - cosine, xy, xz),
        (xy, d[4] - cosine, yz),
        (xz, yz, d[8] - cosine),
    )
    longest = max(dot(column, column) for column in columns)
    along = next(c for c in columns if dot(c, c) > longest - TIE)  # as long: the first
    axis = scale(along, 1.0 / math.sqrt(dot(along, along)))
    twice = (d[7] - d[5], d[2] - d[6], d[3] - d[1])
    angle = math.atan2(0.5 * dot(axis, twice), cosine)
    return Turning(0.0, angle if angle > 0.0 else angle + math.tau, 0.0, axis)


def rounded(before: Course, corner: Pose, after: Course) -> Course:
    """Return the course of a corner: what is left of one line, and what is begun of the next.

    Args:
        before: On the line that ends at the corner.
        corner: The pose at which both lines meet.
        after: On the line that begins there.
    """
    turned = multiply(before.X_BT.rotation, transpose(corner.rotation))
    position = subtract(add(before.X_BT.translation, after.X_BT.translation), corner.translation)
    return Course(
        Pose(multiply(turned, after.X_BT.rotation), position),
        add(before.v, after.v),
        add(before.w, rotate(turned, after.w)),
    )
