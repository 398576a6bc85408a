"""Proven distances of two shapes: closed forms, coal, and a programme that minimises."""

import math
import subprocess
import sys
from typing import Any, TypeAlias

import numpy as np
import numpy.typing as npt
import pytest
from scipy import optimize

from tests.unit.geometry.proving.shapes_placed import corners, pose, shape, turned
from vrts.base.pose import IDENTITY, IDENTITY_ROTATION, Pose, translation
from vrts.geometry import coal_engine
from vrts.geometry.proving.scalar import Proven, between, nearest
from vrts.geometry.shapes import Box, Cylinder, Hull, Piece, Shape
from vrts.geometry.support import reach

Array: TypeAlias = npt.NDArray[np.float64]

CUBE = Box((0.1, 0.1, 0.1))
CAN = Cylinder(0.03, 0.05)
WEDGE = Hull(((-0.1, 0.0, 0.0), (0.1, 0.0, 0.0), (0.0, 0.1, 0.0), (0.0, 0.0, 0.1)))
EDGE = turned(math.pi / 4)  # an edge of a cube along z points along x
ERROR = 1e-8  # [m]


def at(x: float, y: float = 0.0, z: float = 0.0) -> Pose:
    return translation(x, y, z)


@pytest.mark.parametrize(
    ("first", "second", "X_AB", "distance"),
    [
        (CUBE, CUBE, at(0.3), 0.1),
        (CUBE, CUBE, at(0.2), 0.0),  # faces touch exactly
        (CUBE, CUBE, at(0.2, 0.2), 0.0),  # edges do
        (CUBE, CUBE, at(0.2, 0.2, 0.2), 0.0),  # corners do
        (CUBE, CUBE, at(0.0), -0.2),  # one and the same
        (CUBE, CUBE, at(0.19), -0.01),
        (CUBE, CUBE, at(0.3, 0.3), math.sqrt(0.02)),
        (CUBE, CUBE, Pose(EDGE, (0.1 + math.sqrt(0.02), 0.0, 0.0)), 0.0),  # an edge on a face
        (CUBE, CUBE, Pose(EDGE, (0.25, 0.0, 0.0)), 0.15 - math.sqrt(0.02)),
        (CUBE, CAN, at(0.13), 0.0),  # a round side on a face
        (CUBE, CAN, at(0.0, 0.0, 0.15), 0.0),  # a cap on a face
        (CUBE, CAN, at(0.0, 0.0, 0.1501), 1e-4),
        (CUBE, CAN, at(0.13 - 2e-4), -2e-4),
        (CAN, CAN, at(0.06), 0.0),
        (CAN, CAN, at(0.0, 0.0, 0.1), 0.0),  # coaxial, caps touch
        (CAN, CAN, at(0.05, 0.0, 0.09), -0.01),
        (CAN, CAN, at(0.09, 0.0, 0.14), 0.05),
        (CUBE, WEDGE, at(0.0, 0.0, 0.1), 0.0),
        (CUBE, WEDGE, at(0.0, 0.0, 0.101), 0.001),
        (WEDGE, CUBE, at(0.0, 0.0, 0.2), 0.0),  # a corner on a face
    ],
)
def test_closed_forms(first: Shape, second: Shape, X_AB: Pose, distance: float) -> None:
    for tilt in (
        IDENTITY,
        Pose((0.36, 0.48, -0.8, -0.8, 0.6, 0.0, 0.48, 0.64, 0.6), (1.0, 2.0, 3.0)),
    ):
        for turn in (True, False):
            placed = [(first, tilt), (second, tilt @ X_AB)]
            (a, X_WA), (b, X_WB) = placed[::-1] if turn else placed
            found = between(a, X_WA, b, X_WB)
            assert found.lower - ERROR <= distance <= found.upper + ERROR
            assert found.error < ERROR
            proof_holds(found, a, b, X_WA, X_WB)


def proof_holds(found: Proven, a: Shape, b: Shape, X_WA: Pose, X_WB: Pose) -> None:
    """What is claimed can be seen from the direction and the points alone."""
    n = np.array(found.normal)
    assert np.linalg.norm(n) == pytest.approx(1.0, abs=1e-12)
    R_a, R_b = (np.array(X.rotation).reshape(3, 3) for X in (X_WA, X_WB))
    o_a, o_b = np.array(X_WA.translation), np.array(X_WB.translation)
    gap = float(n @ (o_b - o_a)) - reach(a, tuple(R_a.T @ n)) - reach(b, tuple(-R_b.T @ n))
    assert found.lower <= gap + 1e-12
    x, y = np.array(found.first), np.array(found.second)
    assert abs(np.linalg.norm(y - x) - abs(found.upper)) < ERROR
    for point, of, R, o in ((x, a, R_a, o_a), (y, b, R_b, o_b)):
        for way in np.random.default_rng(1).normal(size=(200, 3)):
            assert way @ (point - o) <= reach(of, tuple(R.T @ way)) + 1e-9
    if found.upper > 1e-6:
        assert float(n @ (y - x)) == pytest.approx(found.upper, abs=1e-7)


