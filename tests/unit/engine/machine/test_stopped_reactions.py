"""Reactions of a program that is stopped, and goes on."""

from tests.support_engine import driven, lines, main, of_kind
from tests.support_programs import compiled, started
from vrts.engine.memory.events import HandCommanded
from vrts.engine.run import Run
from vrts.ir.commands import Abort, Command, Do, Proceed
from vrts.scene.model import Scenario

SUB = '.PROGRAM sub\nTYPE "reacted"\n.END\n.PROGRAM mend\nTYPE "mended"\nRETURNE\n.END\n'
DO = Do(compiled(".PROGRAM do.it\nSIGNAL 5\n.END\n"))


def resumed(body: str, at_s: float, *commands: tuple[float, Command]) -> Run:
    scenario = Scenario(inputs=((at_s, 1003, True),))
    return driven(main(body, SUB), 9.0, *commands, scenario=scenario)


def texts(run: Run) -> list[str]:
    return [text for _, text in lines(run)]


WAIT = 'REACT 1003, sub\nWAIT TIMER(0) > 5\nTYPE "end"'


def test_a_signal_that_comes_while_the_program_is_stopped_is_lost() -> None:
    assert texts(resumed(WAIT, 2.0, (1.0, Abort()), (3.0, Proceed()))) == ["end"]


def test_one_that_comes_after_it_was_resumed_is_seen() -> None:
    assert texts(resumed(WAIT, 4.0, (1.0, Abort()), (3.0, Proceed()))) == ["reacted", "end"]


def test_do_in_between_leaves_the_watch() -> None:
    run = resumed(WAIT, 4.0, (1.0, Abort()), (2.0, DO), (3.0, Proceed()))
    assert texts(run) == ["reacted", "end"]


def test_do_leaves_the_trap_of_errors_and_the_lock() -> None:
    body = 'REACTE mend\nLOCK 9\nPAUSE\nx = 1/0\nTYPE PRIORITY\nLOCK 0\nTYPE "end"'
    text = main(body, SUB).replace("TYPE PRIORITY\n", "")
    run = driven(text, 9.0, (1.0, DO), (2.0, Proceed()))
    assert texts(run) == ["mended", "end"]


def test_do_leaves_what_the_hand_is_to_do_with_the_next_motion() -> None:
    run = driven(main("OPEN\nPAUSE\nMOVE a"), 9.0, (1.0, DO), (2.0, Proceed()))
    (opens,) = of_kind(run, HandCommanded)
    assert opens.time_s == started(run)[0]


def test_do_leaves_a_reaction_where_it_is() -> None:
    run = driven(
        main("REACT 2001, q\nSIGNAL 2001\nWAIT\nTYPE 2", ".PROGRAM q\nPAUSE\nTYPE 1\n.END\n"),
        9.0,
        (1.0, DO),
        (2.0, Proceed()),
    )
    assert texts(run) == ["1", "2"]
