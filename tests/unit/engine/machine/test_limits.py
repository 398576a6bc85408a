"""Limits of a run: what is stopped, when, and what is not."""

import pytest

from tests.support_engine import runs
from tests.support_programs import codes
from vrts.engine.memory.records import Ending
from vrts.scene.model import Limits, Scenario

COUNT = "n = 0\nDO\nn = n+1\nUNTIL n == {}"


@pytest.mark.parametrize("last", ["", "HALT", "STOP", "PAUSE", "x = 1/0"])
def test_a_program_that_is_over_in_the_same_tick_is_not_stopped(last: str) -> None:
    run = runs(f"a1 = 1\na2 = 2\na3 = 3\n{last}", scenario=Scenario(limits=Limits(statements=2)))
    assert run.ending is not Ending.LIMIT
    assert codes(run) == (["V251"] if "/" in last else [])


def test_a_program_is_stopped_in_the_tick_in_which_it_exceeds_its_statements() -> None:
    for most, ending in ((300, Ending.LIMIT), (100_000, Ending.COMPLETED)):
        run = runs(COUNT.format(2000), scenario=Scenario(limits=Limits(statements=most)))
        assert run.ending is ending
        assert run.statements <= most + 100


def test_the_process_program_counts_too() -> None:
    more = ".PROGRAM busy\nk = 0\nDO\nk = k+1\nUNTIL k < 0\n.END\n"
    run = runs("PCEXECUTE busy\nDELAY 20\nBREAK", more, Scenario(limits=Limits(statements=500)))
    assert codes(run) == ["V510"]


def test_time_counts_from_execute() -> None:
    run = runs(
        "DO\nDELAY 1\nBREAK\nUNTIL TIMER(0) > 60", scenario=Scenario(limits=Limits(time_s=10.0))
    )
    assert codes(run) == ["V511"]
    assert run.ended_s == pytest.approx(10.0, abs=0.2)
    assert not run.motions


def test_a_limit_slows_the_arm_down() -> None:
    run = runs(
        "MOVE #PPOINT(150,-90,90)\nn = 0\nDO\nn = n+1\nUNTIL n < 0",
        scenario=Scenario(limits=Limits(statements=3000)),
    )
    assert codes(run) == ["V510"]
    assert run.motions[0].cut
    assert run.at(run.horizon_s).velocity == (0.0,) * 6
