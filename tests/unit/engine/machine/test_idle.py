"""When a monitor takes the next line: the robot program rests, or waits in vain."""

import pytest

from tests.support_engine import main
from tests.support_programs import ALONE, compiled
from vrts.engine.controller import Controller
from vrts.ir.commands import Execute

SETS = "TIMER 1 = 0\nWAIT TIMER(1) > 5\nSIGNAL 2001"


def rests_at(body: str, watch: str) -> float:
    text = main(body, f".PROGRAM b\n{watch}\n.END\n")
    controller = Controller(compiled(text, "val2+"), ALONE)
    controller.issue(Execute("main"), 0.0)
    return controller.advance_until_stopped(60.0).until_s


def test_what_the_other_program_brings_about_is_waited_for() -> None:
    assert rests_at("PCEXECUTE b\nWAIT SIG(2001)\nDELAY 3", SETS) == pytest.approx(8.0, abs=0.1)
    assert rests_at("REACT 2001\nPCEXECUTE b\nPROMPT n", SETS) == pytest.approx(5.0, abs=0.5)


def test_a_question_is_asked_at_once_whatever_goes_on_beside_it() -> None:
    assert rests_at("PCEXECUTE b, -1\nPROMPT n", "n = 1\nWAIT") < 0.5


def test_nobody_waits_for_an_input_that_only_the_operator_gives() -> None:
    assert rests_at("PCEXECUTE b, -1\nWAIT SIG(1001)", "n = 1\nWAIT") < 1.0
