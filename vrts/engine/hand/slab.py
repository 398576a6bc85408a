"""How far the part of a convex piece between the pads reaches, across them.

The largest y over a convex set cut by |x| <= a, |z| <= b is the smallest value over multipliers
(s, t) of h(s, 1, t) + a |s| + b |t|, with h the reach of the set (convex duality). Multipliers are
as large as sides are steep: where the smallest value lies at the edge of the range that was looked
at, a larger one is. What comes out is never less than the truth. That is asked for hundreds of
times, so what does not change is worked out once, in the order in which
`reach(shape, rotate(...)) + dot(...)` has it: every number is the same to its last digit.
"""

import math
from collections.abc import Callable, Sequence
from typing import TypeAlias

from vrts.base.pose import Pose, Vector, dot, rotate, transpose
from vrts.geometry.shapes import Box, Cylinder, Hull, Shape
from vrts.geometry.support import Interval

SEARCH = 1.5  # multipliers of the slab's bounds are looked for within this first
STEPS = 26  # of a golden-section search: to 1e-5 of its range
WIDER, MORE = 8.0, 5  # times as far, with so many more steps: as exact as before
STEEPEST = SEARCH * WIDER**4
EDGE = 0.98  # share of the range from which on a multiplier is at its edge
NOWHERE = -100.0  # [m] less than any reach: the shape passes the slab by
NUDGE = 1e-3
X, Z = 0, 2  # axes of P
# axes in which the one that is asked for is y, and the other side of the slab x
FROM_X = Pose((0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0), (0.0, 0.0, 0.0))
FROM_Z = Pose((1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, -1.0, 0.0), (0.0, 0.0, 0.0))
SURELY = 1e-6  # [m] by which a point stays behind another, far above what rounding can do
GOLDEN = (math.sqrt(5.0) - 1.0) / 2.0
AROUND = ((1, 0), (-1, 0), (0, 1), (0, -1), (1, 1), (1, -1), (-1, 1), (-1, -1))
Slice: TypeAlias = Callable[[float], float]  # of one s, as a function of t


def slab_reach(
    shape: Shape, X_PS: Pose, sign: float, half_width: float, half_length: float
) -> float:
    """Return how far a shape within the slab reaches along +y or -y of P [m].

    Args:
        shape: In its frame S.
        X_PS: Where it is.
        sign: 1 or -1: along +y, or along -y.
        half_width: Of the slab, along x of P [m].
        half_length: Of the slab, along z of P [m].
    """
    bound = _bound(shape, X_PS, sign, half_width, half_length)
    centre = bound(0.0)(0.0)
    if all(bound(NUDGE * s)(NUDGE * t) >= centre - 1e-12 for s, t in AROUND):
        return centre
    within, steps = SEARCH, STEPS
    while True:
        if isinstance(shape, Hull):
            ahead = Hull(foremost(shape.points, X_PS, sign, within))
            bound = _bound(ahead, X_PS, sign, half_width, half_length)
        found, inside = lowest(bound, within, steps)
        if inside or within >= STEEPEST or found < NOWHERE:
            return found
        within, steps = within * WIDER, steps + MORE


def part_along(
    shape: Shape, X_PS: Pose, axis: int, half_width: float, half_length: float
) -> Interval:
    """Return from where to where along x or z of P the part of a shape within the slab goes [m].

    Args:
        shape: In its frame S.
        X_PS: Where it is.
        axis: `X` or `Z`.
        half_width: Of the slab, along x of P [m].
        half_length: Of the slab, along z of P [m].
    """
    turn = FROM_Z if axis == Z else FROM_X
    half, other = (half_length, half_width) if axis == Z else (half_width, half_length)
    X_turned = turn @ X_PS
    lower, upper = -_far(shape, X_turned, -1.0, other), _far(shape, X_turned, 1.0, other)
    return Interval(max(-half, lower), min(half, upper))


