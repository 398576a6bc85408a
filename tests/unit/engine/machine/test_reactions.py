"""REACT: signals that call a program between two steps, with priorities [C93, C94]."""

import pytest

from tests.support_engine import TICK, lines, of_kind, reacted, runs, words
from tests.support_programs import codes, ended, started
from vrts.engine.memory.events import Reacted
from vrts.engine.run import Run
from vrts.scene.model import Scenario

SUB = '.PROGRAM sub\nTYPE "reacted"\n.END\n'
ON = Scenario(inputs=((1.0, 1003, True),))
BLINK = Scenario(inputs=((1.0, 1003, True), (2.0, 1003, False), (3.0, 1003, True)))


def texts(run: Run) -> list[str]:
    return [text for _, text in lines(run)]


def test_a_reaction_is_taken_at_the_next_tick_between_two_steps() -> None:
    run = runs('REACT 1003, sub\nWAIT TIMER(0) > 2\nTYPE "after"', SUB, ON)
    assert texts(run) == ["reacted", "after"]
    assert lines(run)[0][0] == pytest.approx(1.0, abs=TICK)
    assert lines(run)[1][0] == pytest.approx(2.0, abs=2 * TICK)
    (reaction,) = reacted(run)
    assert reaction.signal == 1003
    assert reaction.program == "sub"
    assert reaction.cause is not None


def test_the_motion_is_not_disturbed() -> None:
    plain = runs("MOVE a\nMOVE b")
    run = runs("REACT 1003, sub\nMOVE a\nMOVE b", SUB, Scenario(inputs=((0.3, 1003, True),)))
    assert texts(run) == ["reacted"]
    assert ended(run) == pytest.approx(ended(plain))
    assert [m.goal for m in run.motions] == [m.goal for m in plain.motions]


def test_a_signal_that_is_on_already_does_not_trigger_until_it_comes_again() -> None:
    body = 'WAIT SIG(1003)\nREACT 1003, sub\nWAIT TIMER(0) > {t}\nTYPE "end"'
    assert texts(runs(body.format(t=2.5), SUB, BLINK)) == ["end"]
    run = runs(body.format(t=4), SUB, BLINK)
    assert texts(run) == ["reacted", "end"]
    assert lines(run)[0][0] == pytest.approx(3.0, abs=TICK)


def test_a_negative_number_waits_for_the_signal_to_go_off() -> None:
    run = runs("REACT -1003, sub\nWAIT TIMER(0) > 4", SUB, BLINK)
    assert lines(run)[0][0] == pytest.approx(2.0, abs=TICK)
    assert len(reacted(run)) == 1


def test_a_watch_is_used_up_unless_it_is_set_again() -> None:
    again = '.PROGRAM sub\nTYPE "reacted"\nREACT 1003, sub\n.END\n'
    wait = "REACT 1003, sub\nWAIT TIMER(0) > 4"
    assert len(reacted(runs(wait, SUB, BLINK))) == 1
    assert len(reacted(runs(wait, again, BLINK))) == 2


def test_always_keeps_the_watch() -> None:
    run = runs("REACT 1003, sub ALWAYS\nWAIT TIMER(0) > 4", SUB, BLINK)
    assert len(reacted(run)) == 2


def test_ignore_cancels_a_watch_and_a_later_one_replaces_it() -> None:
    more = SUB + '.PROGRAM other\nTYPE "other"\n.END\n'
    assert texts(runs("REACT 1003, sub\nIGNORE 1003\nWAIT TIMER(0) > 2", more, ON)) == []
    assert texts(runs("REACT 1003, sub\nIGNORE -1003\nWAIT TIMER(0) > 2", more, ON)) == []
    run = runs("REACT 1003, sub\nREACT -1003, other\nWAIT TIMER(0) > 2.5", more, BLINK)
    assert texts(run) == ["other"]


def test_internal_signals_can_be_watched_too() -> None:
    run = runs('REACT 2001, sub\nSIGNAL 2001\nWAIT\nTYPE "after"', SUB)
    assert texts(run) == ["reacted", "after"]


@pytest.mark.parametrize("number", [1, 0, 600, 1500])
def test_other_signals_cannot(number: int) -> None:
    assert words(runs(f"n = {number}\nREACT n, sub", SUB)) == ["Illegal digital signal"]


def test_eight_signals_can_be_watched() -> None:
    watches = "\n".join(f"REACT {1001 + k}, sub" for k in range(8))
    assert codes(runs(watches, SUB)) == []
    assert words(runs(watches + "\nREACT 1020, sub", SUB)) == ["Illegal value"]
    assert codes(runs(watches + "\nIGNORE 1001\nREACT 1020, sub", SUB)) == []


@pytest.mark.parametrize("level", [0, 128, -3])
def test_priorities_are_1_to_127(level: int) -> None:
    assert words(runs(f"n = {level}\nREACT 1003, sub, n", SUB)) == ["Illegal value"]


