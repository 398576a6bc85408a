"""Parts of convex polygons, in a plane or in space (Sutherland and Hodgman).

A polygon may be a point or a line as well: contacts are, too.
"""

from collections.abc import Sequence
from typing import TypeAlias, TypeVar, cast

Point: TypeAlias = tuple[float, float]
_Corner = TypeVar("_Corner", bound=tuple[float, ...])


def above(polygon: Sequence[_Corner], heights: Sequence[float]) -> list[_Corner]:
    """Return the part of a convex polygon where a linear function is not negative.

    Args:
        polygon: Its corners in order.
        heights: The values of the function at them.
    """
    kept: list[_Corner] = []
    for k, (here, a) in enumerate(zip(polygon, heights, strict=True)):
        there, b = polygon[k - len(polygon) + 1], heights[k - len(polygon) + 1]
        if a >= 0.0:
            kept.append(here)
        if a * b < 0.0:
            share = a / (a - b)
            point = tuple(p + share * (q - p) for p, q in zip(here, there, strict=True))
            kept.append(cast("_Corner", point))
    return kept


def common(subject: Sequence[Point], window: Sequence[Point]) -> list[Point]:
    """Return the common part of two convex polygons in a plane; counter-clockwise ones."""
    if len(window) < 3:
        subject, window = window, subject
    if len(window) < 3:
        return crossing(subject, window)
    found = list(subject)
    for a, b in zip(window, (*window[1:], window[0]), strict=True):
        found = above(found, [left(a, b, point) for point in found])
        if not found:
            break
    return found


def crossing(one: Sequence[Point], other: Sequence[Point]) -> list[Point]:
    """Return where two lines cross; nothing where one of them is a point, or they are parallel."""
    if len(one) < 2 or len(other) < 2:
        return []
    (a, b), (c, d) = one, other
    from_a, from_b = left(c, d, a), left(c, d, b)
    if from_a * from_b > 0.0 or left(a, b, c) * left(a, b, d) > 0.0 or from_a == from_b:
        return []
    share = from_a / (from_a - from_b)
    return [(a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1]))]


def left(a: Point, b: Point, p: Point) -> float:
    """Return twice the area of a triangle: above zero where p is to the left of a to b."""
    return (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0])
