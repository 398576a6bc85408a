"""The sampled clearance agrees with the certified one where it samples."""

import numpy as np
import pytest

from tests.places import ROOT
from vrts.check.collision.clearance_curve import FAR, clearance_curve
from vrts.check.collision.of_run import motion_of, plan_of
from vrts.check.collision.pairs.arm_state import Prober
from vrts.check.collision.pairs.grips import NEAR_MISS
from vrts.geometry.proposing.choose import here
from vrts.geometry.proving.prover import Prover
from vrts.pipeline.assess import assess
from vrts.pipeline.requesting import request_for

SOLUTION = ROOT / "examples" / "01-cans-on-bases" / "solution.v2"


def test_it_never_lies_below_the_certified_minimum_and_meets_it() -> None:
    found = assess(request_for(SOLUTION))
    assert found.run is not None
    assert found.scene is not None
    assert found.judgement is not None
    report = found.judgement.collisions
    assert report is not None
    assert report.clearance is not None
    smallest = report.clearance
    times = np.append(np.linspace(0.0, found.run.horizon_s, 80), smallest.time_s)
    curve = clearance_curve(found.scene, found.run, times)
    assert curve.min() >= smallest.distance_m - smallest.tolerance_m
    assert curve[-1] == pytest.approx(smallest.distance_m, abs=1e-6)
    assert curve.max() <= FAR


def test_no_pair_is_nearer_than_it_says() -> None:
    found = assess(request_for(SOLUTION))
    assert found.run is not None
    assert found.scene is not None
    times = np.linspace(0.0, found.run.horizon_s, 61)
    curve = clearance_curve(found.scene, found.run, times)
    todo = plan_of(found.scene, found.run, here(), NEAR_MISS, clearance=True)
    pairs = todo.pairs
    prober = Prober(
        found.scene.robot.arm, motion_of(found.run), todo.solids, Prover(todo.solids, here())
    )
    for now, said in zip(times[::6], curve[::6], strict=True):
        there = np.flatnonzero(pairs.counts & (pairs.start_s <= now) & (now <= pairs.end_s))
        each = prober.distances(pairs.first[there], pairs.second[there], np.full(len(there), now))
        assert said == pytest.approx(min(FAR, each.min()), abs=1e-9)
