"""The two kinds of path between two points, as functions of a parameter u from 0 to 1.

A joint path is linear in the joints. On a line the tool's position is linear in u; its orientation
turns the approach vector about one fixed axis while the hand turns about the approach vector, both
linear in u [Paul1981]_.
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
    multiply,
    rotate,
    rotation_about,
    scale,
    subtract,
    transpose,
)
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
    """Paul's two rotations: about y of a frame turned by psi, and about the approach vector."""

    psi: float  # [rad]
    theta: float  # of the approach vector [rad]
    phi: float  # about the approach vector [rad]


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

    def needed(self, speed_m_s: float, angular_rad_s: float) -> float:
        """Return the time at a speed of the tool and of its turning [s]."""
        return max(self.length / speed_m_s, self.turned / angular_rad_s)

    def pose(self, u: float) -> Pose:
        """Return X_BT."""
        (x0, y0, z0), (x1, y1, z1) = self.X_BT0.translation, self.X_BT1.translation
        position = (x0 + (x1 - x0) * u, y0 + (y1 - y0) * u, z0 + (z1 - z0) * u)
        psi, theta, phi = self.turn
        if theta == 0.0 and phi == 0.0:
            return Pose(self.X_BT0.rotation, position)
        tilted = multiply(
            rotation_about(Z_AXIS, psi),
            multiply(rotation_about(Y_AXIS, u * theta), rotation_about(Z_AXIS, u * phi - psi)),
        )
        return Pose(multiply(self.X_BT0.rotation, tilted), position)

    def course(self, u: float, rate: float) -> Course:
        """Return pose and velocity at u, with du/dt given [1/s]."""
        X_BT = self.pose(u)
        travel = subtract(self.X_BT1.translation, self.X_BT0.translation)
        psi, theta, phi = self.turn
        if theta == 0.0 and phi == 0.0:
            return Course(X_BT, scale(travel, rate), (0.0, 0.0, 0.0))
        axis = rotate(multiply(self.X_BT0.rotation, rotation_about(Z_AXIS, psi)), Y_AXIS)
        spin = add(scale(axis, rate * theta), scale(X_BT.approach, rate * phi))
        return Course(X_BT, scale(travel, rate), spin)

    def part(self, u: float) -> "LinePath":
        """Return the first part of the path, up to u."""
        end = self.pose(u)
        return line(self.X_BT0, end)


Path: TypeAlias = JointPath | LinePath


def line(X_BT0: Pose, X_BT1: Pose) -> LinePath:
    """Return the straight path between two poses of the tool."""
    return LinePath(X_BT0, X_BT1, turning(X_BT0.rotation, X_BT1.rotation))


def turning(start: Rotation, goal: Rotation) -> Turning:
    """Return the two rotations that carry one orientation into another."""
    d = multiply(transpose(start), goal)
    theta = math.atan2(math.hypot(d[2], d[5]), d[8])
    if theta < NO_TURN:
        phi = math.atan2(d[3], d[0])
        return Turning(0.0, 0.0, phi if abs(phi) > NO_TURN else 0.0)
    psi = math.atan2(d[5], d[2])
    phi = math.atan2(d[7], -d[6]) + psi
    return Turning(psi, theta, math.remainder(phi, math.tau))


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
