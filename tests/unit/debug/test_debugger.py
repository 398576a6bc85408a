"""Steps, breakpoints and alarms, forward and backward; changes make another future."""

from itertools import pairwise

import pytest

from tests.support_programs import ROOT, cans, compiled, robot_alone
from vrts.debug.alarms import Filter
from vrts.debug.breakpoints import Breakpoint, Watch, counts, lines_with_steps, resolve
from vrts.debug.debugger import Debugger, Way, Why
from vrts.debug.evaluating import CannotTell, evaluate
from vrts.engine.controller import execute
from vrts.engine.run import State
from vrts.ir.commands import Answer, GoTo, SetLocal, SetVariable
from vrts.lang.dialect import DIALECTS

VAL2 = DIALECTS["val2"]
TEXT = """.PROGRAM main()
 PCEXECUTE watch, -1
 n = 0
 WHILE n < 4 DO
  n = n+1
  CALL twice(n, m)
  MOVE far
  BREAK
  SIGNAL 5
  MOVE near
 END
 TYPE "done", m
.END
.PROGRAM twice(a, b)
 b = a*2

 b = b+0
.END
.PROGRAM watch()
 WAIT SIG(5)
 seen = seen+1
 WAIT SIG(-5)
.END
.LOCATIONS
far 700 300 0 90 90 0
near 700 -300 0 90 90 0
.END
.REALS
seen 0
.END
"""


def debugger(text: str = TEXT) -> Debugger:
    return Debugger(execute(compiled(text, "val2+"), robot_alone()), DIALECTS["val2+"])


def place(state: State) -> tuple[str, int]:
    cause = state.call_stack[-1]
    return cause.program, cause.step


def whole(state: State) -> tuple[object, ...]:
    return (
        state.time_s,
        state.finished,
        state.configuration,
        state.call_stack,
        state.variables,
        state.locals,
        state.signals,
        state.output,
    )


def test_it_begins_before_the_first_step() -> None:
    d = debugger()
    assert (d.stop.why, d.at.time_s) == (Why.ENTRY, 0.0)
    assert place(d.state) == ("main", 1)
    assert "n" not in d.state.variables


def test_steps_go_into_over_and_out() -> None:
    d = debugger()
    for _ in range(4):
        d.step(Way.OVER)
    assert place(d.state) == ("main", 5)
    d.step(Way.INTO)
    assert place(d.state) == ("twice", 1)
    assert d.state.locals == {"a": 1.0}
    d.step(Way.OVER)
    assert place(d.state) == ("twice", 3), "the empty line is no step to stop at"
    d.step(Way.OUT)
    assert place(d.state) == ("main", 6)
    d.step_back()
    d.step_back()
    d.step_back()
    assert place(d.state) == ("main", 5)
    d.step(Way.OVER)
    assert place(d.state) == ("main", 6)
    assert d.state.variables["m"] == 2.0


def test_going_back_without_a_trail_passes_over_calls() -> None:
    d = debugger()
    d.run_to("main.v2", 7)
    assert place(d.state) == ("main", 6)
    d.step_back()
    assert place(d.state) == ("main", 5)
    d.step_back()
    assert place(d.state) == ("main", 4)


@pytest.mark.parametrize("way", list(Way))
@pytest.mark.parametrize("process", [False, True])
def test_so_many_steps_forward_and_back_are_the_same_state(way: Way, process: bool) -> None:
    d = debugger()
    states = [whole(d.state)]
    for _ in range(40):
        if d.step(way, process=process).why is Why.END and whole(d.state) == states[-1]:
            break
        states.append(whole(d.state))
    assert len(states) >= 2
    instants = [(time_s, count) for time_s, count, *_ in states]
    assert all(a <= b for a, b in pairwise(instants))
    for state in reversed(states[:-1]):
        d.step_back(process=process)
        assert whole(d.state) == state


