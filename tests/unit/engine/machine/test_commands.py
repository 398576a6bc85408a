"""Commands that start, stop and resume programs, and when they are refused."""

import pytest

from tests.support_engine import TICK, driven, lines, main, of_kind, refused, words
from tests.support_programs import ALONE, compiled, ended, started
from vrts.engine.controller import Controller
from vrts.engine.memory.events import ProgramEnded, ProgramStarted
from vrts.engine.memory.records import Ending
from vrts.engine.run import Run
from vrts.ir.commands import (
    Abort,
    Answer,
    Command,
    EndCycle,
    EndProcess,
    Execute,
    Kill,
    Panic,
    Proceed,
    ProceedProcess,
    Retry,
    RetryProcess,
    RunSteps,
)

STEPS = "TYPE 1\nTYPE 2\nTYPE 3\nTYPE 4"


def texts(run: Run) -> list[str]:
    return [text for _, text in lines(run)]


EXECUTING = "Illegal when program executing"
NOT = "No program is executing"
CANNOT = "Program cannot be resumed"
WHILE_RUNNING: list[tuple[Command, list[str]]] = [
    (Execute("main"), [EXECUTING]),
    (Proceed(), [EXECUTING]),
    (Retry(), [EXECUTING]),
    (RunSteps(), [EXECUTING]),
    (Kill(), [EXECUTING]),
    (Answer("x"), []),
    (EndCycle(), []),
    (EndProcess(), []),
    (ProceedProcess(), [CANNOT]),
    (RetryProcess(), [CANNOT]),
]
AT_REST: list[tuple[Command, list[str]]] = [
    (Abort(), [NOT]),
    (EndCycle(), [NOT]),
    (Proceed(), [CANNOT]),
    (Retry(), [CANNOT]),
    (RunSteps(), [CANNOT]),
    (Kill(), []),
    (Panic(), []),
]


@pytest.mark.parametrize(("command", "why"), WHILE_RUNNING)
def test_while_a_program_executes(command: Command, why: list[str]) -> None:
    run = driven(main("WAIT TIMER(0) > 3"), 4.0, (1.0, command))
    assert refused(run) == why
    assert run.ending is Ending.COMPLETED


@pytest.mark.parametrize(("command", "why"), AT_REST)
def test_while_none_does(command: Command, why: list[str]) -> None:
    run = driven(main("TYPE 1"), 3.0, (1.0, command))
    assert refused(run) == why
    assert texts(run) == ["1"]


def test_a_command_is_carried_out_at_the_tick_that_follows() -> None:
    run = driven(main("TYPE 1"), 3.0, (1.0, Execute("main")))
    starts = of_kind(run, ProgramStarted)
    assert starts[1].time_s == pytest.approx(36 * TICK)
    assert 1.0 <= starts[1].time_s < 1.0 + TICK


def test_execute_counts_cycles_and_begins_at_a_step() -> None:
    text = main('TYPE "one"\nTYPE "two"')
    run = driven(text, 4.0, (1.0, Execute("main", 2, 2)))
    assert texts(run) == ["one", "two", "two", "one", "two"]


def test_endless_cycles_end_with_their_cycle() -> None:
    text = main("TYPE 1\nDELAY 1\nBREAK")
    run = driven(text, 9.0, (2.0, Execute("main", -1)), (4.5, EndCycle()))
    assert run.ending is Ending.COMPLETED
    assert len(texts(run)) == 1 + 3
    assert of_kind(run, ProgramEnded)[-1].time_s == pytest.approx(5.2, abs=0.2)


def test_an_aborted_program_goes_on_where_it_was() -> None:
    text = main("TYPE 1\nWAIT TIMER(0) > 5\nTYPE 2")
    run = driven(text, 9.0, (1.0, Abort()), (3.0, Proceed()))
    assert texts(run) == ["1", "2"]
    assert lines(run)[1][0] == pytest.approx(5.0, abs=2 * TICK)
    assert [e.ending for e in of_kind(run, ProgramEnded)] == ["aborted", "completed"]


def test_nothing_happens_while_it_is_aborted() -> None:
    text = main("n = 0\nDO\nn = n+1\nWAIT\nUNTIL n > 100")
    run = driven(text, 9.0, (1.0, Abort()), (5.0, Proceed()))
    assert run.at(1.1).variables["n"] == run.at(4.9).variables["n"]
    assert run.ending is Ending.COMPLETED


def test_a_pause_is_left_with_proceed() -> None:
    run = driven(main("TYPE 1\nPAUSE\nTYPE 2"), 3.0, (1.0, Proceed()))
    assert texts(run) == ["1", "2"]


