"""Exact distances in closed form, and objects that outlive the caches that made them."""

import gc
import math

import numpy as np
import pytest

from vrts.base.pose import IDENTITY, Pose, translation
from vrts.geometry.coal_engine import ERROR, Pair, distance, nearest, pair, placed, solid, transform
from vrts.geometry.shapes import Box, Cylinder, Hull, Piece

BOX = Box((0.1, 0.1, 0.1))


@pytest.mark.parametrize("gap", [0.5, 1e-3, 0.0, -1e-3, -0.05])
def test_gap_and_depth_of_two_boxes(gap: float) -> None:
    found = nearest(
        Piece(BOX, IDENTITY), IDENTITY, Piece(BOX, translation(0.2 + gap, 0, 0)), IDENTITY
    )
    assert found.distance == pytest.approx(gap, abs=ERROR)
    if gap > 0.0:
        assert found.normal == pytest.approx((1.0, 0.0, 0.0), abs=1e-6)
        assert found.first[0] == pytest.approx(0.1, abs=1e-6)
        assert found.second[0] == pytest.approx(0.1 + gap, abs=1e-6)


def test_poses_of_pieces_are_composed() -> None:
    can = Piece(Cylinder(0.03, 0.05), translation(0.0, 0.0, 0.05))
    assert distance(can, translation(0, 0, 1.0), Piece(BOX, IDENTITY), IDENTITY) == pytest.approx(
        0.9, abs=ERROR
    )


@pytest.mark.parametrize("off", [1e-309, 1e-23, 1e-18])
def test_edges_that_touch_and_are_parallel_but_for_rounding_only_touch(off: float) -> None:
    low = ((0.0, 0.0, 0.0), (0.25, 0.0, 0.0), (0.0, 0.25, 0.0), (0.0, 0.0, 0.25))
    corner = Piece(Hull((*low, (0.25, 0.25, 0.25))), IDENTITY)
    for angle in np.linspace(1.9, 2.9, 30).tolist():
        c, s = math.cos(angle), math.sin(angle)
        X_WB = Pose((1.0, off, off, off, c, -s, -off, s, c), (0.0, 0.0, 0.0))
        found = nearest(corner, IDENTITY, corner, X_WB)
        assert found.distance == pytest.approx(0.0, abs=ERROR)
        assert math.hypot(*found.normal) == pytest.approx(1.0, abs=1e-6)
        both = Pair(corner.shape, corner.shape)
        apart = both.distance(placed(IDENTITY), placed(X_WB))
        assert (apart, tuple(both.normal)) == (found.distance, found.normal)


def test_a_pair_outlives_the_cache_of_its_solids() -> None:
    hull = Hull(((0.0, 0.0, 0.0), (0.1, 0.0, 0.0), (0.0, 0.1, 0.0), (0.0, 0.0, 0.1)))
    kept = Pair(hull, BOX)
    solid.cache_clear()
    gc.collect()
    filler = [np.zeros(200) for _ in range(2000)]
    there = transform(np.eye(3), np.array([-0.3, 0.0, 0.0]))
    assert len(filler) == 2000
    assert kept.distance(placed(IDENTITY), there) == pytest.approx(0.2, abs=ERROR)


def test_equal_shapes_share_a_pair() -> None:
    assert pair(BOX, Box((0.1, 0.1, 0.1))) is pair(BOX, BOX)
