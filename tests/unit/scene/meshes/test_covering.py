"""The proof that pieces hold a mesh, and the bound of how far they stand out of it."""

import numpy as np
import pytest

from tests.parts import U_PIECES, block, u_mesh
from vrts.scene.meshes.covering import left_over, stands_out
from vrts.scene.meshes.deviation import deviation, united_volume
from vrts.scene.meshes.polytopes import Polytope, polytope
from vrts.scene.meshes.space import Space


def pieces(*blocks: tuple[float, float, float, float], more: float = 0.001) -> list[Polytope]:
    return [polytope(np.array(block(*each, more))) for each in blocks]


def test_the_blocks_of_a_u_hold_it() -> None:
    assert left_over(u_mesh(), pieces(*U_PIECES)) == ()


def test_what_no_piece_holds_is_found_though_it_has_no_corner_of_the_mesh() -> None:
    cut = ((0, 0, 50, 20), (50.5, 0, 120, 20), *U_PIECES[1:])  # half a millimetre across the U
    made = pieces(*cut)
    shreds = left_over(u_mesh(), made)
    assert shreds
    area = sum(
        np.linalg.norm(
            np.cross(s.corners[1:-1] - s.corners[0], s.corners[2:] - s.corners[0]).sum(0)
        )
        for s in shreds
    )
    assert area / 2 == pytest.approx(2 * 0.498 * (80 + 20), rel=0.01)  # four sides of the slit
    assert stands_out(shreds, made) >= 0.24


def test_a_piece_that_is_a_hair_too_small_is_not_believed() -> None:
    assert left_over(u_mesh(), pieces(*U_PIECES, more=-0.00001))
    assert left_over(u_mesh(), pieces((0, 0, 120, 60), more=-0.5))
    assert left_over(u_mesh(), pieces((0, 0, 120, 60))) == ()


def test_the_bound_is_never_below_the_truth_and_near_to_it() -> None:
    mesh = u_mesh()
    flush = deviation(mesh, pieces(*U_PIECES))
    assert flush.at_most < 0.6
    higher = deviation(
        mesh, pieces((0, 0, 120, 27), *U_PIECES[1:])
    )  # 7 mm above the floor of the U
    assert 7.0 <= higher.at_most <= 7.6
    assert 6.5 <= higher.found <= higher.at_most
    whole = deviation(mesh, pieces((0, 0, 120, 60)))  # nearest walls and floor are 40 mm away
    assert 40.0 <= whole.at_most <= 42.0


def test_distances_to_the_surface_have_a_sign() -> None:
    points = np.array([(60.0, 30.0, 40.0), (60.0, 10.0, 40.0), (-3.0, -4.0, 40.0), (10, 59, 79)])
    found, _ = Space(u_mesh()).distance(points)
    assert found == pytest.approx((10.0, -10.0, 5.0, -1.0))


def test_the_volume_of_a_union_counts_overlaps_once() -> None:
    assert united_volume(pieces(*U_PIECES)) == pytest.approx(320_000.0, rel=0.01)
    twice = pieces((0, 0, 120, 60), (0, 0, 120, 60))
    assert united_volume(twice) == pytest.approx(576_000.0, rel=0.01)
