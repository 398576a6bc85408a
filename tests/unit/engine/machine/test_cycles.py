"""What a new execution cycle begins with, and what it finds as it was [3.0]."""

import pytest

from tests.support_engine import driven, lines, main, runs
from tests.support_programs import ended
from vrts.engine.memory.events import HandCommanded, SignalChanged
from vrts.engine.run import Run
from vrts.ir.commands import Execute
from vrts.scene.model import Scenario

MORE = (
    '.PROGRAM note\nTYPE "noted"\n.END\n.PROGRAM mend\nTYPE "mended"\nRETURNE\n.END\n'
    ".REALS\nn 0\n.END\n"
)


def twice(body: str, scenario: Scenario | None = None) -> Run:
    """Execute the lines for two cycles; n counts them."""
    text = main(f"n = n+1\n{body}", MORE)
    return driven(text, 30.0, (10.0, Execute("main", 1)), scenario=scenario)


def texts(run: Run) -> list[str]:
    return [text for _, text in lines(run)]


RESET: list[tuple[str, list[str]]] = [
    ("TYPE SPEED(2)\nSPEED 30 ALWAYS", ["100", "100"]),
    ("TYPE SPEED(3)\nSPEED 30", ["100", "100"]),
    ("IF n == 1 THEN\nREACT 2001, note\nELSE\nSIGNAL 2001\nWAIT\nEND", []),
    ("IF n == 1 THEN\nREACTE mend\nELSE\nx = 1/0\nEND", []),
]
KEPT = [
    ("TYPE DZ(TOOL)\nTOOL TRANS(0,0,50,90,-90,0)", ["0", "50"]),
    ("TYPE DX(BASE)\nBASE 70", ["0", "70"]),
    ("TYPE SIG(3)\nSIGNAL 3", ["0", "-1"]),
    ("TYPE SWITCH(CP)\nDISABLE CP", ["-1", "0"]),
    ("TYPE PARAMETER(SPEED.MAX)\nPARAMETER SPEED.MAX = 60", ["100", "60"]),
    ("IF n == 2 THEN\nTYPE TIMER(1) > 50\nEND\nTIMER 1 = 100", ["-1"]),
    ("TYPE DEFINED(k)\nk = 1", ["0", "-1"]),
]


@pytest.mark.parametrize(("body", "expected"), RESET)
def test_settings_and_reactions_begin_anew(body: str, expected: list[str]) -> None:
    assert texts(twice(body)) == expected


@pytest.mark.parametrize(("body", "expected"), KEPT)
def test_all_else_stays(body: str, expected: list[str]) -> None:
    assert texts(twice(body)) == expected


def test_the_priority_is_zero_again() -> None:
    body = "IF n == 1 THEN\nLOCK 9\nELSE\nREACT 2001, note, 1\nSIGNAL 2001\nWAIT\nEND"
    assert texts(twice(body)) == ["noted"]


def test_accuracy_and_nulling_are_those_of_the_start() -> None:
    body = "MOVE a\nBREAK\nSIGNAL n\nMOVE b\nBREAK\nNONULL ALWAYS\nCOARSE ALWAYS"
    run = twice(body)
    on = [e.time_s for e in run.events if isinstance(e, SignalChanged)]
    waits = [at - before for at, before in zip(on, ended(run)[0::2], strict=True)]
    assert waits == pytest.approx([3 * 0.028] * 2)


def test_the_hand_forgets_what_it_was_to_do_with_the_next_motion() -> None:
    run = twice("IF n == 2 THEN\nDRIVE 1, 5\nEND\nOPEN")
    assert [e for e in run.events if isinstance(e, HandCommanded)] == []


def test_cycles_of_one_execution_begin_anew_too() -> None:
    text = main("TYPE SPEED(2)\nSPEED 30 ALWAYS", MORE)
    assert texts(driven(text, 9.0, (1.0, Execute("main", 3)))) == ["100"] * 4


def test_a_program_that_is_called_shares_the_settings_of_its_caller() -> None:
    more = ".PROGRAM p\nTYPE SPEED(2)\nSPEED 40 ALWAYS\n.END\n"
    run = runs("SPEED 30 ALWAYS\nCALL p\nTYPE SPEED(2)", more)
    assert texts(run) == ["30", "40"]