def test_a_step_that_waits_is_reached_before_it_waits() -> None:
    d = debugger()
    d.wishes.lines = [Breakpoint(1, "main.v2", 8)]
    stop = d.go_on()
    assert (stop.why, stop.ids, place(d.state)) == (Why.BREAKPOINT, (1,), ("main", 7))
    begun = d.at.time_s
    d.step(Way.OVER)
    assert place(d.state) == ("main", 8)
    assert d.at.time_s > begun + 0.5, "the arm has moved meanwhile"
    assert 5 not in d.state.signals
    d.step(Way.OVER)
    assert 5 in d.state.signals
    d.step_back()
    assert 5 not in d.state.signals


def test_a_step_is_reached_when_the_one_before_is_done() -> None:
    robot = debugger().passages(process=False)
    assert (robot.reached[1:] == robot.before[:-1] + 1).all()
    assert (robot.before > robot.reached).any(), "the other program went on meanwhile"


def test_lines_stop_forward_and_backward() -> None:
    d = debugger()
    d.wishes.lines = [Breakpoint(7, "main.v2", 5)]
    forward = [d.go_on().instant for _ in range(4)]
    assert [d.run.at_moment(*i).variables["n"] for i in forward] == [0.0, 1.0, 2.0, 3.0]
    assert d.go_on().why is Why.END
    backward = [d.reverse().instant for _ in range(4)]
    assert backward == forward[::-1]
    assert d.reverse().why is Why.BEGIN


def test_conditions_and_hits_choose() -> None:
    d = debugger()
    d.wishes.lines = [Breakpoint(1, "main.v2", 15, condition="a == 3")]
    d.go_on()
    assert (place(d.state), d.state.locals["a"]) == (("twice", 1), 3.0)
    assert d.go_on().why is Why.END
    d.restart()
    d.wishes.lines = [Breakpoint(1, "main.v2", 5, hits="% 2")]
    assert [d.go_on().why for _ in range(3)] == [Why.BREAKPOINT, Why.BREAKPOINT, Why.END]
    d.wishes.lines = [Breakpoint(1, "main.v2", 5, condition="a = = 3")]
    d.restart()
    stop = d.go_on()
    assert stop.why is Why.BREAKPOINT
    assert "cannot be worked out" in stop.text


@pytest.mark.parametrize(
    ("rule", "fits"), [("3", [3]), (">=3", [3, 4]), ("> 3", [4]), ("<2", [1]), ("%2", [2, 4])]
)
def test_hit_rules(rule: str, fits: list[int]) -> None:
    assert [n for n in range(1, 5) if counts(rule, n)] == fits


def test_log_points_write_on_the_way() -> None:
    d = debugger()
    d.wishes.lines = [Breakpoint(1, "main.v2", 10, log="n is {n}, x = {DX(HERE)} {nothing}")]
    assert d.go_on().why is Why.END
    assert [logged.text.split(",")[0] for logged in d.log] == [f"n is {k}" for k in (1, 2, 3, 4)]
    assert "x = 700" in d.log[0].text
    assert "<" in d.log[0].text


def test_changes_of_variables_and_signals_stop() -> None:
    d = debugger()
    d.wishes.watches = [Watch(1, "m")]
    texts = [d.go_on().text for _ in range(4)]
    assert texts[:2] == ["m: undefined -> 2", "m: 2 -> 4"]
    assert d.go_on().why is Why.END
    d.restart()
    d.wishes.watches = [Watch(1, "SIG(5)")]
    stop = d.go_on()
    assert (stop.why, stop.text) == (Why.CHANGE, "signal 5 is on")
    assert 5 in d.state.signals


def test_a_value_makes_another_future() -> None:
    d = debugger()
    d.run_to("main.v2", 5)
    assert d.change([SetVariable("n", (), 3.0)]) == []
    assert d.state.variables["n"] == 3.0
    assert place(d.state) == ("main", 4)
    d.wishes.lines = [Breakpoint(1, "main.v2", 5)]
    assert d.go_on().why is Why.END, "the loop runs once"
    assert d.state.output.endswith("8\r\n")
    d.restart()
    assert d.state.variables.get("n") is None


