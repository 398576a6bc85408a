"""PCEND and CYCLE.END keep the cycles that are left for PCPROCEED and PROCEED."""

from tests.support_engine import driven, lines, main, refused
from vrts.engine.run import Run
from vrts.ir.commands import EndCycle, EndProcess, Execute, Proceed, ProceedProcess

WATCH = '.PROGRAM watch\nTYPE "pass"\nTIMER 1 = 0\nWAIT TIMER(1) >= 1\n.END\n'


def passes(run: Run, until_s: float) -> int:
    return sum(1 for at, text in lines(run) if text == "pass" and at <= until_s)


def test_pcproceed_makes_the_cycles_that_pcend_left() -> None:
    run = driven(
        main("PCEXECUTE watch, 4", WATCH), 20.0, (1.5, EndProcess()), (5.0, ProceedProcess())
    )
    assert passes(run, 4.9) == 2
    assert passes(run, 20.0) == 4
    assert refused(run) == []


def test_endless_ones_stay_endless() -> None:
    run = driven(
        main("PCEXECUTE watch, -1", WATCH), 12.0, (1.5, EndProcess()), (5.0, ProceedProcess())
    )
    assert passes(run, 4.9) == 2
    assert passes(run, 12.0) >= 8


def test_a_program_that_has_made_all_its_cycles_cannot_go_on() -> None:
    run = driven(main("PCEXECUTE watch, 2", WATCH), 9.0, (5.0, ProceedProcess()))
    assert refused(run) == ["Program cannot be resumed"]
    assert passes(run, 9.0) == 2


def test_proceed_makes_the_cycles_that_cycle_end_left() -> None:
    text = main('TYPE "pass"\nDELAY 1\nBREAK')
    run = driven(text, 20.0, (2.0, Execute("main", 3)), (2.5, EndCycle()), (6.0, Proceed()))
    assert passes(run, 5.9) == 1 + 1
    assert passes(run, 20.0) == 1 + 3
