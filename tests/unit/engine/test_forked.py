"""What a debugger does within a tick: other values, another step, from one statement on."""

import pytest

from tests.support_programs import compiled, robot_alone
from vrts.engine.controller import AFTERWARDS, execute, forked
from vrts.engine.memory.events import CommandRefused
from vrts.engine.run import OutOfHorizon, Run
from vrts.ir.commands import GoTo, SetLocal, SetVariable, TimedCommand

MODULE = compiled(
    """.PROGRAM main()
 x = 1
 IF x == 2 THEN
  SIGNAL 7
  MOVE far
 END
 CALL sub(x)
 TYPE "done ", x
 DELAY 0.5
 BREAK
 x = 10
.END
.PROGRAM sub(k)
 AUTO m
 m = k+1
 k = m*2
.END
.LOCATIONS
far 700 300 0 90 90 0
.END
""",
    "val2+",
)
LONG = 20.0


def run_of() -> Run:
    return execute(MODULE, robot_alone())


def fork(run: Run, after: int, *commands: SetVariable | SetLocal | GoTo) -> Run:
    time_s = run.at_statement(after).time_s
    return forked(run, [TimedCommand(time_s, c, after) for c in commands], LONG)


def test_a_value_given_between_two_statements_of_a_tick_decides_the_next() -> None:
    run = run_of()
    assert not run.motions
    other = fork(run, 2, SetVariable("x", (), 2.0))  # EXECUTE and `x = 1` are finished
    assert [motion.cause.step for motion in other.motions] == [4]
    assert 7 in other.at(0.0).signals
    assert not run.motions, "the run itself stays as it is"
    assert run.output == "done  4\r\n"
    assert other.output == "done  6\r\n"


def test_states_tell_the_statements_of_a_tick_apart() -> None:
    other = fork(run_of(), 2, SetVariable("x", (), 2.0))
    shown = [7 in other.at_statement(n).signals for n in range(other.statements + 1)]
    first = shown.index(True)
    assert not any(shown[:first])
    assert all(shown[first:])
    assert other.at_statement(first).call_stack[-1].step == 4, "the SIGNAL is done, the MOVE next"
    assert other.at_statement(first - 1).call_stack[-1].step == 3


def test_an_argument_given_another_value_goes_back_to_the_caller() -> None:
    run = run_of()
    inside = next(
        n
        for n in range(run.statements)
        if run.at_statement(n).call_stack[-1:] != ()
        and run.at_statement(n).call_stack[-1].program == "sub"
        and run.at_statement(n).call_stack[-1].step == 3
    )
    assert run.at_statement(inside).locals == {"k": 1.0, "m": 2.0}
    other = fork(run, inside, SetLocal("m", (), 50.0))
    assert other.output == "done  100\r\n"


def test_the_program_goes_on_with_another_step() -> None:
    run = run_of()
    other = fork(run, 2, GoTo(10))
    assert other.output == ""
    assert other.at(other.horizon_s).variables["x"] == 10.0
    refused = fork(run, 2, GoTo(99), SetLocal("nobody", (), 1.0))
    told = [event for event in refused.events if isinstance(event, CommandRefused)]
    assert len(told) == 2
    assert refused.output == run.output


def test_a_wait_is_left_by_going_elsewhere() -> None:
    run = run_of()
    waiting = run.at(0.3)
    assert waiting.call_stack[-1].step == 9
    other = forked(run, [TimedCommand(0.3, GoTo(10))], LONG)
    assert (run.at(0.4).variables["x"], other.at(0.4).variables["x"]) == (4.0, 10.0)
    told = other.at_statement(waiting.finished + 1)  # the command is done, nothing else yet
    assert told.call_stack[-1].step == 10


def test_what_comes_later_than_a_fork_is_forgotten() -> None:
    run = run_of()
    late = fork(run, run.statements - 2, SetVariable("x", (), 99.0))
    assert late.history.issued[-1].after == run.statements - 2
    early = fork(late, 2, SetVariable("x", (), 2.0))
    assert [c.after for c in early.history.issued] == [None, 2]
    again = fork(run, 2, SetVariable("x", (), 2.0))
    assert again.events == early.events


def test_a_fork_that_changes_nothing_is_the_same_run() -> None:
    run = run_of()
    other = fork(run, 2, SetVariable("unused", (), 0.0))
    assert other.output == run.output
    assert other.statements == run.statements + 1, "the command counts"
    with pytest.raises(OutOfHorizon):
        forked(run, [TimedCommand(run.until_s + AFTERWARDS, GoTo(1))], LONG)
