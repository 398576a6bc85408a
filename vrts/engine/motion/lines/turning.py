"""How the hand turns on a straight line: from one orientation to another, the shorter way round.

The approach vector turns about one fixed axis while the hand turns about the approach vector, both
evenly [Paul1981]_, or all of it turns about one axis, as the controller model has it.
"""

import math
from typing import NamedTuple

from vrts.base.pose import Rotation, Vector, dot, multiply, scale, transpose
from vrts.controllers.model import TurnMeasure
from vrts.robots.kinematics.limits import TIE

NO_TURN = 1e-12  # [rad] less is rounding


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
    # psi is uncertain where theta is small; what the two turns do together is not
    small = d[8] > 0.0
    phi = math.atan2(d[3] - d[1], d[0] + d[4]) if small else math.atan2(d[7], -d[6]) + psi
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
