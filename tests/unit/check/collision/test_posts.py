"""Near misses of many posts beside a way: each with its own smallest distance."""

import numpy as np
import pytest

from tests.proposers import PROPOSERS
from tests.unit.check.collision.posts import passing
from vrts.check.collision.collision import check_collisions


@pytest.mark.parametrize("by", ["coal", "own"])
def test_the_distance_of_every_near_miss_is_that_of_its_nearest_moment(by: str) -> None:
    run = passing(2.0, count=3)
    report = check_collisions(run.scene, run, proposer=PROPOSERS[by]())
    assert report.contacts == report.undetermined == ()
    assert report.clearance is not None
    # there and back past each post
    assert sorted(miss.second for miss in report.near_misses) == [
        f"post{k}" for k in range(3) for _ in range(2)
    ]
    for miss in report.near_misses:
        assert 2e-3 - 1e-5 <= miss.distance_m <= 2e-3 + 1.1e-4
        a, b = np.array(miss.witnesses)
        assert np.linalg.norm(a - b) == pytest.approx(miss.distance_m, abs=1e-9)
        assert miss.start_s < miss.nearest_s < miss.end_s
