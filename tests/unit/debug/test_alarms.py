"""Goals not reached, things not picked up and things dropped are alarms, each with its moment."""

from pathlib import Path

import pytest

from tests.support_programs import ROOT, cans, compiled
from vrts.debug.alarms import DEFAULT, Alarm, Filter
from vrts.debug.debugger import Debugger, Why
from vrts.debug.opening import Asked, opened
from vrts.engine.controller import execute
from vrts.lang.dialect import DIALECTS

FOLDER = ROOT / "examples/01-cans-on-bases"


def debugger(program: Path) -> Debugger:
    found = opened(Asked(program)).debugger
    assert found is not None
    return found


def alarms(name: str) -> list[Alarm]:
    return debugger(FOLDER / "submissions" / name).alarms.of(DEFAULT - {Filter.CONTACT})


def told(found: list[Alarm]) -> list[tuple[str, str, int | None]]:
    return [(a.filter.value, a.text, a.cause.span.line if a.cause else None) for a in found]


def test_what_falls_over_is_told_when_it_falls_and_with_the_step_that_let_go() -> None:
    found = alarms("wrong-orientation.v2")
    assert told(found) == [
        ("dropped", "can1 cannot stand on base2", 23),
        ("goal-not-reached", "can1 has toppled", 23),
    ]
    assert found[0].instant == found[1].instant


def test_what_is_never_picked_up_is_told_at_the_nearest_try() -> None:
    found = alarms("endless-loop.v2")
    assert told(found)[0] == (
        "not-picked-up",
        "can2 is never picked up: the hand closes on nothing",
        18,
    )
    assert found[0].instant.time_s == pytest.approx(7.58)
    assert told(found)[-1] == ("goal-not-reached", "can2 is 632 mm from its goal", None)
    assert [a.instant for a in found] == sorted(a.instant for a in found)


def test_a_step_back_from_an_alarm_stands_on_its_cause() -> None:
    d = debugger(FOLDER / "submissions" / "wrong-orientation.v2")
    d.wishes.filters = DEFAULT - {Filter.CONTACT}
    stop = d.go_on()
    assert stop.why is Why.ALARM
    assert stop.text == "can1 cannot stand on base2; can1 has toppled"
    assert stop.cause is not None
    d.step_back()
    assert d.state.call_stack[-1] == stop.cause
    assert d.go_on() == stop


def test_a_right_program_has_no_alarm() -> None:
    d = debugger(FOLDER / "solution.v2")
    d.wishes.filters = DEFAULT
    assert d.go_on().why is Why.END


def test_a_task_without_hints_does_not_tell_where_things_belong(tmp_path: Path) -> None:
    text = (FOLDER / "task.toml").read_text()
    (tmp_path / "task.toml").write_text(f'{text}\n[hints]\nlevel = "nothing"\n')
    program = tmp_path / "program.v2"
    program.write_text((FOLDER / "submissions" / "inches.v2").read_text())
    d = debugger(program)
    assert not d.alarms.of(frozenset({Filter.GOAL}))


def test_the_cause_is_found_inside_a_program_that_is_over() -> None:
    text = (FOLDER / "submissions" / "hits-base.v2").read_text()
    step = "APPROS base2_put, 60"
    program = text.replace(step, "CALL go_there", 1)
    program = program.replace(".LOCATIONS", f".PROGRAM go_there()\n {step}\n.END\n.LOCATIONS", 1)
    d = Debugger(execute(compiled(program), cans()), DIALECTS["val2"])
    d.wishes.filters = frozenset({Filter.CONTACT})
    stop = d.go_on()
    assert stop.cause is not None
    assert (stop.cause.program, d.state.call_stack[-1].program) == ("go_there", "main")
    d.step_back()
    assert d.state.call_stack[-1] == stop.cause
    assert d.go_on() == stop
