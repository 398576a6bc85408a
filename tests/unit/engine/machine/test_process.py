"""The process control program beside the robot program [C96]."""

import pytest

from tests.support_engine import TICK, driven, lines, main, runs, words
from tests.support_programs import codes, ended, switched
from vrts.engine.run import Run
from vrts.scene.model import Scenario

TICKER = ".PROGRAM tick\nn = n+1\nWAIT\n.END\n"


def pc(lines_of_program: str) -> str:
    return f".PROGRAM watch\n{lines_of_program}\n.END\n"


def count(run: Run, time_s: float) -> float:
    value = run.at(time_s).variables["n"]
    assert isinstance(value, float)
    return value


def texts(run: Run) -> list[str]:
    return [text for _, text in lines(run)]


def test_both_programs_run_and_share_variables_and_signals() -> None:
    run = runs(
        'go = 0\nPCEXECUTE watch\nWAIT go == 1\nSIGNAL 2001\nWAIT SIG(1)\nTYPE "robot"',
        pc('TYPE "process"\ngo = 1\nWAIT SIG(2001)\nSIGNAL 1'),
    )
    assert texts(run) == ["process", "robot"]


def test_in_a_tick_the_robot_program_comes_first() -> None:
    run = runs(
        'PCEXECUTE watch\nTYPE "robot"\nWAIT\nTYPE "robot"', pc('TYPE "pc"\nWAIT\nTYPE "pc"')
    )
    assert texts(run) == ["robot", "pc", "robot", "pc"]
    assert [t for t, _ in lines(run)] == pytest.approx([0.0, 0.0, TICK, TICK])


def test_each_has_a_hundred_steps_a_tick() -> None:
    body = "\n".join(f"{{0}}{k} = {k}" for k in range(150))
    run = runs(
        "PCEXECUTE watch\n" + body.format("x") + "\nSIGNAL 1\nWAIT SIG(2)",
        pc(body.format("y") + "\nSIGNAL 2"),
    )
    assert switched(run) == pytest.approx({1: TICK, 2: TICK})


def test_it_works_while_the_arm_moves() -> None:
    run = runs("n = 0\nPCEXECUTE tick, -1\nMOVE a\nBREAK\nTYPE n\nPCABORT", TICKER)
    passes = float(texts(run)[0])
    assert passes == pytest.approx((ended(run)[0] + 3 * TICK) / TICK, abs=2)


@pytest.mark.parametrize(
    "step",
    ["MOVE a", "READY", "SPEED 50", "OPENI", "CLOSE", "GRASP 5", "TOOL NULL", "BASE 0", "DELAY 1"],
)
def test_robot_instructions_are_refused_when_they_are_reached(step: str) -> None:
    run = runs("PCEXECUTE watch\nDELAY 1", pc(f'TYPE "before"\n{step}\nTYPE "after"'))
    assert words(run) == ["Illegal in process control program"]
    assert texts(run) == ["before"]
    assert run.ending.value == "completed"
    assert run.motions == []


@pytest.mark.parametrize("step", ["BRAKE", "SIGNAL 1", "WAIT SIG(0)", "TIMER 1 = 0", "LOCK 3"])
def test_other_instructions_are_not(step: str) -> None:
    run = runs("PCEXECUTE watch\nDELAY 1", pc(f'{step}\nTYPE "after"'))
    assert texts(run) == ["after"]


def test_an_error_in_it_leaves_the_robot_program_alone() -> None:
    run = runs('PCEXECUTE watch\nMOVE a\nMOVE b\nBREAK\nTYPE "done"', pc("TYPE 1/0"))
    assert codes(run) == ["V251"]
    assert texts(run) == ["done"]
    assert run.ending.value == "completed"


def test_there_is_only_one() -> None:
    run = runs("PCEXECUTE watch, -1\nPCEXECUTE watch", pc("WAIT"))
    assert words(run) == ["Process control program executing"]
    assert words(runs("PCEXECUTE nosuch")) == ["Undefined program or variable name"]
    assert words(runs("PCEXECUTE")) == ["Undefined program or variable name"]


