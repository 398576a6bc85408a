"""Somebody else's library looks at every contact and at the smallest clearance."""

from typing import NamedTuple

import numpy as np
import pytest

from tests.near_misses import near_miss
from vrts.check.collision.collision import check_collisions
from vrts.check.collision.pairs.arm_state import Prober
from vrts.check.collision.pairs.pairs import plan
from vrts.check.collision.second_opinion import Witness, disagreements
from vrts.check.curves.timeline_arrays import curves
from vrts.geometry.proposing.by_coal import ByCoal
from vrts.geometry.proposing.nobody import Nobody
from vrts.geometry.proposing.proposer import Proposals, Questions
from vrts.geometry.proving.prover import Prover
from vrts.marking.proposer.by_fcl import ByFcl


class Off(NamedTuple):
    """Measures so much too far."""

    too_far: float  # [m]
    name: str = "wrong"

    def propose(self, asked: Questions) -> Proposals:
        found = ByCoal().propose(asked)
        return found._replace(second=found.second + self.too_far * found.normal)


@pytest.mark.thorough
def test_the_two_engines_agree_about_what_is_reported() -> None:
    with ByFcl() as by:
        for seed in range(12):
            case = near_miss(seed)
            assert check_collisions(case.scene, case.record, second=by).disagreements == ()


def asked(near: float) -> tuple[Prober, list[Witness]]:
    """Return a prober and the pair that is apart by nearly so much, or overlaps so deeply."""
    case = near_miss(1)
    motion = curves(case.record.timeline.segments)
    todo = plan(case.scene, case.record, motion)
    ours = Prober(case.scene.robot.arm, motion, todo.solids, Prover(todo.solids, ByCoal()))
    first, second = todo.pairs.first, todo.pairs.second
    apart = ours.distances(first, second, np.full(len(first), 0.3))
    row = int(np.argmin(np.abs(apart - near)))
    return ours, [Witness(int(first[row]), int(second[row]), 0.3)]


@pytest.mark.parametrize(("too_far", "contradicts"), [(-1e-4, True), (-1e-6, False), (0.04, False)])
def test_who_measures_nearer_is_quoted_and_who_measures_farther_is_not(
    too_far: float, contradicts: bool
) -> None:
    ours, witness = asked(0.1)
    found = disagreements(ours, Off(too_far), witness)
    assert len(found) == contradicts
    for words in found:
        assert " mm proven" in words
        assert "wrong" in words


def test_who_sees_a_gap_where_there_is_an_overlap_is_quoted() -> None:
    ours, (witness,) = asked(0.1)
    one = [Witness(witness.first, witness.first, witness.time_s)]  # a solid and itself
    assert disagreements(ours, Off(0.0), one) == ()
    (words,) = disagreements(ours, Off(1.0), one)
    assert "wrong" in words


def test_who_does_not_answer_contradicts_nothing() -> None:
    ours, witness = asked(0.1)
    assert disagreements(ours, Nobody(), witness) == ()
