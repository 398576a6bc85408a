"""The trajectory of a run, of one without any time too: everybody may ask it as any other."""

import numpy as np
import pytest

from tests.support_programs import compiled
from vrts.check.collision.of_run import motion_of
from vrts.dispatch.posts.same_motion import difference
from vrts.engine.batch import batch_of
from vrts.engine.controller import execute
from vrts.engine.run import Run
from vrts.scene.default import robot_alone
from vrts.validate.sampling import sampled

TIMES = np.array([-1.0, 0.0, 0.5])


@pytest.fixture
def at_once() -> Run:
    """A program that ends in the tick in which it begins."""
    run = execute(compiled(".PROGRAM main()\nn = 1\n.END\n"), robot_alone())
    assert run.horizon_s == 0.0
    return run


def test_a_run_without_any_time_stands_still_at_every_time(at_once: Run) -> None:
    state = at_once.at(0.0)
    there = np.array([(*state.configuration, state.hand_opening)] * len(TIMES))
    assert at_once.timeline.segments == ()
    (start,) = at_once.timeline.segments_or_start
    assert (start.start_s, start.end_s, start.motion) == (0.0, 0.0, None)
    for motion in (batch_of(at_once.timeline), motion_of(at_once)):
        assert np.array_equal(motion.values(TIMES), there)
    assert not batch_of(at_once.timeline).rates(TIMES).any()
    assert not motion_of(at_once).velocities(TIMES).any()


def test_runs_without_any_time_are_compared_and_sampled_like_others(at_once: Run) -> None:
    assert difference(at_once, at_once).is_none
    samples = sampled(at_once, TIMES)
    assert not samples.rates.any()
    assert not samples.velocities.any()


def test_the_arrays_of_a_timeline_are_made_once(at_once: Run) -> None:
    assert batch_of(at_once.timeline) is batch_of(at_once.timeline)
