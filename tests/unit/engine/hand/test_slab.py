"""How far a piece reaches between the pads: worked out quickly, to the last digit as it is said."""

from collections.abc import Iterator
from random import Random

import pytest

from vrts.base.oat import pose_from_components
from vrts.base.pose import Pose, dot, rotate, translation, transpose
from vrts.engine.hand.slab import (
    AROUND,
    MORE,
    NOWHERE,
    NUDGE,
    SEARCH,
    STEEPEST,
    STEPS,
    WIDER,
    foremost,
    lowest,
    slab_reach,
)
from vrts.geometry.shapes import Box, Cylinder, Hull, Shape
from vrts.geometry.support import reach

HALF_WIDTH, HALF_LENGTH = 0.0125, 0.02  # [m]


def shapes(draw: Random) -> Iterator[Shape]:
    """Yield one shape of each kind; the hull has points on every side, and some inside."""
    yield Box((draw.uniform(0.005, 0.1), draw.uniform(0.005, 0.1), draw.uniform(0.005, 0.1)))
    yield Cylinder(draw.uniform(0.005, 0.05), draw.uniform(0.005, 0.1))
    points = [(draw.gauss(0, 0.03), draw.gauss(0, 0.03), draw.gauss(0, 0.03)) for _ in range(20)]
    yield Hull(tuple(points))


def plainly(shape: Shape, X_PS: Pose, sign: float) -> float:
    """Return what the module says that it works out, without any haste."""

    def bound(s: float, t: float) -> float:
        way = (s, sign, t)
        local = rotate(transpose(X_PS.rotation), way)
        outward = reach(shape, local) + dot(X_PS.translation, way)
        return outward + HALF_WIDTH * abs(s) + HALF_LENGTH * abs(t)

    centre = bound(0.0, 0.0)
    if all(bound(NUDGE * s, NUDGE * t) >= centre - 1e-12 for s, t in AROUND):
        return centre
    within, steps = SEARCH, STEPS
    while True:
        found, inside = lowest(lambda s: lambda t: bound(s, t), within, steps)
        if inside or within >= STEEPEST or found < NOWHERE:
            return found
        within, steps = within * WIDER, steps + MORE


@pytest.mark.parametrize("number", range(6))
def test_it_is_what_the_formula_says_to_the_last_digit(number: int) -> None:
    draw = Random(number)
    cut = 0
    for shape in shapes(draw):
        turns = [draw.uniform(-180.0, 180.0) for _ in range(3)]
        X_PS = pose_from_components(*(draw.uniform(-20.0, 20.0) for _ in range(3)), *turns)
        for sign in (1.0, -1.0):
            found = slab_reach(shape, X_PS, sign, HALF_WIDTH, HALF_LENGTH)
            assert found == plainly(shape, X_PS, sign)
            way = (0.0, sign, 0.0)
            whole = reach(shape, rotate(transpose(X_PS.rotation), way)) + dot(X_PS.translation, way)
            assert found <= whole + 1e-12
            cut += found < whole - 1e-6
    assert cut, "some of these stick out of the slab"


def test_points_that_are_never_the_farthest_are_left_out() -> None:
    sides = (-0.05, 0.05)
    upper = [(x, 0.05, z) for x in sides for z in sides]
    lower = [(x, -0.05, z) for x in sides for z in sides]
    beneath, raised = (0.05, 0.04, -0.05), (0.0, 0.051, 0.0)
    points = [*lower, beneath, raised, *upper]
    assert set(foremost(points, translation(0.01, 0.0, 0.0), 1.0)) == {*upper, raised}
    below = set(foremost(points, translation(0.01, 0.0, 0.0), -1.0))
    assert set(lower) <= below
    assert not below & {*upper, beneath}
