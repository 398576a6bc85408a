"""A fault of the judgement costs nothing but the judgement."""

import pytest

from tests.support_engine import main, runs
from tests.support_programs import ALONE, codes, compiled
from vrts.engine.controller import Controller
from vrts.engine.machine.forever import judge, repeats
from vrts.engine.memory.records import Ending
from vrts.ir.commands import Execute
from vrts.scene.model import Limits, Scenario


def fails(*_: object) -> None:
    raise IndexError("list index out of range")


@pytest.fixture(params=[(repeats, "state"), (judge, "repetition"), (judge, "is_hopeless")])
def broken(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> None:
    module, name = request.param
    monkeypatch.setattr(module, name, fails)


@pytest.mark.usefixtures("broken")
def test_a_program_that_ends_ends_as_ever() -> None:
    body = "PCEXECUTE b, -1\nDELAY 3\nWAIT SIG(1001)\nMOVE a"
    scenario = Scenario(inputs=((6.0, 1001, True),))
    run = runs(body, ".PROGRAM b\nWAIT\n.END\n", scenario)
    assert run.ending is Ending.COMPLETED
    assert [d.rule.code for d in run.findings if d.is_error] == []
    assert [d.headline for d in run.findings if d.rule.code == "V505"] in (
        [],
        ["whether this program ever ends is undetermined: vrts failed to judge it"],
    )


@pytest.mark.usefixtures("broken")
def test_a_program_that_never_ends_goes_to_its_limit_and_the_fault_is_told_once() -> None:
    scenario = Scenario(limits=Limits(time_s=30.0))
    more = ".PROGRAM b\nx = RANDOM\nWAIT\n.END\n"
    run = runs("PCEXECUTE b, -1\nWAIT SIG(2001)", more, scenario)
    assert codes(run) == ["V505", "V511"]
    told = run.findings[0]
    assert not told.is_error
    assert "IndexError: list index out of range" in told.notes[1]
    assert run.ended_s == pytest.approx(30.0, abs=0.1)


def test_a_wait_that_nothing_ends_is_told_even_when_nobody_can_say_why(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(judge, "waits", fails)
    run = runs("WAIT SIG(2001)")
    assert codes(run) == ["V505", "V502"]
    assert run.ending is Ending.LIMIT


def test_a_monitor_asks_too_early_rather_than_never(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(judge, "is_hopeless", fails)
    controller = Controller(
        compiled(main("PCEXECUTE b, -1\nWAIT SIG(2001)", ".PROGRAM b\nWAIT\n.END\n")), ALONE
    )
    controller.issue(Execute("main"), 0.0)
    assert controller.advance_until_stopped(60.0).until_s < 1.0
