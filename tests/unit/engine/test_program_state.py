"""What a program is doing, at any time: running or stopped, in which cycle, with which priority."""

from tests.support_engine import driven, main
from vrts.engine.memory.records import ProgramState, ProgramStatus
from vrts.engine.run import Run
from vrts.ir.commands import Abort, Execute, Proceed


def state(run: Run, time_s: float) -> ProgramState:
    found = run.at(time_s).robot
    assert found is not None
    return found


def test_a_program_that_was_resumed_runs() -> None:
    run = driven(main("WAIT TIMER(0) > 4"), 9.0, (1.0, Abort()), (2.0, Proceed()))
    going = (ProgramStatus.RUNNING, ProgramStatus.WAITING)
    assert state(run, 0.5).status in going
    assert state(run, 1.5).status is ProgramStatus.STOPPED
    assert state(run, 2.5).status in going
    assert state(run, 6.0).status is ProgramStatus.COMPLETED


def test_cycles_are_those_of_that_time() -> None:
    run = driven(main("DELAY 1\nBREAK"), 9.0, (2.0, Execute("main", 3)))
    counts = [(state(run, t).cycles_done, state(run, t).cycles_left) for t in (2.5, 3.5, 4.5, 8.0)]
    assert counts == [(0, 3), (1, 2), (2, 1), (3, 0)]


def test_the_priority_is_that_of_that_time() -> None:
    run = driven(main("WAIT TIMER(0) > 1\nLOCK 5\nWAIT TIMER(0) > 2\nLOCK 0\nDELAY 1\nBREAK"), 9.0)
    assert [state(run, t).priority for t in (0.5, 1.5, 2.5)] == [0, 5, 0]


def test_within_a_tick_a_program_runs_until_its_last_statement_is_finished() -> None:
    run = driven(main("n = 1\nn = 2\nn = 3"), 1.0)
    ended = run.at(run.horizon_s)
    assert ended.robot is not None
    assert ended.robot.status is ProgramStatus.COMPLETED
    for finished in range(run.statements):
        state = run.at_moment(0.0, finished).robot
        assert state is None or state.status is ProgramStatus.RUNNING, finished
