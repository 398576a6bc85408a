"""Points of certificates in fewer bytes: still in their solids, and as near as they have to be."""

import numpy as np
import pytest

from vrts.check.proof.meeting_points import Met
from vrts.check.proof.plainer import plainer
from vrts.geometry.shapes import Box, Cylinder, Hull, Shape

BOX = Box((0.02, 0.03, 0.04))
CAN = Cylinder(0.03, 0.05)
HULL = Hull(((0.0, 0.0, 0.0), (0.1, 0.0, 0.0), (0.0, 0.1, 0.0), (0.0, 0.0, 0.1)))


def met(apart: float) -> Met:
    """A pair whose points are means of corners that lie in all three shapes."""
    corners = np.array([HULL.points, HULL.points]) * np.array([0.2, 1.0])[:, None, None]
    weights = np.array([0.137, 0.411, 0.2, 0.252])
    return Met(np.array(apart), np.array([0.0, 0.0, 1.0]), np.array(apart), corners, weights)


def shift(before: Met, after: Met) -> float:
    """How far both points moved, together [m]."""
    spots = [np.einsum("k,ski->si", one.weights, one.corners) for one in (before, after)]
    return float(np.linalg.norm(spots[1] - spots[0], axis=1).sum())


@pytest.mark.parametrize("first", [BOX, CAN])
def test_points_stay_where_they_are_to_be(first: Shape) -> None:
    for most_m in (0.0011, 0.002, 0.006, 0.05):
        before = met(0.001)
        after = plainer(before, (first, HULL), most_m)
        assert shift(before, after) < most_m - 0.001
        assert (np.abs(after.corners[0]) <= np.abs(before.corners[0]).max(axis=0)).all()
        assert (after.corners[1] == before.corners[1]).all()
        assert after.weights.sum() == pytest.approx(1.0, abs=1e-12)
        assert after.weights.min() >= 0


def test_a_wide_bound_gives_plain_numbers() -> None:
    after = plainer(met(0.001), (BOX, HULL), 0.05)
    assert all(float(x).is_integer() for x in (after.corners[0] * 2**7).flat)
    assert all(float(x).is_integer() for x in after.weights * 2**4)


def test_without_room_everything_stays() -> None:
    before = met(0.001)
    assert plainer(before, (BOX, HULL), 0.001) is before
