"""The path of a straight line: where the tool is and how it moves, as functions of u, 0 to 1."""

from typing import NamedTuple

from vrts.base.pose import (
    Y_AXIS,
    Z_AXIS,
    Pose,
    Vector,
    add,
    distance,
    multiply,
    rotate,
    rotation_about,
    scale,
    subtract,
    transpose,
)
from vrts.controllers.model import LineTurn, TurnMeasure
from vrts.engine.motion.lines.turning import Turning, turning, turning_about_one_axis


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


def line(X_BT0: Pose, X_BT1: Pose, turn: LineTurn) -> LinePath:
    """Return the straight path between two poses of the tool."""
    turns = turning if turn is LineTurn.TWO_TURNS else turning_about_one_axis
    return LinePath(X_BT0, X_BT1, turns(X_BT0.rotation, X_BT1.rotation))


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
