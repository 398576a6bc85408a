"""Programs that take longer than they may, although they only wait."""

import pytest

from tests.support_engine import runs
from tests.support_programs import codes
from vrts.engine.memory.records import Ending
from vrts.scene.model import Limits, Scenario

SLOW = [
    "SPEED 0.01\nMOVE a\nBREAK",
    "DELAY 5000\nBREAK",
    "SPEED 0.01\nMOVE a\nMOVE b",
    "PARAMETER HAND.TIME = 5000\nOPENI",
    "MOVE a\nDELAY 5000\nMOVE b",
    "SPEED 0.01\nMOVE a",
    "DELAY 5000",
]


@pytest.mark.parametrize("body", SLOW)
def test_a_program_is_stopped_at_the_longest_time_it_may_take(body: str) -> None:
    run = runs(body, scenario=Scenario(limits=Limits(time_s=100.0)))
    assert codes(run) == ["V511"]
    assert run.ending is Ending.LIMIT
    assert run.ended_s == pytest.approx(100.0, abs=0.5)