@pytest.mark.parametrize("word", ["HALT", "STOP"])
def test_what_has_ended_for_good_cannot_be_resumed(word: str) -> None:
    run = driven(main(f"TYPE 1\n{word}\nTYPE 2"), 3.0, (1.0, Proceed()))
    assert refused(run) == [CANNOT]
    assert texts(run) == ["1"]


def test_after_an_error_proceed_goes_on_behind_and_retry_does_the_step_again() -> None:
    text = main("TYPE 1\nTYPE x\nTYPE 3")
    behind = driven(text, 3.0, (1.0, Proceed()))
    assert texts(behind) == ["1", "3"]
    again = driven(text, 3.0, (1.0, Retry()))
    assert texts(again) == ["1"]
    assert words(again) == ["Undefined value"] * 2


def test_proceed_behind_a_last_step_that_failed_ends_the_program() -> None:
    run = driven(main("TYPE 1\nTYPE x"), 3.0, (1.0, Proceed()))
    assert words(run) == ["Undefined value"]
    assert run.ending is Ending.COMPLETED


def test_kill_clears_what_stopped() -> None:
    run = driven(main("PAUSE\nTYPE 2"), 3.0, (1.0, Kill()), (2.0, Proceed()))
    assert refused(run) == [CANNOT]
    assert run.ending is Ending.NOT_STARTED


def test_single_steps() -> None:
    text = main("PAUSE\n" + STEPS)
    run = driven(text, 6.0, (1.0, RunSteps()), (2.0, RunSteps(2)), (4.0, Proceed()))
    assert texts(run) == ["1", "2", "3", "4"]
    assert [len(texts_until(run, t)) for t in (0.9, 1.5, 2.5, 3.9, 5.0)] == [0, 1, 3, 3, 4]
    endings = [e.ending for e in of_kind(run, ProgramEnded)]
    assert endings == ["paused", "stepped", "stepped", "completed"]


def texts_until(run: Run, time_s: float) -> list[str]:
    return [text for at, text in lines(run) if at <= time_s]


def test_a_step_of_several_instructions_is_one_step() -> None:
    text = main("PAUSE\nFOR i = 1 TO 2\nTYPE i\nEND\nTYPE 9")
    run = driven(text, 20.0, *((1.0 + k, RunSteps()) for k in range(3)))
    assert texts(run) == ["1"]
    assert [cause.step for cause in run.at(20.0).call_stack] == [2]  # FOR is looked at again


def test_a_call_may_count_as_one_step() -> None:
    sub = ".PROGRAM sub\nTYPE 11\nTYPE 12\n.END\n"
    text = main("PAUSE\nCALL sub\nTYPE 2", sub)
    into = driven(text, 4.0, (1.0, RunSteps()), (2.0, RunSteps()))
    assert texts(into) == ["11"]
    over = driven(text, 4.0, (1.0, RunSteps(1, over_calls=True)), (2.0, RunSteps()))
    assert texts(over) == ["11", "12", "2"]


def test_a_stepped_motion_ends_before_the_next_step() -> None:
    run = driven(main("PAUSE\nMOVE a\nMOVE b"), 20.0, (1.0, RunSteps()), (5.0, RunSteps()))
    assert len(run.motions) == 2
    assert started(run)[1] >= 5.0
    assert ended(run)[0] < 5.0


def test_a_controller_goes_on_until_the_program_has_stopped() -> None:
    controller = Controller(compiled(main("MOVE a\nPAUSE\nMOVE b\nPROMPT x\nTYPE x")), ALONE)
    controller.issue(Execute("main"), 0.0)
    run = controller.advance_until_stopped(60.0)
    assert run.ending is Ending.PAUSED
    first = run.until_s
    assert first == pytest.approx(ended(run)[0], abs=4 * TICK)
    controller.issue(Proceed(), first)
    run = controller.advance_until_stopped(60.0)
    assert run.at(run.until_s).awaits_answer
    controller.issue(Answer("7"), run.until_s)
    run = controller.advance_until_stopped(60.0)
    assert texts(run)[-1] == "7"
    assert run.ending is Ending.COMPLETED


def test_a_program_waiting_for_an_answer_gets_it() -> None:
    run = driven(main('PROMPT "how many? ", n\nTYPE 2*n'), 5.0, (2.0, Answer("21")))
    assert texts(run) == ["how many?", "21", "42"]
    assert run.at(1.0).awaits_answer
    assert not run.at(3.0).awaits_answer
