"""A cylinder round the axis of its joint is hung on the frame before it, where it does not turn."""

import numpy as np
import pytest

from vrts.check.collision.pairs.cast import HAND, Cast, robot_solids
from vrts.geometry.shapes import Cylinder
from vrts.geometry.solids import Solid
from vrts.robots.catalog import robot
from vrts.robots.kinematics.batch import link_frames


@pytest.mark.parametrize("name", ["puma560", "puma761"])
def test_discs_are_where_they_were(name: str) -> None:
    machine = robot(name)
    cast = Cast(0.0, 1.0, machine.arm.X_LF)
    named = robot_solids(cast, machine)
    plain = [
        Solid(piece.shape, link.joint, piece.X_OP, link.name)
        for link in machine.arm.links
        for piece in link.pieces
    ]
    moved = 0
    q = np.random.default_rng(9).uniform(-2.0, 2.0, (20, 6))
    rotations, origins = link_frames(machine.arm, q)

    def placed(solid: Solid) -> tuple[np.ndarray, np.ndarray]:  # type: ignore[type-arg]
        R = np.array(solid.X_LP.rotation).reshape(3, 3)
        turned = rotations[solid.frame]
        middle = turned @ np.array(solid.X_LP.translation) + origins[solid.frame]
        return middle, (turned @ R)[:, :, 2]

    numbers = [number for _, _, members in named.links for number in members]
    for before, number in zip(plain, numbers, strict=True):
        now = cast.members[number]
        assert (now.shape, now.part) == (before.shape, before.part)
        for one, other in zip(placed(now), placed(before), strict=True):
            assert np.allclose(one, other, atol=1e-12)
        if now.frame != before.frame:
            assert isinstance(now.shape, Cylinder)
            assert now.frame == before.frame - 1 >= 1
            moved += 1
    assert moved > 0
    assert all(cast.members[k].frame == HAND for finger in named.fingers for k in finger)
