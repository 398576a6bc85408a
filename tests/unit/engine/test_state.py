"""The state of a run at any time, and after any statement."""

import math
from itertools import pairwise

import pytest

from tests.support_engine import TICK, driven, main, runs
from tests.support_programs import ended, started
from vrts.engine.memory.records import ProgramStatus
from vrts.engine.run import OutOfHorizon, Run, State
from vrts.ir.commands import Abort, MonitorSpeed, Proceed
from vrts.scene.model import Scenario

NEST = (
    "n = 1\nCALL outer(n, 5)\nWAIT TIMER(0) > 3\nn = 99",
    (
        ".PROGRAM outer(k, more)\nAUTO sum\nsum = k+more\nk = sum\nCALL inner(more)\nk = 0\n.END\n"
        ".PROGRAM inner(x)\nAUTO y[]\ny[2] = x*2\nWAIT TIMER(0) > 1\nx = 7\n.END\n"
    ),
)


def stack(state: State) -> list[tuple[str, int]]:
    return [(cause.program, cause.step) for cause in state.call_stack]


def test_variables_have_the_values_of_that_time() -> None:
    run = runs('n = 1\nWAIT TIMER(0) > 1\nn = 2\n$s = "x"\nWAIT TIMER(0) > 2\nSET p = a')
    assert run.at(0.5).variables["n"] == 1.0
    assert "$s" not in run.at(0.5).variables
    assert run.at(1.5).variables["n"] == 2.0
    assert run.at(1.5).variables["$s"] == "x"
    assert "p" not in run.at(1.5).variables
    assert run.at(run.horizon_s).variables["p"] == run.at(0.0).variables["a"]
    assert run.at(0.5).variables["n"] == 1.0  # asked again, backwards


def test_the_call_stack_names_every_program_and_where_it_is() -> None:
    run = runs(*NEST, dialect="vplus")
    assert stack(run.at(0.5)) == [("main", 2), ("outer", 4), ("inner", 3)]
    assert stack(run.at(2.0)) == [("main", 3)]
    assert run.at(0.5).step == 3
    assert run.at(0.5).program == "inner"


def test_arguments_and_automatic_variables_are_those_of_the_innermost_program() -> None:
    run = runs(*NEST, dialect="vplus")
    assert run.at(0.5).locals == {"x": 5.0, "y[2]": 10.0}
    assert run.at(0.5).variables["n"] == 6.0
    assert run.at(2.0).locals == {}


def test_statements_are_steps_of_time() -> None:
    run = runs("n = 0\nFOR i = 1 TO 3\nn = n+i\nEND\nCALL p", ".PROGRAM p\nn = -1\n.END\n")
    values = [run.at_statement(k).variables.get("n") for k in range(run.statements + 1)]
    assert [after for before, after in pairwise(values) if after != before] == [0, 1, 3, 6, -1]


def test_after_every_statement_the_next_one_is_known() -> None:
    run = runs(
        "a1 = 1\nIF a1 == 2 THEN\nb1 = 1\nELSE\nb1 = 2\nEND\nCALL p\nc1 = 3",
        ".PROGRAM p\nx = 1\n.END\n",
    )
    seen: list[tuple[str, int]] = []
    for k in range(run.statements):
        for at in stack(run.at_statement(k))[-1:]:
            if at not in seen:
                seen.append(at)
    assert seen[:4] == [("main", 1), ("main", 2), ("main", 5), ("main", 7)]
    assert ("p", 1) in seen
    assert ("main", 3) not in seen
    assert ("main", 8) in seen


def test_in_a_reaction_the_stack_holds_what_was_interrupted() -> None:
    run = runs(
        "REACT 1003, sub\nWAIT TIMER(0) > 3",
        ".PROGRAM sub\nWAIT TIMER(0) > 2\n.END\n",
        Scenario(inputs=((1.0, 1003, True),)),
    )
    assert stack(run.at(0.5)) == [("main", 2)]
    assert stack(run.at(1.5)) == [("main", 2), ("sub", 1)]
    assert stack(run.at(2.5)) == [("main", 2)]
    robot = run.at(1.5).robot
    assert robot is not None
    assert robot.program == "main"


def test_the_process_program_has_a_stack_of_its_own() -> None:
    run = runs(
        "PCEXECUTE watch\nWAIT TIMER(0) > 2", ".PROGRAM watch\nx = 1\nWAIT TIMER(0) > 1\n.END\n"
    )
    state = run.at(0.5)
    assert stack(state) == [("main", 2)]
    assert [(c.program, c.step) for c in state.process_stack] == [("watch", 2)]
    assert state.process is not None
    assert state.process.program == "watch"
    late = run.at(1.5).process
    assert late is not None
    assert late.status is ProgramStatus.COMPLETED


def test_arm_hand_and_tool() -> None:
    run = runs("OPENI\nMOVE a\nBREAK\nTOOL TRANS(0,0,100,90,-90,0)\nBASE 10\nDELAY 1")
    moving = 0.5 * (started(run)[0] + ended(run)[0])
    assert any(v != 0.0 for v in run.at(moving).velocity)
    assert run.at(0.0).hand_opening == 0.0
    assert run.at(moving).hand_opening == pytest.approx(0.08)
    end = run.at(run.horizon_s)
    assert end.X_FT.translation == pytest.approx((0.0, 0.0, 0.1))
    assert end.base.translation == pytest.approx((0.01, 0.0, 0.0))
    assert run.at(moving).base.translation == (0.0, 0.0, 0.0)
    assert end.X_WT.translation == pytest.approx((0.9, 0.2, 0.0), abs=1e-9)
    assert run.at(moving).X_FT.translation == (0.0, 0.0, 0.0)


def test_speeds() -> None:
    run = driven(main("SPEED 40\nMOVE a\nMOVE b"), 20.0, (1.0, MonitorSpeed(50)))
    assert run.at(0.5).monitor_speed == 100.0
    assert run.at(1.5).monitor_speed == 50.0
    assert run.at(0.5).program_speed == pytest.approx(40.0)
    assert run.at(run.motions[1].start_s + 0.1).program_speed == 100.0


def test_output_up_to_a_time() -> None:
    run = runs('TYPE "one"\nWAIT TIMER(0) > 1\nTYPE "two"')
    assert run.at(0.5).output == "one\r\n"
    assert run.at(1.5 if run.horizon_s > 1.5 else run.horizon_s).output == "one\r\ntwo\r\n"


def test_what_a_program_is_doing() -> None:
    run = driven(main("WAIT TIMER(0) > 3"), 9.0, (1.0, Abort()), (2.0, Proceed()))

    def status(time_s: float) -> ProgramStatus:
        robot = run.at(time_s).robot
        assert robot is not None
        return robot.status

    assert status(1.5) is ProgramStatus.STOPPED
    assert status(8.0) is ProgramStatus.COMPLETED
    assert status(0.5) in (ProgramStatus.RUNNING, ProgramStatus.WAITING)


@pytest.mark.parametrize("time_s", [-0.001, 1e9, math.nan])
def test_a_time_outside_the_run_is_refused(time_s: float) -> None:
    run = runs("DELAY 1")
    with pytest.raises(OutOfHorizon):
        run.at(time_s)


def test_the_state_within_a_tick_is_that_after_it() -> None:
    run: Run = runs("n = 1\nWAIT\nn = 2\nWAIT\nn = 3\nWAIT\nWAIT")
    for k in range(3):
        for part in (0.0, 0.3, 0.99):
            assert run.at((k + part) * TICK).variables["n"] == k + 1.0
