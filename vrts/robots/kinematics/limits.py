"""Joint limits, and which of the turns of a joint to take."""

import math
from dataclasses import replace
from functools import lru_cache

from vrts.robots.model import Arm, Configuration

TAU = 2.0 * math.pi

LIMIT_TOLERANCE = 1e-9  # [rad] a limit reached up to rounding holds
TIE = 1e-5  # [rad] ways that differ less are as long: single precision makes such a difference
HALF_TURN_BIAS = TIE / TAU  # [turns] of two turns equally near, the smaller angle is taken
SURELY_NEAREST = 3.0  # [rad] an angle nearer than this needs no other turn to be nearest


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


@lru_cache(maxsize=16)
def unlimited(arm: Arm) -> Arm:
    """Return an arm whose joints turn as far as they like: what a line would ask of it."""
    return replace(arm, lower=(-math.inf,) * 6, upper=(math.inf,) * 6)


def all_turned(
    angles: Configuration, near: Configuration, lower: Configuration, upper: Configuration
) -> Configuration:
    """Return the turns of all angles nearest `near` within limits, all in rad; see `turned`."""
    t1, t2, t3, t4, t5, t6 = angles
    n1, n2, n3, n4, n5, n6 = near
    a1, a2, a3, a4, a5, a6 = lower
    b1, b2, b3, b4, b5, b6 = upper
    if (  # the usual case, at every set point: the nearest turn already, and within limits
        -SURELY_NEAREST < t1 - n1 < SURELY_NEAREST
        and -SURELY_NEAREST < t2 - n2 < SURELY_NEAREST
        and -SURELY_NEAREST < t3 - n3 < SURELY_NEAREST
        and -SURELY_NEAREST < t4 - n4 < SURELY_NEAREST
        and -SURELY_NEAREST < t5 - n5 < SURELY_NEAREST
        and -SURELY_NEAREST < t6 - n6 < SURELY_NEAREST
        and a1 <= t1 <= b1
        and a2 <= t2 <= b2
        and a3 <= t3 <= b3
        and a4 <= t4 <= b4
        and a5 <= t5 <= b5
        and a6 <= t6 <= b6
    ):
        return (t1 + 0.0, t2 + 0.0, t3 + 0.0, t4 + 0.0, t5 + 0.0, t6 + 0.0)  # no minus zero
    return (
        turned(t1, n1, a1, b1),
        turned(t2, n2, a2, b2),
        turned(t3, n3, a3, b3),
        turned(t4, n4, a4, b4),
        turned(t5, n5, a5, b5),
        turned(t6, n6, a6, b6),
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
