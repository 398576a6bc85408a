"""The hardest of many random motions past thin things, and the sampler they are judged by."""

import numpy as np
import pytest

from tests.near_misses import NearMiss, near_miss, sampled, sampled_plainly
from tests.proposers import PROPOSERS
from tests.soundness import PAST, case
from vrts.check.collision.collision import check_collisions


@pytest.mark.parametrize("by", PROPOSERS)
@pytest.mark.parametrize("seed", [190, 422])
def test_a_post_touched_for_a_fraction_of_a_millisecond(seed: int, by: str) -> None:
    motion = case(seed)
    times = sampled(motion)
    assert 0 < len(times) < 10
    at = np.rint(times / 1e-4).astype(np.int64)
    assert not (at % 10 == 0).any()  # looking every millisecond misses it
    assert_found(motion, times, by)


@pytest.mark.parametrize("seed", [430, 946, 2306, 3886, 5738, 6970, 7574, 9356])
def test_a_post_touched_for_a_millisecond(seed: int) -> None:
    motion = near_miss(seed, past=PAST)
    times = sampled(motion)
    assert 10 <= len(times) < 15
    assert_found(motion, times, "coal")


def assert_found(motion: NearMiss, times: np.ndarray, by: str) -> None:
    """Assert that the check brackets the contact."""
    proposer = PROPOSERS[by]()
    report = check_collisions(motion.scene, motion.record, clearance=False, proposer=proposer)
    events = report.contacts
    around = [e for e in events if e.start_s < times[0] + 1.5e-4 and times[-1] - 1.5e-4 < e.end_s]
    assert [event.second for event in around] == [motion.kind]


@pytest.mark.parametrize(
    ("seed", "high", "past"),
    [(430, False, PAST), (7, True, (-2e-3, 3e-3)), (3, False, (-2e-3, 3e-3))],
)
def test_the_quick_sampler_finds_what_the_plain_one_finds(
    seed: int, high: bool, past: tuple[float, float]
) -> None:
    motion = near_miss(seed, high=high, past=past)
    assert np.array_equal(sampled(motion, 5e-4), sampled_plainly(motion, 5e-4))
    if seed == 430:
        assert np.array_equal(sampled(motion), sampled_plainly(motion))
