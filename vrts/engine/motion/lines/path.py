"""The path of a straight line: where the tool is and how it moves, as functions of u, 0 to 1."""

from collections.abc import Callable
from typing import NamedTuple

from vrts.base.pose import (
    Y_AXIS,
    Z_AXIS,
    Pose,
    Rotation,
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

ZERO: Vector = (0.0, 0.0, 0.0)


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
        return self.courses()(u, rate)

    def courses(self) -> Callable[[float, float], Course]:
        """Return what does the same for many u: what they have in common is done once."""
        origin, travel = self.X_BT0, subtract(self.X_BT1.translation, self.X_BT0.translation)
        psi, theta, phi, about = self.turn
        if theta == 0.0 and phi == 0.0:
            rotation, (x0, y0, z0) = origin
            x, y, z = travel

            def straight(u: float, rate: float) -> Course:
                position = (x0 + x * u, y0 + y * u, z0 + z * u)
                return Course(Pose(rotation, position), (x * rate, y * rate, z * rate), ZERO)

            return straight
        if about is not None:
            axis = rotate(origin.rotation, about)

            def about_one_axis(u: float, rate: float) -> Course:
                return Course(self.pose(u), scale(travel, rate), scale(axis, rate * theta))

            return about_one_axis
        first = rotate(multiply(origin.rotation, rotation_about(Z_AXIS, psi)), Y_AXIS)

        def about_two_axes(u: float, rate: float) -> Course:
            X_BT = self.pose(u)
            spin = add(scale(first, rate * theta), scale(X_BT.approach, rate * phi))
            return Course(X_BT, scale(travel, rate), spin)

        return about_two_axes

    def part(self, u: float) -> "LinePath":
        """Return the first part of the path, up to u."""
        kind = LineTurn.TWO_TURNS if self.turn.axis is None else LineTurn.ONE_AXIS
        return line(self.X_BT0, self.pose(u), kind)


def line(X_BT0: Pose, X_BT1: Pose, turn: LineTurn) -> LinePath:
    """Return the straight path between two poses of the tool."""
    turns = turning if turn is LineTurn.TWO_TURNS else turning_about_one_axis
    return LinePath(X_BT0, X_BT1, turns(X_BT0.rotation, X_BT1.rotation))


def rounding(corner: Pose) -> Callable[[Course, Course], Course]:
    """Return what gives the course of a corner: what is left of one line, and begun of the next.

    The function takes the course on the line that ends at the corner, and that on the line that
    begins there. Lines whose tool does not turn have one rotation, so what is made of two such
    rotations is made once.

    Args:
        corner: The pose at which both lines meet.
    """
    back = transpose(corner.rotation)
    known: tuple[Rotation, Rotation, Rotation, Rotation] | None = None

    def course(before: Course, after: Course) -> Course:
        nonlocal known
        one, other = before.X_BT.rotation, after.X_BT.rotation
        if known is None or known[0] is not one or known[1] is not other:
            turned = multiply(one, back)
            known = one, other, turned, multiply(turned, other)
        position = subtract(
            add(before.X_BT.translation, after.X_BT.translation), corner.translation
        )
        return Course(
            Pose(known[3], position),
            add(before.v, after.v),
            add(before.w, rotate(known[2], after.w)),
        )

    return course
