"""Bounds of many pairs at once say what the shapes say one by one, whatever is proposed."""

import numpy as np
import pytest

from tests.proposers import PROPOSERS
from tests.unit.geometry.proving.shapes_placed import pose, shape
from vrts.base.pose import IDENTITY, Pose
from vrts.geometry.proving.placed import placed as support_of
from vrts.geometry.proving.prover import EXACT, Prover
from vrts.geometry.proving.rows import Placed, depths, gaps, pulled_in, units, uppers
from vrts.geometry.proving.scalar import between
from vrts.geometry.shapes import Hull, Shape
from vrts.geometry.solids import Solid, Solids, solids
from vrts.geometry.support import reach

COUNT = 60


def cases(seed: int) -> tuple[Solids, Placed, Placed, list[tuple[Shape, Pose, Shape, Pose]]]:
    """Return pairs of shapes as rows, and one by one."""
    chance = np.random.default_rng(seed)
    rows = [(shape(chance), pose(chance), shape(chance), pose(chance)) for _ in range(COUNT)]
    shapes = [own for a, _, b, _ in rows for own in (a, b)]
    table = solids([Solid(own, 0, IDENTITY, "") for own in shapes])

    def side(number: int, poses: list[Pose]) -> Placed:
        return Placed(
            np.arange(number, 2 * COUNT, 2),
            np.array([X.rotation for X in poses]).reshape(-1, 3, 3),
            np.array([X.translation for X in poses]),
        )

    first, second = [X_WA for _, X_WA, _, _ in rows], [X_WB for _, _, _, X_WB in rows]
    return table, side(0, first), side(1, second), rows


def test_gaps_are_those_of_support_functions() -> None:
    table, a, b, rows = cases(1)
    normal = units(np.random.default_rng(2).normal(size=(COUNT, 3)))
    found = gaps(table, a, b, normal)
    for k, (one, X_WA, other, X_WB) in enumerate(rows):
        n = normal[k].tolist()
        x = np.array(support_of(one, X_WA)(*n))
        y = np.array(support_of(other, X_WB)(*[-part for part in n]))
        assert found[k] == pytest.approx(float(normal[k] @ (y - x)), abs=1e-12)
    assert (gaps(table, a, b, 1.001 * normal) == -np.inf).all()
    assert (gaps(table, a, b, np.full((COUNT, 3), np.nan)) == -np.inf).all()
    assert np.isnan(units(np.zeros((1, 3)))).all()


def test_points_are_pulled_inside_and_their_depth_is_that_of_a_ball() -> None:
    table, a, b, rows = cases(3)
    points = a.origin + np.random.default_rng(4).normal(size=(COUNT, 3)) * 0.1
    found, deep = pulled_in(table, a, points), depths(table, a, points)
    ways = units(np.random.default_rng(5).normal(size=(400, 3)))
    for k, (one, X_WA, _, _) in enumerate(rows):
        if isinstance(one, Hull):
            assert np.isnan(found[k]).all()
            assert deep[k] == -np.inf
            continue
        local = ways @ np.array(X_WA.rotation).reshape(3, 3)
        room = np.array([reach(one, tuple(way)) for way in local.tolist()])
        assert (room - (found[k] - a.origin[k]) @ ways.T >= -1e-12).all()
        if deep[k] >= 0.0:
            assert np.allclose(found[k], points[k])
            assert (room - (points[k] - a.origin[k]) @ ways.T >= deep[k] - 1e-12).all()
    assert (deep >= 0.0).sum() > 5
    # nowhere is an upper bound below a lower one
    far = uppers(table, a, b, points, b.origin)
    assert (gaps(table, a, b, ways[:COUNT]) <= far + 1e-12).all()


@pytest.mark.parametrize("by", PROPOSERS)
def test_distances_are_the_same_whoever_proposes(by: str) -> None:
    table, a, b, rows = cases(6)
    prover = Prover(table, PROPOSERS[by]())
    bounds = prover.exact(a, b)
    told = prover.told(a, b)
    for k, (one, X_WA, other, X_WB) in enumerate(rows):
        known = between(one, X_WA, other, X_WB)
        assert bounds.lower[k] - 1e-9 <= known.distance <= bounds.upper[k] + 1e-9
        assert bounds.upper[k] - bounds.lower[k] <= EXACT
        assert told.distance[k] == pytest.approx(known.distance, abs=2e-9)
    assert np.allclose(bounds.lower, gaps(table, a, b, bounds.normal), atol=1e-9)


def test_what_is_told_is_the_same_bits_whoever_proposes() -> None:
    table, a, b, _ = cases(7)
    answers = [Prover(table, make()).told(a, b) for make in PROPOSERS.values()]
    for other in answers[1:]:
        for one, column in zip(answers[0], other, strict=True):
            assert np.array_equal(one, column)


def test_a_bound_that_is_enough_is_enough() -> None:
    table, a, b, _ = cases(8)
    prover = Prover(table, PROPOSERS["own"]())
    exact = prover.exact(a, b)
    some = np.flatnonzero(exact.lower > 0.05)
    enough = prover.searched_for(
        a.at(some), b.at(some), np.full((len(some), 3), np.nan), apart=np.full(len(some), 0.01)
    )
    assert (enough.lower >= 0.01).all()
    assert (enough.lower <= exact.upper[some] + 1e-9).all()
    deep = np.flatnonzero(exact.upper < -0.02)
    assert len(deep) > 5
    shown = prover.searched_for(
        a.at(deep), b.at(deep), np.full((len(deep), 3), np.nan), deep=np.full(len(deep), -0.01)
    )
    assert (shown.upper <= -0.01).all()
    assert (shown.upper >= exact.lower[deep] - 1e-9).all()
