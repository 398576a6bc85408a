"""Half a turn can be made either way round: what is taken never hangs on the last digit."""

import math
import random

import pytest

from tests.support_engine import runs
from tests.support_programs import ALONE, codes
from vrts.base.pose import (
    IDENTITY,
    X_AXIS,
    Y_AXIS,
    Z_AXIS,
    Pose,
    Rotation,
    Vector,
    multiply,
    rotation_about,
    rotation_angle,
    translation,
)
from vrts.controllers.model import AlignTurn, LineTurn
from vrts.controllers.models import USUAL
from vrts.engine.code.steps.targets import aligned
from vrts.engine.motion.lines.path import line
from vrts.engine.motion.requests import Stance, to_pose
from vrts.engine.motion.settings import Settings
from vrts.robots.kinematics.branch import INITIAL_BRANCH, branch_of
from vrts.robots.kinematics.choice import NOTHING_REQUESTED, Choice, choose
from vrts.robots.kinematics.kinematics import forward
from vrts.robots.model import Configuration

ARM = ALONE.robot.arm
NOISE = 3e-7  # [rad] what single precision leaves


def nudged(numbers: random.Random, rotation: Rotation) -> Rotation:
    axis: Vector = numbers.choice((X_AXIS, Y_AXIS, Z_AXIS))
    return multiply(rotation, rotation_about(axis, numbers.uniform(-NOISE, NOISE)))


@pytest.mark.parametrize("turn", LineTurn)
@pytest.mark.parametrize("about", [X_AXIS, Y_AXIS, Z_AXIS, (0.6, -0.8, 0.0), (0.8, 0.0, -0.6)])
def test_a_line_that_turns_right_round_turns_the_same_way(about: Vector, turn: LineTurn) -> None:
    numbers = random.Random(str(about))
    half = rotation_about(about, math.pi)
    middles: list[Rotation] = []
    for _ in range(30):
        start, goal = (nudged(numbers, r) for r in (IDENTITY.rotation, half))
        X_BT0, X_BT1 = Pose(start, (0.0, 0.0, 0.0)), Pose(goal, (0.1, 0.0, 0.0))
        path = line(X_BT0, X_BT1, turn)
        assert path.pose(1.0).rotation == pytest.approx(goal, abs=1e-12)
        assert path.turned < math.pi + 1e-5
        middles.append(path.pose(0.5).rotation)
    assert max(rotation_angle(middles[0], middle) for middle in middles) < 1e-5


def test_single_keeps_a_joint_that_is_at_half_a_turn() -> None:
    """At 180 and asked for -179.99998, which is 180.00002, the joint came round by 360 degrees."""
    for now, wanted in ((math.pi, -math.pi + NOISE), (-math.pi, math.pi - NOISE)):
        q0: Configuration = (0.1, -1.0, 2.0, 0.2, 0.5, now)
        q1: Configuration = (0.2, -1.0, 2.0, 0.2, 0.5, wanted)
        X_FT = translation(0.0, 0.0, 0.1)
        stance = Stance(ARM, q0, branch_of(ARM, q0), NOTHING_REQUESTED, IDENTITY, X_FT, USUAL)
        single = Settings(multiple=False)
        intent = to_pose(stance, forward(ARM, q1) @ X_FT, single, 1.0, None)
        assert intent.goal is not None
        assert abs(intent.goal[5] - now) < 1e-5


def test_of_two_wrists_as_far_the_present_one_is_taken() -> None:
    """Joint 4 by 90 degrees one way or the other."""
    near: Configuration = (0.1, -1.0, 2.0, 0.0, 0.0, 0.0)
    numbers = random.Random(4)
    for _ in range(40):
        q = (0.1, -1.0, 2.0, 0.5 * math.pi + numbers.uniform(-NOISE, NOISE), 0.4, -0.5 * math.pi)
        found = choose(ARM, forward(ARM, q), INITIAL_BRANCH, near)
        assert isinstance(found, Choice)
        assert found.branch == INITIAL_BRANCH
        assert found.configuration == pytest.approx(q, abs=1e-6)


def test_half_a_turn_of_joint_6_goes_one_way() -> None:
    near: Configuration = (0.1, -1.0, 2.0, 0.3, 0.4, 0.5)
    numbers = random.Random(4)
    ends: list[float] = []
    for _ in range(40):
        q = (*near[:5], near[5] + math.pi + numbers.uniform(-NOISE, NOISE))
        found = choose(ARM, forward(ARM, q), INITIAL_BRANCH, near)  # type: ignore[arg-type]
        assert isinstance(found, Choice)
        ends.append(found.configuration[5])
    assert max(ends) - min(ends) < 1e-5


@pytest.mark.parametrize("way", AlignTurn)
def test_align_between_two_axes_takes_the_same_one(way: AlignTurn) -> None:
    numbers = random.Random(1)
    found: list[Rotation] = []
    for _ in range(30):
        between = multiply(rotation_about(Y_AXIS, 0.25 * math.pi), IDENTITY.rotation)
        found.append(aligned(Pose(nudged(numbers, between), (0.0, 0.0, 0.0)), way).rotation)
    assert max(rotation_angle(found[0], other) for other in found) < 1e-5


def test_a_program_that_turns_right_round_says_so_and_turns_one_way() -> None:
    body = "MOVE TRANS(900,0,100,90,90,{})\nBREAK\nMOVES TRANS(900,50,100,-90,90,0)"
    ways: list[float] = []
    for turn in (0.0, 1e-5, -1e-5):
        run = runs(body.format(turn))
        assert "V333" in codes(run)
        ways.append(run.at(run.motions[1].start_s + 0.8).X_WT.approach[1])
    assert max(ways) - min(ways) < 1e-3
