"""REACTE: run-time errors call a program; RETURN tries again, RETURNE goes on behind the step."""

import pytest

from tests.support_engine import driven, lines, main, reacted, runs, words
from tests.support_programs import codes
from vrts.engine.run import Run
from vrts.ir.commands import Execute

MEND = ".PROGRAM mend\n{}\n.END\n"


def texts(run: Run) -> list[str]:
    return [text for _, text in lines(run)]


def test_returne_goes_on_behind_the_step_that_failed() -> None:
    run = runs('REACTE mend\nx = 1/0\nTYPE "after"', MEND.format('TYPE "error"\nRETURNE'))
    assert texts(run) == ["error", "after"]
    assert codes(run) == []
    (reaction,) = reacted(run)
    assert (reaction.signal, reaction.program) == (0, "mend")


def test_return_does_the_step_again() -> None:
    run = runs('n = 0\nREACTE mend\nTYPE 12/n\nTYPE "after"', MEND.format("n = n+4\nRETURN"))
    assert texts(run) == ["3", "after"]


def test_an_error_program_that_does_not_say_how_to_go_on_ends_the_cycle() -> None:
    text = main('REACTE mend\nn = n+1\nx = 1/0\nTYPE "never"', MEND.format("TYPE n"))
    text = text.replace(".LOCATIONS", ".REALS\nn 0\n.END\n.LOCATIONS")
    run = driven(text, 2.0, (1.0, Execute("main", 2)))
    assert texts(run) == ["1", "2", "3"]
    assert run.ending.value == "completed"


def test_errors_in_programs_called_are_caught_too() -> None:
    more = MEND.format("RETURNE") + '.PROGRAM sub\nx = 1/0\nTYPE "sub goes on"\n.END\n'
    run = runs('REACTE mend\nCALL sub\nTYPE "main goes on"', more)
    assert texts(run) == ["sub goes on", "main goes on"]


def test_an_error_in_the_error_program_stops() -> None:
    run = runs("REACTE mend\nx = 1/0", MEND.format("TYPE nothing\nRETURNE"))
    assert words(run) == ["Undefined value"]


def test_without_operand_errors_stop_again() -> None:
    run = runs("REACTE mend\nx = 1/0\nREACTE\nx = 1/0", MEND.format('TYPE "caught"\nRETURNE'))
    assert texts(run) == ["caught"]
    assert words(run) == ["Division by zero"]


def test_a_later_one_replaces_the_first() -> None:
    more = MEND.format('TYPE "one"\nRETURNE') + '.PROGRAM two\nTYPE "two"\nRETURNE\n.END\n'
    assert texts(runs("REACTE mend\nREACTE two\nx = 1/0", more)) == ["two"]


def test_the_trap_ends_with_the_program() -> None:
    text = main("IF DEFINED(n) THEN\nx = 1/0\nEND\nn = 1\nREACTE mend", MEND.format("RETURNE"))
    run = driven(text, 2.0, (1.0, Execute("main")))
    assert words(run) == ["Division by zero"]


@pytest.mark.parametrize("body", ["RETURNE", "CALL sub"])
def test_returne_elsewhere_is_an_error(body: str) -> None:
    assert words(runs(body, ".PROGRAM sub\nRETURNE\n.END\n")) == ["Illegal RETURNE"]


def test_nothing_interrupts_an_error_program() -> None:
    more = (
        MEND.format('TYPE "begins"\nSIGNAL 2001\nWAIT\nWAIT\nTYPE "ends"\nRETURNE')
        + '.PROGRAM sub\nTYPE "reaction"\n.END\n'
    )
    run = runs("REACT 2001, sub, 127\nREACTE mend\nx = 1/0\nTYPE PRIORITY", more, dialect="val2+")
    assert texts(run) == ["begins", "ends", "reaction", "0"]


def test_a_motion_that_cannot_be_made_can_be_caught() -> None:
    run = runs(
        'REACTE mend\nMOVE TRANS(3000,0,0,90,90,0)\nMOVE a\nBREAK\nTYPE "there"',
        MEND.format("TYPE ERROR(-1)\nRETURNE"),
    )
    assert texts(run) == ["-617", "there"]
    assert len(run.motions) == 1


def test_error_tells_the_number_and_the_words() -> None:
    run = runs(
        "REACTE mend\nTYPE ERROR(-1)\nx = 1/0\nx = SQRT(-1)\nTYPE nothing",
        MEND.format("TYPE ERROR(-1), $ERROR(ERROR(-1))\nRETURNE"),
    )
    assert texts(run) == [
        "0",
        "-415*Division by zero*",
        "-410*Negative square root*",
        "-401*Undefined value*",
    ]


def test_a_process_program_has_its_own_trap() -> None:
    run = runs(
        "REACTE mend\nPCEXECUTE watch\nDELAY 1\nBREAK\nTYPE ERROR(-1)",
        MEND.format("RETURNE") + ".PROGRAM watch\nx = 1/0\n.END\n",
    )
    assert words(run) == ["Division by zero"]
    assert texts(run) == ["0"]