def test_a_program_that_is_not_there_is_an_error_at_react() -> None:
    assert words(runs("REACT 1003, nosuch")) == ["Undefined program or variable name"]


def test_a_locked_reaction_waits_for_its_turn() -> None:
    run = runs(
        'LOCK 10\nREACT 1003, sub, 5\nWAIT TIMER(0) > 2\nTYPE "locked"\nLOCK 0\nTYPE "free"',
        SUB,
        ON,
    )
    assert texts(run) == ["locked", "reacted", "free"]
    assert lines(run)[1][0] == lines(run)[0][0]


@pytest.mark.parametrize(
    ("lock", "level", "taken"), [(5, 5, False), (4, 5, True), (127, 127, False)]
)
def test_a_reaction_has_to_be_stronger_than_the_program(lock: int, level: int, taken: bool) -> None:
    run = runs(f"LOCK {lock}\nREACT 1003, sub, {level}\nWAIT TIMER(0) > 2", SUB, ON)
    assert (len(reacted(run)) == 1) is taken


def test_the_reaction_program_has_the_priority_of_the_reaction() -> None:
    sub = ".PROGRAM sub\nTYPE PRIORITY\nLOCK 20\n.END\n"
    body = "TYPE PRIORITY\nREACT 1003, sub, 7\nWAIT TIMER(0) > 2\nTYPE PRIORITY"
    run = runs(body, sub, ON, "vplus")
    assert texts(run) == ["0", "7", "0"]


def test_a_stronger_reaction_interrupts_a_weaker_one_and_not_the_other_way() -> None:
    more = (
        '.PROGRAM low\nTYPE "low"\nWAIT TIMER(0) > 3\nTYPE "low ends"\n.END\n'
        '.PROGRAM high\nTYPE "high"\nWAIT TIMER(0) > 2.5\nTYPE "high ends"\n.END\n'
    )
    wait = "REACT 1001, low, 3\nREACT 1002, high, 9\nWAIT TIMER(0) > 5"
    first_low = Scenario(inputs=((1.0, 1001, True), (2.0, 1002, True)))
    first_high = Scenario(inputs=((1.0, 1002, True), (2.0, 1001, True)))
    assert texts(runs(wait, more, first_low)) == ["low", "high", "high ends", "low ends"]
    assert texts(runs(wait, more, first_high)) == ["high", "high ends", "low", "low ends"]


def test_of_two_at_once_the_stronger_comes_first() -> None:
    more = '.PROGRAM low\nTYPE "low"\n.END\n.PROGRAM high\nTYPE "high"\n.END\n'
    both = Scenario(inputs=((1.0, 1001, True), (1.0, 1002, True)))
    run = runs("REACT 1001, low, 3\nREACT 1002, high, 9\nWAIT TIMER(0) > 2", more, both)
    assert texts(run) == ["high", "low"]


WAITING = [
    ("WAIT TIMER(0) > 2", 2.0),
    ("DELAY 2\nBREAK", 2.0),
    ("MOVE a\nBREAK\nDELAY 1\nMOVE b\nBREAK", None),
    ("PARAMETER HAND.TIME = 2\nOPENI", 2.0),
    ("PROMPT x", None),
]


@pytest.mark.parametrize(("steps", "lasts"), WAITING)
def test_steps_that_wait_are_interrupted_and_go_on_waiting(steps: str, lasts: float | None) -> None:
    plain = runs(steps, scenario=Scenario(answers=("5",)))
    run = runs(
        f'REACT 1003, sub\n{steps}\nTYPE "end"',
        SUB,
        Scenario(inputs=((0.5, 1003, True),), answers=("5",)),
    )
    assert len(reacted(run)) == 1 or "PROMPT" in steps
    assert texts(run)[-1] == "end"
    if lasts is not None:
        assert lines(run)[-1][0] == pytest.approx(lasts, abs=3 * TICK)
    assert started(run) == pytest.approx(started(plain))


def test_a_watch_ends_with_the_cycle_and_a_pulse_within_a_tick_is_not_seen() -> None:
    pulse = Scenario(inputs=((1.001, 1003, True), (1.005, 1003, False)))
    assert of_kind(runs("REACT 1003, sub\nWAIT TIMER(0) > 2", SUB, pulse), Reacted) == []


def test_return_goes_on_behind_the_step_that_was_running() -> None:
    body = "n = 0\nREACT 1003, sub\nDO\nn = n+1\nWAIT\nUNTIL n >= 60\nTYPE n"
    assert texts(runs(body, SUB, ON)) == ["reacted", "60"]


def test_stop_in_a_reaction_ends_the_cycle() -> None:
    run = runs('REACT 1003, sub\nWAIT TIMER(0) > 2\nTYPE "no"', ".PROGRAM sub\nSTOP\n.END\n", ON)
    assert texts(run) == []
    assert run.ending.value == "completed"