def _far(shape: Shape, X_PS: Pose, sign: float, half_width: float) -> float:
    """Return how far along +y or -y of P a shape reaches where |x| is at most a half width [m]."""
    bound = _bound(shape, X_PS, sign, half_width, 0.0)
    centre = bound(0.0)(0.0)
    if all(bound(s)(0.0) >= centre - 1e-12 for s in (NUDGE, -NUDGE)):
        return centre
    within, steps = SEARCH, STEPS
    while True:
        found, s = _smallest(lambda s: bound(s)(0.0), within, steps)
        if abs(s) < EDGE * within or within >= STEEPEST or found < NOWHERE:
            return found
        within, steps = within * WIDER, steps + MORE


def lowest(bound: Callable[[float], Slice], within: float, steps: int) -> tuple[float, bool]:
    """Return the smallest value over both multipliers, and whether it lies inside the range."""
    found, s = _smallest(lambda s: _smallest(bound(s), within, steps)[0], within, steps)
    _, t = _smallest(bound(s), within, steps)
    return found, max(abs(s), abs(t)) < EDGE * within


def _bound(
    shape: Shape, X_PS: Pose, sign: float, half_width: float, half_length: float
) -> Callable[[float], Slice]:
    """Return h(s, sign, t) + a |s| + b |t| of a shape."""
    a, b, c, d, e, f, g, h, i = transpose(X_PS.rotation)
    b, e, h = b * sign, e * sign, h * sign
    off_x, off_y, off_z = X_PS.translation
    off_y *= sign

    def sliced(s: float) -> Slice:
        x, y, z = a * s + b, d * s + e, g * s + h
        off, wide = off_x * s + off_y, half_width * abs(s)
        match shape:
            case Box(half_extents=(p, q, r)):
                return lambda t: (
                    p * abs(x + c * t)
                    + q * abs(y + f * t)
                    + r * abs(z + i * t)
                    + (off + off_z * t)
                    + wide
                    + half_length * abs(t)
                )
            case Cylinder(radius=p, half_length=r):
                return lambda t: (
                    p * math.hypot(x + c * t, y + f * t)
                    + r * abs(z + i * t)
                    + (off + off_z * t)
                    + wide
                    + half_length * abs(t)
                )
            case Hull(points=points):

                def of_points(t: float) -> float:
                    u, v, w = x + c * t, y + f * t, z + i * t
                    far = max([u * px + v * py + w * pz for px, py, pz in points])
                    return far + (off + off_z * t) + wide + half_length * abs(t)

                return of_points

    return sliced


def foremost(
    points: Sequence[Vector], X_PS: Pose, sign: float, within: float = SEARCH
) -> tuple[Vector, ...]:
    """Return the points of which one is the farthest, whatever the multipliers are.

    How far a point is grows evenly with each of them. So a point that stays behind another at all
    four corners of the range stays behind it everywhere.
    """
    back = transpose(X_PS.rotation)
    ways = [rotate(back, (within * s, sign, within * t)) for s, t in AROUND[4:]]
    far = [tuple(dot(point, way) for way in ways) for point in points]
    first = {max(range(len(points)), key=lambda k, n=n: far[k][n]) for n in range(len(ways))}
    first.add(max(range(len(points)), key=lambda k: sum(far[k])))
    ahead = [far[k] for k in first]

    def behind(own: tuple[float, ...]) -> bool:
        return any(all(u > v + SURELY for u, v in zip(one, own, strict=True)) for one in ahead)

    return tuple(point for point, own in zip(points, far, strict=True) if not behind(own))


def _smallest(function: Slice, within: float, steps: int) -> tuple[float, float]:
    """Return the smallest value of a convex function within a range, and where it is."""
    low, high = -within, within
    a, b = high - GOLDEN * (high - low), low + GOLDEN * (high - low)
    at_a, at_b = function(a), function(b)
    for _ in range(steps):
        if at_a <= at_b:
            high, b, at_b = b, a, at_a
            a = high - GOLDEN * (high - low)
            at_a = function(a)
        else:
            low, a, at_a = a, b, at_b
            b = low + GOLDEN * (high - low)
            at_b = function(b)
    return (at_a, a) if at_a <= at_b else (at_b, b)
