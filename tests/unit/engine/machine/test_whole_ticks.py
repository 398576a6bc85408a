"""Times that programs ask for, in whole ticks of the controller."""

import pytest

from tests.support_engine import runs
from tests.support_programs import switched


@pytest.mark.parametrize("seconds", [0.28, 0.56, 0.98, 1.4])
def test_times_that_are_whole_ticks_are_not_rounded_up(seconds: float) -> None:
    """Although single precision may make them a little longer."""
    hand = runs(f"PARAMETER HAND.TIME = {seconds}\nOPENI\nSIGNAL 1")
    assert switched(hand)[1] == pytest.approx(seconds, abs=1e-6)
    delay = runs(f"DELAY {seconds}\nBREAK\nSIGNAL 1")
    assert switched(delay)[1] == pytest.approx(seconds, abs=1e-6)
