"""Numbers, places and titles as a page for students has them."""

import math
from fractions import Fraction

from vrts.base.pose import Pose, Vector
from vrts.base.units import deg, mm
from vrts.report.plain import one_line

DECIMALS = 4  # at most: of lengths [mm], angles [degrees], times [s]
OF_POINTS = 2


def number(value: float, most: int = DECIMALS) -> str:
    """Return a number as short as it can be: 3, 2.5, 13.25."""
    return f"{round(value, most) + 0.0:.10g}"


def points(value: Fraction) -> str:
    """Return points with their unit."""
    text = number(float(value), OF_POINTS)
    return f"{text} point" if text == "1" else f"{text} points"


def place(point: Vector) -> str:
    """Return a point of W, given in m."""
    x, y, z = (number(mm(value)) for value in point)
    return f"X {x}, Y {y}, Z {z}"


def turn(X_WG: Pose) -> str:
    """Return how an object is turned about the vertical: where its X points, seen from above."""
    x, y, _ = X_WG.normal
    text = number(deg(math.atan2(y, x)))
    return f"turned by {'180' if text == '-180' else text} degrees"


def box(lower: Vector, upper: Vector) -> str:
    """Return a box of W, given in m."""
    ends = zip("XYZ", lower, upper, strict=True)
    return ", ".join(f"{axis} {number(mm(a))} to {number(mm(b))}" for axis, a, b in ends)


def title(text: str) -> str:
    """Return a title on one line that begins no comment and no tag of Markdown."""
    return one_line(text).replace("<", "&lt;")
