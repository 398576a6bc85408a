"""A second engine looks at every contact and at the smallest clearance."""

import numpy as np
import pytest

from tests.near_misses import near_miss
from vrts.check.collision.collision import check_collisions
from vrts.check.collision.pairs.arm_state import Prober
from vrts.check.collision.pairs.pairs import plan
from vrts.check.collision.second_opinion import Witness, disagreements
from vrts.check.curves.timeline_arrays import curves
from vrts.geometry.narrow import engine
from vrts.geometry.nearest import Array, Transform


@pytest.mark.parametrize("seed", range(12))
def test_the_two_engines_agree_about_what_is_reported(seed: int) -> None:
    case = near_miss(seed)
    assert check_collisions(case.scene, case.record).disagreements == ()


def test_a_second_engine_that_measures_otherwise_is_quoted() -> None:
    case = near_miss(1)
    motion = curves(case.record.timeline.segments)
    todo = plan(case.scene, case.record, motion)
    fcl = engine("fcl")

    def shrunk(rotation: Array, origin: Array) -> Transform:
        return fcl.transform(rotation, 0.9 * origin)

    ours = Prober(case.scene.robot.arm, motion, todo.solids, engine("coal"))
    wrong = Prober(
        case.scene.robot.arm, motion, todo.solids, fcl._replace(name="wrong", transform=shrunk)
    )
    right = Prober(case.scene.robot.arm, motion, todo.solids, fcl)
    count = len(todo.pairs.first)
    times = np.full(count, 0.3)
    apart = ours.distances(todo.pairs.first, todo.pairs.second, times)
    row = int(np.argmax(np.where(apart < 0.3, apart, -1.0)))
    witness = [Witness(int(todo.pairs.first[row]), int(todo.pairs.second[row]), 0.3)]
    assert disagreements(ours, right, witness) == ()
    (found,) = disagreements(ours, wrong, witness)
    assert "coal measures" in found
    assert "wrong" in found