@pytest.mark.thorough
def test_against_coal_where_it_is_right() -> None:
    chance = np.random.default_rng(16)
    for _ in range(300):
        a, b, X_WA, X_WB = shape(chance), shape(chance), pose(chance), pose(chance)
        found = between(a, X_WA, b, X_WB)
        coal = coal_engine.nearest(Piece(a, IDENTITY), X_WA, Piece(b, IDENTITY), X_WB)
        assert found.error < ERROR
        assert abs(found.distance - coal.distance) < 2e-5
        if coal.distance > 1e-3:
            assert abs(found.distance - coal.distance) < coal_engine.ERROR
        proof_holds(found, a, b, X_WA, X_WB)


def test_against_a_quadratic_programme() -> None:
    # weights of the corners, none below zero, one in sum; the distance of the points they make
    chance = np.random.default_rng(7)
    shapes = [CUBE, WEDGE, Hull(tuple(map(tuple, chance.normal(size=(9, 3)).tolist())))]  # type: ignore[arg-type]
    for k in range(6):
        a, b = shapes[k % 3], shapes[(k + 1) % 3]
        X_WA, X_WB = pose(chance), at(3.0) @ pose(chance)
        p, q = corners(a, X_WA), corners(b, X_WB)
        found = between(a, X_WA, b, X_WB)
        assert found.distance == pytest.approx(programmed(p, q), abs=1e-6)


def programmed(p: Array, q: Array) -> float:
    """Return the distance of the hulls of two sets of points, by sequential least squares."""
    both, size = np.concatenate([p, -q]), len(p) + len(q)
    sums = np.zeros((2, size))
    sums[0, : len(p)] = sums[1, len(p) :] = 1.0

    def square(w: Array) -> float:
        return float((w @ both) @ (w @ both))

    def slope(w: Array) -> Array:
        return 2.0 * both @ (w @ both)

    def missing(w: Array) -> Array:
        return sums @ w - 1.0

    minimize: Any = optimize.minimize  # pyright: ignore[reportAttributeAccessIssue, reportUnknownMemberType, reportUnknownVariableType]
    solved: Any = minimize(  # pyright: ignore[reportUnknownVariableType]
        square,
        sums[0] / len(p) + sums[1] / len(q),
        jac=slope,
        bounds=[(0.0, 1.0)] * size,
        constraints={"type": "eq", "fun": missing, "jac": lambda w: sums + 0.0 * w},  # pyright: ignore[reportUnknownLambdaType]
        method="SLSQP",
        options={"ftol": 1e-16, "maxiter": 500},
    )
    return math.sqrt(solved.fun)  # pyright: ignore[reportUnknownMemberType, reportUnknownArgumentType]


def test_two_flat_shapes_in_one_plane_touch() -> None:
    flat = Hull(((0.0, 0.0, 0.0), (0.1, 0.0, 0.0), (0.0, 0.1, 0.0)))
    found = between(flat, IDENTITY, flat, at(0.01, 0.01))
    assert found.lower <= 0.0 <= found.upper
    assert found.upper < ERROR
    apart = between(flat, IDENTITY, flat, at(0.2))
    assert apart.distance == pytest.approx(0.1, abs=ERROR)


def test_one_can_in_another_is_bounded_on_both_sides() -> None:
    # every way out across is the deepest; a polytope of few corners says so only roughly
    found = between(CAN, IDENTITY, CAN, IDENTITY)
    assert found.lower <= -0.06 + 1e-12
    assert found.upper >= -0.06
    assert found.error < 2e-4


def test_any_start_leads_to_the_same_answer() -> None:
    chance = np.random.default_rng(5)
    for _ in range(40):
        a, b, X_WA, X_WB = shape(chance), shape(chance), pose(chance), pose(chance)
        usual = between(a, X_WA, b, X_WB)
        for x, y, z in [*chance.normal(size=(3, 3)).tolist(), (0.0,) * 3, (math.nan,) * 3]:
            found = between(a, X_WA, b, X_WB, start=(x, y, z))
            assert found.distance == pytest.approx(usual.distance, abs=ERROR)


def test_pieces_are_placed_with_their_bodies() -> None:
    first, second = Piece(CUBE, at(0.1)), Piece(CAN, at(0.0, 0.0, 0.2))
    found = nearest(first, at(1.0), second, Pose(IDENTITY_ROTATION, (1.5, 0.0, -0.2)))
    assert found.distance == pytest.approx(0.27, abs=ERROR)
    assert found.first[0] == pytest.approx(1.2, abs=ERROR)
    assert found.normal == pytest.approx((1.0, 0.0, 0.0), abs=1e-6)


def test_it_needs_no_numpy() -> None:
    asks = (
        "import sys, vrts.geometry.proving.scalar\nassert not {'numpy', 'coal'} & set(sys.modules)"
    )
    subprocess.run([sys.executable, "-c", asks], check=True)
