"""RIGHTY and its like: which motion carries the request out, and what ends it [3.1]."""

import math

import pytest

from tests.support_engine import runs, words
from tests.support_programs import codes
from vrts.engine.run import Run
from vrts.robots.kinematics.branch import branch_of
from vrts.robots.model import Shoulder, Wrist

REQUEST = "MOVE a\nRIGHTY\nFLIP\n{}MOVE a\nBREAK"


def ends_righty(run: Run) -> bool:
    branch = branch_of(run.scene.robot.arm, run.motions[-1].goal)
    return branch.shoulder is Shoulder.RIGHTY


@pytest.mark.parametrize(
    "between", ["", "DELAY 0.2\n", "SPEED 50\n", "DRIVE 6, 5\n", "BREAK\n", "OPENI\n"]
)
def test_the_next_move_to_a_pose_carries_the_request_out(between: str) -> None:
    run = runs(REQUEST.format(between))
    assert codes(run) == []
    assert ends_righty(run)


@pytest.mark.parametrize("between", ["MOVE #PPOINT(0,-45,135,0,60,0)\n", "READY\n"])
def test_a_move_to_a_precision_point_overrides_it(between: str) -> None:
    run = runs(REQUEST.format(between))
    assert codes(run) == []
    assert not ends_righty(run)


def test_the_arm_stays_on_the_branch() -> None:
    run = runs("MOVE a\nRIGHTY\nMOVE a\nMOVES SHIFT(a BY 20)\nMOVE SHIFT(a BY -20)")
    assert codes(run) == []
    for motion in run.motions[1:]:
        assert branch_of(run.scene.robot.arm, motion.goal).shoulder is Shoulder.RIGHTY


def test_the_request_survives_an_error_and_the_end_of_a_cycle() -> None:
    run = runs("MOVE a\nCALL ask\nMOVE a\nBREAK", ".PROGRAM ask\nRIGHTY\n.END\n")
    assert ends_righty(run)


@pytest.mark.parametrize("word", ["RIGHTY", "FLIP", "BELOW"])
def test_a_straight_line_cannot_carry_it_out(word: str) -> None:
    assert words(runs(f"MOVE a\n{word}\nMOVES b")) == [
        "Straight-line motion can't alter configuration"
    ]


def test_a_request_for_what_is_there_already_harms_no_line() -> None:
    assert codes(runs("MOVE a\nLEFTY\nABOVE\nNOFLIP\nMOVES b")) == []


def test_flip_means_a_negative_joint_5() -> None:
    run = runs("MOVE a\nFLIP\nMOVE a\nNOFLIP\nMOVE a")
    angles = [math.degrees(motion.goal[4]) for motion in run.motions]
    assert angles[0] > 0.0
    assert angles[1] == pytest.approx(-angles[0])
    assert angles[2] == pytest.approx(angles[0])
    assert branch_of(run.scene.robot.arm, run.motions[1].goal).wrist is Wrist.FLIP