def test_it_may_be_started_again_when_it_has_ended() -> None:
    run = runs("PCEXECUTE watch\nDELAY 0.5\nBREAK\nPCEXECUTE\nDELAY 0.5", pc('TYPE "pc"'))
    assert texts(run) == ["pc", "pc"]


@pytest.mark.parametrize(("cycles", "passes"), [("", 1), (", 3", 3), (", 0", 1)])
def test_cycles(cycles: str, passes: int) -> None:
    run = runs(f"n = 0\nPCEXECUTE tick{cycles}\nDELAY 1\nBREAK\nTYPE n", TICKER)
    assert texts(run) == [str(passes)]


def test_it_may_begin_at_a_step() -> None:
    run = runs("PCEXECUTE watch, 2, 2\nDELAY 1", pc('TYPE "one"\nTYPE "two"'))
    assert texts(run) == ["two", "one", "two"]


def test_pcabort_stops_it_after_its_step() -> None:
    run = runs(
        "n = 0\nPCEXECUTE tick, -1\nDELAY 1\nBREAK\nPCABORT\nk = n\nDELAY 1\nBREAK\nTYPE n-k",
        TICKER,
    )
    assert texts(run) == ["0"]


def test_pcend_stops_it_at_the_end_of_its_cycle() -> None:
    watch = pc('TYPE "begin"\nWAIT SIG(2001)\nTYPE "end"')
    run = runs("PCEXECUTE watch, -1\nWAIT\nPCEND\nWAIT\nSIGNAL 2001\nDELAY 1", watch)
    assert texts(run) == ["begin", "end"]
    run = runs(
        "PCEXECUTE watch, -1\nWAIT\nPCEND\nPCEND -1\nSIGNAL 2001\nWAIT\nSIGNAL -2001\nDELAY 1",
        watch,
    )
    assert texts(run)[:3] == ["begin", "end", "begin"]


def test_reactions_of_the_process_program() -> None:
    run = runs(
        "PCEXECUTE watch\nMOVE a\nBREAK",
        pc('REACT 1003, sub\nWAIT TIMER(0) > 1\nTYPE "pc"') + '.PROGRAM sub\nTYPE "sub"\n.END\n',
        Scenario(inputs=((0.5, 1003, True),)),
    )
    assert texts(run) == ["sub", "pc"]


def test_reacti_of_the_process_program_cuts_the_motion() -> None:
    run = runs(
        "PCEXECUTE watch\nMOVE #PPOINT(150,-90,90,0,0,0)\nBREAK\nSIGNAL 1",
        pc("REACTI 1003, sub\nWAIT TIMER(0) > 3") + '.PROGRAM sub\nTYPE "sub"\n.END\n',
        Scenario(inputs=((0.5, 1003, True),)),
    )
    assert run.motions[0].cut
    assert switched(run)[1] == pytest.approx(run.motions[0].end_s + 3 * TICK, abs=TICK)


def test_a_process_program_goes_on_when_the_robot_program_has_ended() -> None:
    run = driven(main("PCEXECUTE tick, -1", ".PROGRAM tick\nk = k+1\nWAIT\n.END\n"), 3.0)
    assert words(run) == ["Undefined value"]
    run = driven(main("n = 0\nPCEXECUTE tick, -1", TICKER), 3.0)
    assert count(run, 2.9) == pytest.approx(2.9 / TICK, abs=2)


def test_a_process_program_that_waits_when_all_is_over_is_no_fault() -> None:
    run = runs("PCEXECUTE watch", pc("WAIT SIG(1001)"))
    assert codes(run) == []
    assert run.ending.value == "completed"


def test_what_the_last_step_of_one_program_changes_the_other_sees() -> None:
    run = runs('done = 0\nPCEXECUTE watch\nWAIT done\nTYPE "seen"', pc("WAIT\ndone = 1"))
    assert codes(run) == []
    assert texts(run) == ["seen"]
