"""Joint limits, and which of the turns of a joint to take."""

import math

from vrts.robots.model import Arm, Configuration

TAU = 2.0 * math.pi

LIMIT_TOLERANCE = 1e-9  # [rad] a limit reached up to rounding holds
HALF_TURN_BIAS = 1e-9  # [turns] of two turns equally near, the smaller angle is taken


def limit_violations(arm: Arm, q: Configuration) -> tuple[tuple[int, float, float, float], ...]:
    """Return (joint from 1, position, lower, upper) [rad] of every joint outside its limits."""
    q1, q2, q3, q4, q5, q6 = q
    a1, a2, a3, a4, a5, a6 = arm.lower
    b1, b2, b3, b4, b5, b6 = arm.upper
    if (  # the usual case, at every set point
        a1 <= q1 <= b1
        and a2 <= q2 <= b2
        and a3 <= q3 <= b3
        and a4 <= q4 <= b4
        and a5 <= q5 <= b5
        and a6 <= q6 <= b6
    ):
        return ()
    return tuple(
        (joint, value, lower, upper)
        for joint, value, lower, upper in zip(range(1, 7), q, arm.lower, arm.upper, strict=True)
        if not lower - LIMIT_TOLERANCE <= value <= upper + LIMIT_TOLERANCE
    )


def turned(angle: float, near: float, lower: float, upper: float) -> float:
    """Return the turn of an angle nearest `near` within limits, all in rad.

    Where no turn is within them, the one that exceeds them least.
    """
    nearest = angle + TAU * round((near - angle) / TAU - HALF_TURN_BIAS)
    if lower - LIMIT_TOLERANCE <= nearest <= upper + LIMIT_TOLERANCE:
        return nearest
    best, excess = nearest, math.inf
    for turns in (-2, -1, 0, 1, 2):
        candidate = nearest + TAU * turns
        over = max(lower - candidate, candidate - upper)
        if over <= LIMIT_TOLERANCE:
            over = LIMIT_TOLERANCE - 1.0 / (1.0 + abs(candidate - near))  # within: nearest wins
        if over < excess:
            best, excess = candidate, over
    return best
