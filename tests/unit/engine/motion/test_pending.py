"""A motion that waits its turn is on the timeline already; what is past stays as it was."""

import pytest

from tests.support_engine import TICK, reacted, runs
from tests.support_programs import ended
from vrts.base.pose import distance
from vrts.scene.model import Scenario

SUB = '.PROGRAM sub\nTYPE "reacted"\n.END\n'


@pytest.mark.parametrize("speed", [100.0, 37.0, 30.0])
@pytest.mark.parametrize("ticks", range(-1, 4))
def test_a_reaction_does_not_change_the_past(speed: float, ticks: int) -> None:
    """Wherever it comes beside the beginning of a rounded corner."""
    text = "REACT 1003, sub\nMOVE a\nMOVE b\nMOVE c"
    plain = runs(text, SUB, Scenario(monitor_speed=speed))
    at = (plain.motions[1].start_s // TICK + ticks) * TICK
    run = runs(text, SUB, Scenario(monitor_speed=speed, inputs=((at, 1003, True),)))
    assert len(reacted(run)) == 1
    for k in range(100):
        t = at * k / 100
        assert run.at(t).configuration == pytest.approx(plain.at(t).configuration, abs=1e-12)
    assert ended(run) == pytest.approx(ended(plain))


def test_a_motion_that_was_cut_names_the_pose_at_which_it_stopped() -> None:
    run = runs("MOVE a\nBREAK\nMOVES b\nTIMER 1 = 0\nWAIT TIMER(1) > 0.3\nBRAKE")
    line = run.motions[1]
    assert line.cut
    place = run.at(run.horizon_s).X_WT.translation
    assert distance(line.X_WT.translation, place) == pytest.approx(0.0, abs=1e-9)
