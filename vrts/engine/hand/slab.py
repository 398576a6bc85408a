"""How far the part of a convex piece between the pads reaches, across them.

The largest y over a convex set cut by |x| <= a, |z| <= b is the smallest value over multipliers
(s, t) of h(s, 1, t) + a |s| + b |t|, with h the reach of the set (convex duality). That is asked
for hundreds of times, so what does not change is worked out once, in the order in which
`reach(shape, rotate(...)) + dot(...)` has it: every number is the same to its last digit.
"""

import math
from collections.abc import Callable, Sequence
from typing import TypeAlias

from vrts.base.pose import Pose, Vector, dot, rotate, transpose
from vrts.geometry.shapes import Box, Cylinder, Hull, Shape

SEARCH = 1.5  # multipliers of the slab's bounds are looked for within this
STEPS = 26  # of a golden-section search: to 1e-5 of its range
NUDGE = 1e-3
SURELY = 1e-6  # [m] by which a point stays behind another, far above what rounding can do
GOLDEN = (math.sqrt(5.0) - 1.0) / 2.0
AROUND = ((1, 0), (-1, 0), (0, 1), (0, -1), (1, 1), (1, -1), (-1, 1), (-1, -1))
CORNERS = [(SEARCH * s, SEARCH * t) for s, t in AROUND[4:]]
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
    if isinstance(shape, Hull):
        ahead = Hull(foremost(shape.points, X_PS, sign))
        bound = _bound(ahead, X_PS, sign, half_width, half_length)
    return smallest(lambda s: smallest(bound(s)))


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


def foremost(points: Sequence[Vector], X_PS: Pose, sign: float) -> tuple[Vector, ...]:
    """Return the points of which one is the farthest, whatever the multipliers are.

    How far a point is grows evenly with each of them. So a point that stays behind another at all
    four corners of the range stays behind it everywhere.
    """
    back = transpose(X_PS.rotation)
    ways = [rotate(back, (s, sign, t)) for s, t in CORNERS]
    far = [tuple(dot(point, way) for way in ways) for point in points]
    first = {max(range(len(points)), key=lambda k, n=n: far[k][n]) for n in range(len(ways))}
    first.add(max(range(len(points)), key=lambda k: sum(far[k])))
    ahead = [far[k] for k in first]

    def behind(own: tuple[float, ...]) -> bool:
        return any(all(u > v + SURELY for u, v in zip(one, own, strict=True)) for one in ahead)

    return tuple(point for point, own in zip(points, far, strict=True) if not behind(own))


def smallest(function: Slice) -> float:
    """Return the smallest value of a convex function on the search range."""
    low, high = -SEARCH, SEARCH
    a, b = high - GOLDEN * (high - low), low + GOLDEN * (high - low)
    at_a, at_b = function(a), function(b)
    for _ in range(STEPS):
        if at_a <= at_b:
            high, b, at_b = b, a, at_a
            a = high - GOLDEN * (high - low)
            at_a = function(a)
        else:
            low, a, at_a = a, b, at_b
            b = low + GOLDEN * (high - low)
            at_b = function(b)
    return min(at_a, at_b)
