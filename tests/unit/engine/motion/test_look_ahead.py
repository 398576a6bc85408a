"""What a program does while the arm still moves, and what waits until it rests [C82 to C85]."""

import pytest

from tests.support_engine import SETTLING, TICK, lines, of_kind, runs
from tests.support_programs import ended, started, switched
from vrts.engine.memory.events import HandCommanded, SignalChanged
from vrts.engine.run import Run


def hand(run: Run) -> list[float]:
    return [event.time_s for event in of_kind(run, HandCommanded)]


def test_the_first_motion_begins_at_the_next_tick_and_the_program_goes_on_in_this_one() -> None:
    run = runs("MOVE a\nSIGNAL 1\nMOVE b\nSIGNAL 2")
    assert started(run)[0] == pytest.approx(TICK)
    assert switched(run)[1] == 0.0


def test_what_follows_a_second_motion_waits_until_that_one_begins() -> None:
    run = runs("MOVE a\nSIGNAL 1\nMOVE b\nSIGNAL 2")
    begin, on = started(run), switched(run)
    assert run.motions[0].blended
    assert begin[1] - 1e-9 <= on[2] < begin[1] + TICK
    assert begin[1] == pytest.approx(ended(run)[0])


def test_there_is_a_look_ahead_of_one_motion_only() -> None:
    run = runs("MOVE a\nMOVE b\nMOVE c\nSIGNAL 3\nMOVE d\nSIGNAL 4")
    begin, on = started(run), switched(run)
    for k, signal in ((2, 3), (3, 4)):
        assert begin[k] - 1e-9 <= on[signal] < begin[k] + TICK


def test_without_corner_the_second_motion_begins_when_the_first_has_ended() -> None:
    run = runs("DISABLE CP\nMOVE a\nMOVE b\nSIGNAL 2")
    assert ended(run)[0] <= switched(run)[2] + 1e-9
    assert started(run)[1] - ended(run)[0] == pytest.approx(SETTLING)
    assert switched(run)[2] == pytest.approx(started(run)[1], abs=TICK)


def test_after_break_the_arm_is_at_rest() -> None:
    run = runs("MOVE a\nBREAK\nSIGNAL 1")
    assert switched(run)[1] == pytest.approx(ended(run)[0] + SETTLING)
    state = run.at(switched(run)[1])
    assert state.velocity == (0.0,) * 6
    assert state.configuration == pytest.approx(run.motions[0].goal, abs=1e-9)


def test_break_at_rest_takes_no_time() -> None:
    run = runs("BREAK\nSIGNAL 1\nBREAK\nSIGNAL 2")
    assert switched(run) == {1: 0.0, 2: 0.0}


WAITS = ["TOOL NULL", "BASE 0", "LEFTY", "ABOVE", "NOFLIP"]
GOES_ON = [
    "SPEED 10",
    "COARSE",
    "NONULL",
    "INTON",
    "SINGLE",
    "OPEN",
    "SET p = NULL",
    "BITS 1,4 = 3",
]


@pytest.mark.parametrize("step", WAITS)
def test_steps_that_wait_until_the_arm_rests(step: str) -> None:
    run = runs(f"MOVE a\n{step}\nSIGNAL 9")
    assert switched(run)[9] == pytest.approx(ended(run)[0] + SETTLING)


@pytest.mark.parametrize("step", GOES_ON)
def test_steps_that_are_carried_out_at_once(step: str) -> None:
    run = runs(f"MOVE a\n{step}\nSIGNAL 9")
    assert switched(run)[9] == 0.0


@pytest.mark.parametrize("word", ["HALT", "PAUSE"])
def test_halt_and_pause_wait_for_the_arm_with_their_words(word: str) -> None:
    run = runs(f'MOVE a\nTYPE "on the way"\n{word} "there"')
    (first, _), (last, text) = lines(run)
    assert first == 0.0
    assert text == "there"
    assert last == pytest.approx(ended(run)[0] + SETTLING)