def test_an_argument_and_the_next_step_can_be_changed() -> None:
    d = debugger()
    d.wishes.lines = [Breakpoint(1, "main.v2", 15)]
    d.go_on()
    d.change([SetLocal("a", (), 21.0)])
    d.step(Way.OVER)
    assert d.state.locals["b"] == 42.0
    assert d.change([GoTo(1)]) == []
    assert place(d.state) == ("twice", 1)
    assert d.change([GoTo(99)]) == ["Undefined program or variable name"]


def test_expressions_see_what_the_program_sees() -> None:
    d = debugger()
    d.wishes.lines = [Breakpoint(1, "main.v2", 15)]
    d.go_on()
    plus = DIALECTS["val2+"]
    assert evaluate(d.run, d.at, "a+n", plus) == 2.0
    assert evaluate(d.run, d.at, "DX(far)", plus) == 700.0
    with pytest.raises(CannotTell, match="no value"):
        evaluate(d.run, d.at, "m+1", plus)
    with pytest.raises(CannotTell):
        evaluate(d.run, d.at, "1\n2", plus)


def test_the_first_contact_and_the_line_that_caused_it() -> None:
    text = (ROOT / "examples/01-cans-on-bases/submissions/hits-base.v2").read_text()
    run = execute(compiled(text), cans())
    d = Debugger(run, VAL2)
    d.wishes.filters = frozenset({Filter.CONTACT})
    stop = d.go_on()
    assert stop.why is Why.ALARM
    assert "base" in stop.text
    assert stop.instant.time_s == d.alarms.report.contacts[0].start_s
    moving = d.state.cause
    assert moving is not None
    d.step_back()
    assert d.at < stop.instant
    assert d.go_on().instant == stop.instant


def test_an_answer_can_be_given_where_the_program_is_stuck() -> None:
    d = debugger('.PROGRAM main\n PROMPT "how many? ", k\n TYPE k*2\n.END\n')
    assert d.go_on().why is Why.END
    assert d.asks
    assert max(d.run.event_numbers) <= d.run.statements
    assert d.change([Answer("21")]) == []
    assert d.go_on().why is Why.END
    assert d.state.output.endswith("42\r\n")


def test_ticks_go_both_ways() -> None:
    d = debugger()
    d.seek(1.0)
    tick = d.run.history.tick_s
    first = d.tick(1).instant
    assert first.time_s == pytest.approx(36 * tick)
    assert d.tick(1).instant.time_s == pytest.approx(37 * tick)
    assert d.tick(-1).instant == first


def test_lines_stand_for_steps() -> None:
    code = debugger().run.history.code
    found = resolve(code, "main.v2", 16)
    assert found is not None
    assert found.line == 17, "the next step of the program"
    assert resolve(code, "main.v2", 99) is None
    assert resolve(code, "other.v2", 5) is None
    lines = lines_with_steps(code, "main.v2")
    assert 2 in lines
    assert 16 not in lines


def test_a_condition_of_a_watch_sees_the_variables_of_its_own_call() -> None:
    d = debugger(
        ".PROGRAM main()\n AUTO k\n k = 100\n PCEXECUTE other\n DELAY 1\n TYPE k\n.END\n"
        ".PROGRAM other()\n AUTO k\n k = 1\n k = 2\n CALL up(k)\n k = 4\n.END\n"
        ".PROGRAM up(x)\n AUTO k\n k = 50\n x = 3\n.END\n"
    )
    d.wishes.watches = [Watch(1, "k @ other 1", condition="k == 3")]
    stop = d.go_on()
    assert (stop.why, stop.text, stop.process) == (Why.CHANGE, "k: 2 -> 3", True)
    d.wishes.watches = [Watch(1, "k @ other 1", condition="k > 4")]
    assert d.restart().why is Why.ENTRY
    assert d.go_on().why is Why.END
