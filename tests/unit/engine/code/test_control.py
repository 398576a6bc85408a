"""Loops, choices, calls and arguments, and what ends a program that does not end by itself."""

import pytest

from tests.support_programs import codes, compiled, happened, ran, run_body, typed
from vrts.engine.controller import execute
from vrts.engine.memory.events import ProgramEnded
from vrts.engine.memory.records import Ending
from vrts.scene.default import robot_alone
from vrts.scene.model import Limits, Scenario

LOOPS = [
    ("FOR i = 1 TO 3\nTYPE i\nEND\nTYPE i", ["1", "2", "3", "4"]),
    ("FOR i = 5 TO 1\nTYPE i\nEND\nTYPE i", ["5"]),
    ("FOR i = 5 TO 1 STEP -2\nTYPE i\nEND\nTYPE i", ["5", "3", "1", "-1"]),
    ("n = 0\nFOR i = 0 TO 1 STEP 0.25\nn = n+1\nEND\nTYPE n", ["5"]),
    ("k = 0\nn = 3\nFOR i = 1 TO n\nn = 10\nk = k+1\nEND\nTYPE k", ["3"]),
    ("i = 9\nDO\ni = i+1\nTYPE i\nUNTIL i > 5", ["10"]),
    ("i = 9\nWHILE i < 5 DO\nTYPE i\nEND\nTYPE i", ["9"]),
    ("i = 3\nWHILE i < 5 DO\ni = i+1\nEND\nTYPE i", ["5"]),
    (
        (
            'CASE 2 OF\nVALUE 1:\nTYPE "A"\nVALUE 2,3:\nTYPE "B"\n'
            'VALUE 2:\nTYPE "C"\nANY\nTYPE "D"\nEND'
        ),
        ["B"],
    ),
    ('CASE 7 OF\nVALUE 1:\nTYPE "A"\nANY\nTYPE "D"\nEND', ["D"]),
    ('CASE 7 OF\nVALUE 1:\nTYPE "A"\nEND\nTYPE "after"', ["after"]),
    ('x = 2\nIF x == 1 THEN\nTYPE "one"\nELSE\nTYPE "other"\nEND', ["other"]),
    ('GOTO 10\nTYPE "skipped"\n10 TYPE "here"', ["here"]),
]


@pytest.mark.parametrize(("body", "lines"), LOOPS)
def test_structure(body: str, lines: list[str]) -> None:
    run = run_body(body)
    assert typed(run) == lines
    assert run.ending is Ending.COMPLETED


CALLS = [
    ("x = 1\nCALL p(x)\nTYPE x", "9"),
    ("x = 1\nCALL p((x))\nTYPE x", "1"),
    ("x = 1\nCALL p(x+0)\nTYPE x", "1"),
    ("x[2] = 1\nCALL p(x[2])\nTYPE x[2]", "9"),
]


@pytest.mark.parametrize(("body", "line"), CALLS)
def test_variables_go_by_reference_and_expressions_by_value(body: str, line: str) -> None:
    assert typed(ran(f".PROGRAM main\n{body}\n.END\n.PROGRAM p(a)\na = 9\n.END\n")) == [line]


def test_a_location_goes_by_reference_too() -> None:
    text = (
        ".PROGRAM main\nSET spot = TRANS(1,2,3,90,90,0)\nCALL p(spot)\nTYPE DX(spot)\n.END\n"
        ".PROGRAM p(where)\nSET where = SHIFT(where BY 10,0,0)\n.END\n"
    )
    assert typed(ran(text)) == ["11"]


def test_an_argument_left_out_has_no_value() -> None:
    text = (
        ".PROGRAM main\nCALL p(,5)\n.END\n.PROGRAM p(a,b)\nTYPE DEFINED(a)\nTYPE DEFINED(b)\n.END\n"
    )
    assert typed(ran(text)) == ["0", "-1"]


def test_return_goes_back_to_the_caller() -> None:
    text = '.PROGRAM main\nCALL p\nTYPE "back"\n.END\n.PROGRAM p\nRETURN\nTYPE "never"\n.END\n'
    assert typed(ran(text)) == ["back"]


def test_a_program_that_is_not_there_is_an_error_when_it_is_called() -> None:
    run = run_body('TYPE "before"\nCALL nosuch')
    assert codes(run) == ["V255"]
    assert typed(run) == ["before"]


@pytest.mark.parametrize(
    ("word", "ending"),
    [("STOP", Ending.COMPLETED), ("HALT", Ending.HALTED), ("PAUSE", Ending.PAUSED)],
)
def test_words_that_end_a_program(word: str, ending: Ending) -> None:
    run = run_body(f'{word}\nTYPE "after"')
    assert run.ending is ending
    assert run.output == ""


LIMITS = [
    ("n = 1\nWHILE n > 0 DO\nn = n+1\nEND", Limits(statements=5000), "V510"),
    ("10 DELAY 1\nGOTO 10", Limits(time_s=20.0), "V511"),
    ("10 DRIVE 1, 0, 100\nGOTO 10", Limits(motions=20), "V512"),
    ('10 TYPE "still here"\nGOTO 10', Limits(output_characters=500), "V513"),
    ("WAIT SIG(1001)", Limits(), "V502"),
]


@pytest.mark.parametrize(("body", "limits", "code"), LIMITS)
def test_what_never_ends_is_stopped(body: str, limits: Limits, code: str) -> None:
    run = run_body(body, scenario=Scenario(limits=limits))
    assert codes(run) == [code]
    assert run.ending is Ending.LIMIT
    (end,) = happened(run, ProgramEnded)
    assert end.time_s == run.ended_s


def test_wait_goes_on_when_the_signal_comes() -> None:
    scenario = Scenario(inputs=((2.0, 1001, True),))
    run = run_body('WAIT SIG(1001)\nTYPE "now"', scenario=scenario)
    (printed,) = [event for event in run.events if type(event).__name__ == "Printed"]
    assert printed.time_s == pytest.approx(2.0, abs=0.028)
    assert run.ending is Ending.COMPLETED


def test_recursion_has_the_depth_of_the_scenario() -> None:
    module = compiled(".PROGRAM main\nCALL main\n.END\n")
    run = execute(module, robot_alone(), Scenario(limits=Limits(call_depth=7)))
    assert codes(run) == ["V258"]


def test_delay_takes_its_time() -> None:
    run = run_body("DELAY 1.4")
    assert run.ended_s == pytest.approx(1.4, abs=3 * 0.028)
    assert run.ended_s is not None
    assert run.ended_s >= 1.4


def test_signals_are_set_cleared_and_read() -> None:
    run = run_body("SIGNAL 1, 2, -2\nTYPE SIG(1,-2)\nTYPE SIG(2)")
    assert typed(run) == ["-1", "0"]
    assert run.at(run.horizon_s).signals == {1}
