"""What a number may be: an interval, from the lowest to the highest value, both included."""

import math
from typing import TypeAlias

from vrts.base.numbers import single

Interval: TypeAlias = tuple[float, float]

ANY: Interval = (-math.inf, math.inf)
TRUTH: Interval = (-1.0, 0.0)  # what a comparison yields
TRUE: Interval = (-1.0, -1.0)
FALSE: Interval = (0.0, 0.0)


def point(value: float) -> Interval:
    """Return a number that is known."""
    return value, value


def hull(a: Interval, b: Interval) -> Interval:
    """Return what holds both."""
    return min(a[0], b[0]), max(a[1], b[1])


def widened(old: Interval, new: Interval) -> Interval:
    """Return what holds both, and all values on that side where the new one is beyond the old."""
    return (
        old[0] if new[0] >= old[0] else -math.inf,
        old[1] if new[1] <= old[1] else math.inf,
    )


def negated(a: Interval) -> Interval:
    """Return `-a`."""
    return -a[1], -a[0]


def added(a: Interval, b: Interval) -> Interval:
    """Return `a+b`, rounded as the controller rounds."""
    return _rounded(a[0] + b[0], a[1] + b[1])


def multiplied(a: Interval, b: Interval) -> Interval:
    """Return `a*b`."""
    corners = [x * y if x and y else 0.0 for x in a for y in b]
    return _rounded(min(corners), max(corners))


def divided(a: Interval, b: Interval) -> Interval:
    """Return `a/b`; anything where `b` may be 0."""
    if b[0] <= 0.0 <= b[1]:
        return ANY
    corners = [0.0 if math.isinf(y) else x / y for x in a for y in b]
    return _rounded(min(corners), max(corners))


def truth(a: Interval) -> bool | None:
    """Return whether a condition holds; None where that is open."""
    if a == FALSE:
        return False
    return True if a[0] > 0.0 or a[1] < 0.0 else None


def of_truth(known: bool | None) -> Interval:
    """Return what a comparison yields."""
    return TRUTH if known is None else TRUE if known else FALSE


def less(a: Interval, b: Interval) -> bool | None:
    """Return whether `a < b`."""
    if a[1] < b[0]:
        return True
    return False if a[0] >= b[1] else None


def equal(a: Interval, b: Interval) -> bool | None:
    """Return whether `a == b`."""
    if a == b and a[0] == a[1]:
        return True
    return False if a[1] < b[0] or b[1] < a[0] else None


def _rounded(low: float, high: float) -> Interval:
    if math.isnan(low) or math.isnan(high):
        return ANY
    if low == high and math.isfinite(low):
        value = _single(low)
        return value, value
    return _single(low), _single(high)


def _single(value: float) -> float:
    return single(value) if abs(value) < 3e38 else math.copysign(math.inf, value)
