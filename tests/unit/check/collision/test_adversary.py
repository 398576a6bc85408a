"""Cases at and beside the thresholds, honest and lying proposers, and an independent judge."""

from typing import Any

import numpy as np
import pytest

from tests.adversary.__main__ import looked_at
from tests.adversary.cases import case
from tests.adversary.gaps import Posed, distance, sharpened, surely
from tests.adversary.judge import faults, judge_of
from tests.adversary.kinematics import frames
from tests.adversary.liars import HONEST, LYING
from tests.laws import first
from vrts.base.pose import IDENTITY
from vrts.check.collision import collision
from vrts.check.collision.collision import check_collisions
from vrts.check.collision.pairs.findings import Findings
from vrts.check.collision.search.search import search
from vrts.geometry.proving.scalar import between
from vrts.geometry.shapes import Box, Cylinder, Hull
from vrts.robots.catalog import robot
from vrts.robots.kinematics.batch import link_frames

HULL = Hull(((0.0, 0.0, 0.0), (0.1, 0.0, 0.0), (0.0, 0.1, 0.0), (0.0, 0.0, 0.1)))
SHAPES = Box((0.05, 0.02, 0.07)), Cylinder(0.03, 0.05), Cylinder(0.001, 0.1), HULL
QUICK = 4
# pads too deep in the grip and after they came free; then, each for some seconds: before it;
# what is held on its support; a pad deeper than the rest of its finger, but less far beyond what
# it may
GRIPS = (10, 36, 1, 39, 23)


@pytest.mark.thorough
@pytest.mark.parametrize("seed", first(QUICK, range(1, 71)))
def test_nothing_is_missed_or_made_up_and_nobody_who_proposes_changes_it(seed: int) -> None:
    found = looked_at(seed, whole=False)
    assert found.faults == {}
    assert found.differ == found.moments == []


@pytest.mark.thorough
@pytest.mark.parametrize("seed", first(2, GRIPS))
def test_what_pads_and_supports_may_touch_and_when_is_judged_alike(seed: int) -> None:
    found = looked_at(seed, whole=False, pads=True)
    assert found.faults == {}
    assert found.differ == found.moments == []


@pytest.mark.parametrize(("seed", "who"), [(59, "backward"), (202, "coal"), (202, "own")])
def test_bad_directions_make_near_misses_no_longer(
    monkeypatch: pytest.MonkeyPatch, seed: int, who: str
) -> None:
    rows: list[int] = []

    def counted(*args: Any, **named: Any) -> Findings:
        found = search(*args, **named)
        rows.append(found.rows)
        return found

    monkeypatch.setattr(collision, "search", counted)
    it = case(seed)
    with (HONEST | LYING)[who](seed) as proposer:
        check_collisions(it.scene, it.record, proposer=proposer)
    (looked,) = rows  # otherwise 332,214 for coal, 7,971 for the liar
    assert looked < 1000


@pytest.mark.thorough
@pytest.mark.parametrize("seed", [10572, 10596, 20804, 21331])
def test_the_judge_is_not_stuck_where_thin_things_overlap(seed: int) -> None:
    # it took 0.42 mm for the depth of two cylinders that are 0.13 mm deep in each other
    it = case(seed)
    judge = judge_of(it)
    truth = {group: judge.nearest(group) for group in judge.groups}
    assert faults(judge, check_collisions(it.scene, it.record), truth) == []


def test_the_judge_knows_where_the_links_are() -> None:
    q = np.random.default_rng(0).uniform(-3.0, 3.0, (50, 6))
    ours = frames(q)
    rotations, origins = link_frames(robot("puma761").arm, q)
    assert np.abs(ours[:7, :, :3, :3] - rotations).max() < 1e-12
    assert np.abs(ours[:7, :, :3, 3] - origins).max() < 1e-12


def test_the_judge_and_the_prover_measure_alike() -> None:
    random = np.random.default_rng(1)
    for k in range(12):
        a, b = SHAPES[k % 4], SHAPES[(k + k // 4) % 4]
        origin = random.normal(size=3) * 0.08
        x, y, z = origin.tolist()
        ours = between(a, IDENTITY, b, IDENTITY._replace(translation=(x, y, z)))
        if ours.upper < -2e-3:
            continue
        still = np.eye(3)[None]
        pair = Posed(a, still, np.zeros((1, 3))), Posed(b, still, origin[None])
        value, way = distance(*pair)
        assert value[0] <= surely(*pair)[0][0] + 1e-6
        assert sharpened(*pair, 0, way[0]) == pytest.approx(ours.distance, abs=2e-8)
