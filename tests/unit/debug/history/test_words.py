"""`who`, `next`, `why` and `go`, typed where a run stands."""

from pathlib import Path

import pytest

from tests.places import ROOT
from tests.support_goals import Move, run_of
from tests.support_programs import cans, ran
from tests.unit.debug.test_debugger import debugger
from vrts.check.rules.hints import Hints
from vrts.debug.console import NO_HINTS, Console
from vrts.debug.debugger import Debugger
from vrts.debug.evaluating import CannotTell
from vrts.debug.scripted.commander import carry_out
from vrts.debug.scripted.session import Session
from vrts.engine.memory.events import Grasped
from vrts.why.asking import why_of

EXAMPLE = ROOT / "examples" / "01-cans-on-bases" / "solution.v2"


@pytest.fixture
def there() -> Debugger:
    found = debugger()
    found.seek(found.run.horizon_s)
    return found


@pytest.fixture
def console(there: Debugger, tmp_path: Path) -> Console:
    return Console(there, tmp_path, ())


def test_who_leads_before_the_step_and_next_behind_it(there: Debugger, console: Console) -> None:
    assert "main 4, line 5 `n = n+1`: 3 -> 4" in console.enter("who n")
    console.enter("go")
    assert console.enter("n").strip() == "3"
    assert there.state.span is not None
    cause = there.state.call_stack[-1]
    assert cause.span.line == 5, "the step that writes comes next"
    assert ": 3 -> 4" in console.enter("next n")
    console.enter("go 1")
    assert console.enter("n").strip() == "4"
    assert "does not change any more: 4" in console.enter("next n")


def test_signals_the_arm_and_arguments_have_a_past(there: Debugger, console: Console) -> None:
    assert "line 9 `SIGNAL 5`: off -> on" in console.enter("who SIG(5)")
    assert "`MOVE near`" in console.enter("who HERE")
    there.seek(0.0)
    assert "`MOVE far`" in console.enter("next JT1")
    assert "line 21 `seen = seen+1`: 0 -> 1" in console.enter("next seen")
    assert "given as data" in console.enter("who far")
    there.run_to("main.v2", 17)
    assert "b = a*2" in console.enter("who b")


def test_why_has_numbers_to_go_to(there: Debugger, console: Console) -> None:
    said = console.enter("why n").split("\n")
    assert said[1].startswith("1 ")
    console.enter("go 1")
    assert there.state.call_stack[-1].span.line == 5
    assert "line 9 `SIGNAL 5`" in console.enter("why SIG(5)")


def test_what_leads_nowhere_is_told(console: Console) -> None:
    assert "nothing here is called `nobody`" in console.enter("who nobody")
    assert "there is no signal 999" in console.enter("who SIG(999)")
    assert "`seen`?" in console.enter("who sen")
    assert "takes a name" in console.enter("who")
    console.enter("who n")
    with pytest.raises(CannotTell, match="only 1"):
        console.go("7")
    console.enter("n = 9")
    with pytest.raises(CannotTell, match="another future"):
        console.go("1")


def test_facts_are_told_in_exams_and_causes_are_not(there: Debugger, tmp_path: Path) -> None:
    strict = Console(there, tmp_path, (), Hints.NOTHING)
    assert "3 -> 4" in strict.enter("who n")
    assert strict.enter("why SIG(5)").strip() == NO_HINTS


def test_commands_of_scripts_are_the_same(there: Debugger, console: Console) -> None:
    session = Session(there, console)
    assert "3 -> 4" in carry_out(session, "who n").said[0]
    went = carry_out(session, "go")
    assert went.ok
    assert went.place is not None
    assert went.place.line == 5
    assert not carry_out(session, "who nobody").ok
    assert not carry_out(session, "go 3").ok


def test_a_thing_is_gripped_carried_and_let_go(tmp_path: Path) -> None:
    found = Debugger(run_of(Move("can1", 850, 200, -300)), debugger().dialect)
    console = Console(found, tmp_path, ())
    assert "line 7 `CLOSEI`, it is gripped" in console.enter("next can1")
    console.enter("go")
    assert "nothing -> can1" in console.enter("who holds")
    assert "line 8 `DEPARTS 120.0`, the arm carries it" in console.enter("next can1")
    assert "`CLOSEI`: 80.00 mm -> " in console.enter("who opening")
    found.seek(found.run.horizon_s)
    assert "`OPENI`" in console.enter("who can1")
    assert "can1 -> nothing" in console.enter("who holds")


def test_no_cause_of_a_grip_comes_after_it() -> None:
    text = EXAMPLE.read_text("utf-8")
    run = ran(text, cans())
    grip = next(e for e in run.events if isinstance(e, Grasped))
    chain = why_of(run, grip.body, grip.time_s + 0.5)
    assert len(chain.links) > 1
    assert all(link.time_s is None or link.time_s <= grip.time_s + 1e-6 for link in chain.links)