def test_stop_does_not_wait_but_the_program_ends_when_the_arm_rests() -> None:
    run = runs('MOVE a\nSTOP "early"')
    assert lines(run) == [(0.0, "early")]
    assert run.ended_s == pytest.approx(ended(run)[0] + SETTLING)


def test_a_delay_waits_its_turn_and_stands_still() -> None:
    run = runs("MOVE a\nSIGNAL 1\nDELAY 1\nSIGNAL 2\nMOVE b\nSIGNAL 3")
    on = switched(run)
    assert on[1] == 0.0
    assert on[2] == pytest.approx(ended(run)[0] + SETTLING)
    assert started(run)[1] == pytest.approx(on[2] + 36 * TICK)  # 1 s in whole ticks
    assert on[3] == pytest.approx(started(run)[1], abs=TICK)
    for t in (0.01, 0.5, 0.99):
        assert run.at(ended(run)[0] + t).velocity == (0.0,) * 6


def test_close_acts_when_the_next_motion_starts() -> None:
    run = runs("OPENI\nMOVE a\nCLOSE\nMOVE b\nMOVE c")
    assert hand(run)[1:] == [started(run)[1]]


def test_open_before_a_first_motion_acts_when_that_one_starts() -> None:
    run = runs("OPEN\nTIMER 1 = 0\nWAIT TIMER(1) > 1\nMOVE a")
    assert hand(run) == [started(run)[0]]
    assert run.at(started(run)[0] - 0.01).hand_opening == 0.0
    assert run.at(started(run)[0] + 0.2).hand_opening > 0.0


def test_open_before_a_delay_acts_when_that_begins() -> None:
    run = runs("MOVE a\nOPEN\nDELAY 1\nMOVE b")
    assert hand(run) == [pytest.approx(ended(run)[0] + SETTLING)]


def test_closei_acts_at_rest_and_takes_the_hands_time() -> None:
    run = runs("OPENI\nMOVE a\nCLOSEI\nSIGNAL 1\nMOVE b")
    closes = hand(run)[1]
    assert closes == pytest.approx(ended(run)[0] + SETTLING)
    wait = run.scene.robot.gripper.stroke_time
    assert closes + wait <= switched(run)[1] < closes + wait + TICK


def test_hand_time_is_a_parameter() -> None:
    run = runs("PARAMETER HAND.TIME = 0.9\nOPENI\nSIGNAL 1")
    assert 0.9 <= switched(run)[1] < 0.9 + TICK


def test_here_in_mid_motion_is_on_the_way_and_dest_is_its_end() -> None:
    run = runs(
        "MOVE a\nBREAK\nMOVES b\nTIMER 1 = 0\nWAIT TIMER(1) > 0.3\nHERE spot\nSET goal = DEST\n"
        "SET #joints = #HERE\nSET #end = #DEST\nTYPE DY(spot)\nTYPE DY(goal)"
    )
    spot, goal = (float(line) for _, line in lines(run))
    assert goal == pytest.approx(-200.0, abs=1e-3)
    assert -199.0 < spot < 199.0
    when = lines(run)[0][0]
    state = run.at(when)
    assert state.variables["#joints"] == pytest.approx(state.configuration, abs=1e-9)
    assert state.variables["#end"] == pytest.approx(run.motions[1].goal, abs=1e-9)


def test_a_hundred_steps_fit_into_a_tick() -> None:
    run = runs("\n".join(f"x{k} = {k}" for k in range(98)) + "\nSIGNAL 1\nSIGNAL 2\nSIGNAL 3")
    assert [e.time_s for e in of_kind(run, SignalChanged)] == pytest.approx([0.0, 0.0, TICK])


def test_wait_without_condition_gives_up_the_rest_of_the_tick() -> None:
    run = runs("SIGNAL 1\nWAIT\nSIGNAL 2\nWAIT\nSIGNAL 3")
    assert list(switched(run).values()) == pytest.approx([0.0, TICK, 2 * TICK])
