"""What is between the pads, beside a foreign linear program over the planes of foreign hulls.

Hulls by chance lie across edges and corners of the pads: where sides are steep, what sticks out of
the pads must not count.
"""

from itertools import permutations
from typing import Any, NamedTuple, cast

import numpy as np
import numpy.typing as npt
import pytest
from scipy.optimize import linprog
from scipy.spatial import ConvexHull

from vrts.base.pose import IDENTITY, Pose, Vector
from vrts.engine.hand.grip import between
from vrts.geometry.shapes import Box, Hull, Piece
from vrts.robots.arms.gripper import TWO_FINGERS

Array = npt.NDArray[np.float64]

HALF = np.array([TWO_FINGERS.pad_width, TWO_FINGERS.opening_max, TWO_FINGERS.pad_length]) / 2.0
ACCURACY = 2e-6  # [m], that the manual tells


class _Drawn(NamedTuple):
    piece: Piece
    X_PO: Pose
    planes: Array  # of scipy: normal and offset, in P


def _drawn(chance: np.random.Generator) -> _Drawn:
    points = chance.uniform(-1.0, 1.0, (chance.integers(4, 14), 3)) * chance.uniform(0.01, 0.03, 3)
    rotation, _ = np.linalg.qr(chance.normal(size=(3, 3)))
    rotation[:, 0] *= np.linalg.det(rotation)
    shift = chance.uniform(-0.02, 0.02, 3)
    planes: Array = ConvexHull(points @ rotation.T + shift).equations
    nine, (x, y, z) = rotation.ravel().tolist(), shift.tolist()
    corners = tuple((a, b, c) for a, b, c in points.tolist())
    return _Drawn(Piece(Hull(corners), IDENTITY), Pose(tuple(nine), (x, y, z)), planes)


def _ends(planes: Array, axis: int) -> tuple[float, float] | None:
    """Return how far what lies between the pads goes, by linear programs; None: nothing does."""
    sides = [(-HALF[0], HALF[0]), (None, None), (-HALF[2], HALF[2])]
    foreign = cast("Any", linprog)
    found: list[float] = []
    for sign in (1.0, -1.0):
        cost = np.zeros(3)
        cost[axis] = sign
        said = foreign(cost, planes[:, :3], -planes[:, 3], bounds=sides, method="highs")
        if said.status != 0:
            return None
        found.append(float(said.fun) * sign)
    return found[0], found[1]


@pytest.mark.parametrize("seed", range(6))
def test_width_middle_and_hold_are_those_of_a_linear_program(seed: int) -> None:
    chance = np.random.default_rng(seed)
    for _ in range(15):
        piece, X_PO, planes = _drawn(chance)
        found = between(TWO_FINGERS, (piece,), X_PO)
        across = _ends(planes, 1)
        if across is None or across[0] > HALF[1] or across[1] < -HALF[1]:
            assert found is None
            continue
        assert found is not None
        assert found.across == pytest.approx(across, abs=ACCURACY)
        assert found.centred == (across[0] < 0.0 < across[1])
        lengths = [b - a for a, b in (_ends(planes, 0) or (0, 0), _ends(planes, 2) or (0, 0))]
        assert found.overlap == pytest.approx(min(lengths), abs=3.0 * ACCURACY)


def _bar(x: float, half: float) -> Piece:
    return Piece(Box((half, 0.01, 0.02)), Pose(IDENTITY.rotation, (x, 0.0, 0.0)))


def test_where_a_mesh_is_cut_into_pieces_does_not_decide_whether_it_is_held() -> None:
    pads: Vector = TWO_FINGERS.X_FP.translation
    assert pads[2] > 0.0
    edge = TWO_FINGERS.pad_width / 2.0 - 0.008  # 8 mm of it are between the pads
    whole = between(TWO_FINGERS, (_bar(edge + 0.01, 0.01),), IDENTITY)
    cut = between(TWO_FINGERS, (_bar(edge + 0.002, 0.002), _bar(edge + 0.012, 0.008)), IDENTITY)
    assert whole is not None
    assert cut is not None
    assert whole.overlap == pytest.approx(0.008)
    assert cut.overlap == pytest.approx(whole.overlap)
    assert cut.overlap >= TWO_FINGERS.overlap_min


def test_two_walls_that_do_not_touch_are_not_one() -> None:
    apart = between(TWO_FINGERS, (_bar(-0.006, 0.001), _bar(0.006, 0.001)), IDENTITY)
    assert apart is not None
    assert apart.overlap == pytest.approx(0.002)


def test_the_order_of_pieces_does_not_matter() -> None:
    corner = _wall(0.0, -0.0055, 0.006, 0.0005), _wall(-0.0055, 0.0, 0.0005, 0.006)
    pieces = (*corner, _wall(0.005, 0.005, 0.003, 0.003))  # beside both, in the box round them
    found = [between(TWO_FINGERS, order, IDENTITY) for order in permutations(pieces)]
    assert [one and one.overlap for one in found] == [pytest.approx(0.012)] * 6


def _wall(x: float, z: float, half_width: float, half_length: float) -> Piece:
    box = Box((half_width, 0.01, half_length))
    return Piece(box, Pose(IDENTITY.rotation, (x, 0.0, z)))
