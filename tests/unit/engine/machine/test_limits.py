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


BUSY = ".PROGRAM busy\nk = 0\nDO\nk = k+1\nm = k\nUNTIL k < 0\n.END\n"


def test_of_two_programs_the_one_is_told_that_uses_the_statements_up() -> None:
    """And it is told once, at one of its own lines, although the other is ended for it."""
    body = "PCEXECUTE busy, -1\ni = 0\nDO\ni = i+1\nDELAY 1\nUNTIL i < 0"
    run = runs(body, BUSY, Scenario(limits=Limits(statements=20_000)))
    (found,) = run.findings
    assert run.ending is Ending.LIMIT
    assert found.headline == "`busy` is still running beside `main` after 20,000 steps"
    assert found.primary is not None
    assert found.primary.span.text in ("k = k+1", "m = k", "UNTIL k < 0", "DO")
    (note,) = found.notes
    assert note.startswith("it was here, after ")
    assert "of the steps are its own" in note
    assert "`busy` wait" in found.help[0]


def test_of_two_programs_the_robot_program_is_told_when_it_uses_most() -> None:
    idle = ".PROGRAM busy\nk = 0\nDO\nk = k+1\nWAIT TIMER(1) > k\nUNTIL k < 0\n.END\n"
    body = f"TIMER 1 = 0\nPCEXECUTE busy, -1\n{COUNT.format(-1)}"
    run = runs(body, idle, Scenario(limits=Limits(statements=20_000)))
    (found,) = run.findings
    assert found.headline == "the program is still running after 20,000 steps"
    assert found.primary is not None
    assert found.primary.span.text in ("n = n+1", "UNTIL n == -1", "DO")
    assert "of the steps are of `busy`" in found.notes[0]


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
