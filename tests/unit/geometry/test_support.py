"""Reach and extent agree with the corners of the drawn shape and with closed forms."""

import math

import numpy as np
import pytest

from vrts.base.pose import IDENTITY, Pose, Vector, dot, rotation_about, translation
from vrts.geometry.mesh import tessellate
from vrts.geometry.shapes import Box, Cylinder, Hull, Piece
from vrts.geometry.support import (
    Interval,
    bounds,
    extent,
    extent_of,
    reach,
    span,
    support,
)

AXIS: Vector = (1 / math.sqrt(3), 1 / math.sqrt(3), 1 / math.sqrt(3))
X_WO = Pose(rotation_about(AXIS, 0.7), (0.3, -0.2, 0.5))
X_OP = Pose(rotation_about((0.0, 0.0, 1.0), 0.3), (0.05, 0.0, -0.1))
PIECES = [
    Piece(Box((0.1, 0.2, 0.3)), X_OP),
    Piece(Hull(((0, 0, 0), (0.3, 0, 0), (0, 0.2, 0), (0, 0, 0.1))), X_OP),
    Piece(Cylinder(0.1, 0.4), X_OP),
]
DIRECTIONS: list[Vector] = [(1.0, 0.0, 0.0), (0.0, 0.6, -0.8), AXIS]


@pytest.mark.parametrize("direction", DIRECTIONS)
@pytest.mark.parametrize("piece", PIECES)
def test_extent_is_that_of_the_corners(piece: Piece, direction: Vector) -> None:
    mesh = tessellate(piece, 2000)
    rotation = np.array(X_WO.rotation).reshape(3, 3)
    heights = (mesh.vertices @ rotation.T + np.array(X_WO.translation)) @ np.array(direction)
    lower, upper = extent(piece, X_WO, direction)
    assert lower == pytest.approx(heights.min(), abs=2e-7)
    assert upper == pytest.approx(heights.max(), abs=2e-7)
    assert dot(support(piece, X_WO, direction), direction) == pytest.approx(upper, abs=1e-12)


def test_reach_of_a_cylinder_tilted_by_30_degrees() -> None:
    tilted = (math.sin(math.pi / 6), 0.0, math.cos(math.pi / 6))
    assert reach(Cylinder(0.03, 0.1), tilted) == pytest.approx(0.03 * 0.5 + 0.1 * math.sqrt(0.75))


def test_support_of_a_cylinder_along_its_axis_is_on_the_axis() -> None:
    can = Piece(Cylinder(0.03, 0.0575), IDENTITY)
    assert support(can, translation(0, 0, 1), (0.0, 0.0, -1.0)) == (0.0, 0.0, 1 - 0.0575)


def test_bounds_hold_every_piece() -> None:
    box = bounds(PIECES, X_WO)
    for axis in range(3):
        direction = (float(axis == 0), float(axis == 1), float(axis == 2))
        whole = extent_of(PIECES, X_WO, direction)
        assert box.lower[axis] == pytest.approx(whole.lower, abs=1e-12)
        assert box.upper[axis] == pytest.approx(whole.upper, abs=1e-12)


def test_no_pieces_have_no_bounds() -> None:
    with pytest.raises(ValueError, match="no pieces"):
        bounds((), IDENTITY)


def test_overlap_of_intervals_is_negative_for_a_gap() -> None:
    assert Interval(0.0, 2.0).overlap(Interval(1.0, 5.0)) == 1.0
    assert Interval(0.0, 1.0).overlap(Interval(3.0, 4.0)) == -2.0


@pytest.mark.parametrize("direction", DIRECTIONS)
@pytest.mark.parametrize("piece", PIECES)
def test_a_span_reaches_forward_and_backward(piece: Piece, direction: Vector) -> None:
    x, y, z = direction
    lower, upper = span(piece.shape, direction)
    assert (lower, upper) == (-reach(piece.shape, (-x, -y, -z)), reach(piece.shape, direction))
