"""Straight lines that cannot be followed to their end: the arm stops on the way, and says why."""

import math

import pytest

from tests.support_engine import lines, runs, words
from tests.support_programs import codes, ended
from vrts.engine.run import Run
from vrts.scene.model import Scenario

FAR = 'MOVE a\nBREAK\n{}SPEED 20\nMOVES TRANS(0,-900,100,90,90,0)\nTYPE "next"'
SUB = '.PROGRAM sub\nTYPE "reacted"\nRETURNE\n.END\n.PROGRAM note\nTYPE "noted"\n.END\n'
EARLY = Scenario(inputs=((2.0, 1003, True),))


def texts(run: Run) -> list[str]:
    return [text for _, text in lines(run)]


def test_the_arm_stops_on_the_line_before_a_joint_leaves_its_range() -> None:
    run = runs(FAR.format(""), SUB)
    assert words(run) == ["Joint 3 out of range"]
    line = run.motions[1]
    assert not line.cut
    x, y, z = run.at(line.end_s).X_WT.translation
    assert (x / 0.9, z) == pytest.approx(((y + 0.9) / 1.1, 0.1), abs=1e-6)
    assert math.hypot(0.9 - x, 0.2 - y) == pytest.approx(0.569, abs=0.01)
    assert run.at(line.end_s).velocity == pytest.approx((0.0,) * 6, abs=1e-9)
    assert run.ended_s is not None
    assert run.ended_s >= line.end_s


def test_the_error_comes_when_the_arm_has_stopped_and_can_be_caught() -> None:
    run = runs("REACTE sub\n" + FAR.format(""), SUB)
    assert texts(run) == ["reacted", "next"]
    assert lines(run)[0][0] >= ended(run)[1]


def test_a_reaction_on_the_way_changes_nothing() -> None:
    run = runs(FAR.format("REACT 1003, note\n"), SUB, EARLY)
    assert texts(run) == ["noted"]
    assert words(run) == ["Joint 3 out of range"]


def test_a_line_that_is_given_up_before_does_not_fail() -> None:
    run = runs(FAR.format("REACTI 1003, note\n"), SUB, EARLY)
    assert codes(run) == []
    assert texts(run) == ["noted", "next"]
    assert run.motions[1].cut


def test_another_program_may_brake_before() -> None:
    guard = ".PROGRAM guard\nWAIT TIMER(0) > 2\nBRAKE\n.END\n"
    run = runs("PCEXECUTE guard\n" + FAR.format(""), guard)
    assert codes(run) == []
    assert texts(run) == ["next"]
