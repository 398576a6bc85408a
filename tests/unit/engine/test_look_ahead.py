"""What a program does while the arm still moves, and what waits until it rests."""

import pytest

from tests.support_programs import ended, happened, run_body, started, switched
from vrts.engine.events import HandCommanded
from vrts.engine.run import Run

TICK = 0.028
SETTLING = 3 * TICK


def hand(run: Run) -> list[float]:
    return [event.time_s for event in happened(run, HandCommanded)]


def test_outputs_follow_the_beginning_of_motions() -> None:
    run = run_body("MOVE a\nSIGNAL 1\nMOVE b\nSIGNAL 2")
    begin, end, on = started(run), ended(run), switched(run)
    assert begin[0] - TICK - 1e-9 <= on[1] <= begin[0] + TICK + 1e-9
    assert on[1] < end[0]
    assert begin[1] <= on[2] <= begin[1] + TICK + 1e-9
    assert on[2] >= end[0]


def test_after_break_the_arm_is_at_rest() -> None:
    run = run_body("MOVE a\nBREAK\nSIGNAL 1")
    assert switched(run)[1] >= ended(run)[0] + SETTLING - 1e-9
    assert run.at(switched(run)[1]).velocity == (0.0,) * 6


def test_close_acts_when_the_next_motion_starts() -> None:
    run = run_body("MOVE a\nCLOSE\nMOVE b")
    assert hand(run) == [started(run)[1]]


def test_closei_acts_at_rest_and_takes_the_hands_time() -> None:
    run = run_body("MOVE a\nCLOSEI\nMOVE b")
    (closes,) = hand(run)
    assert closes == pytest.approx(ended(run)[0] + SETTLING)
    wait = run.scene.robot.gripper.stroke_time
    assert started(run)[1] >= closes + wait
    assert started(run)[1] <= closes + wait + 2 * TICK


def test_the_program_ends_when_the_arm_rests() -> None:
    run = run_body('MOVE a\nTYPE "early"')
    assert run.ended_s is not None
    assert run.ended_s >= ended(run)[0] + SETTLING - 1e-9
    assert "early" in run.at(started(run)[0] + TICK).output


def test_here_in_mid_motion_is_on_the_way_and_dest_is_its_end() -> None:
    run = run_body("MOVE a\nMOVE b\nHERE spot\nSET goal = DEST\nTYPE DY(spot)\nTYPE DY(goal)")
    spot, goal = (float(line) for line in run.output.split())
    assert goal == pytest.approx(-200.0, abs=1e-3)
    assert -200.0 < spot <= 200.001
