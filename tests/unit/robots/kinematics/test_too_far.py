"""What is certainly too far for a serial arm: never what it reaches, and told at once."""

import math
import random
from itertools import pairwise

import pytest

from vrts.base.pose import Pose, add, distance, scale
from vrts.base.units import MM
from vrts.pipeline.scenes import load_scene
from vrts.robots.catalog import arm as any_arm
from vrts.robots.kinematics import serial_solutions, too_far
from vrts.robots.kinematics.approach import Approach
from vrts.robots.kinematics.chain import forward
from vrts.robots.kinematics.serial_solutions import reach_error, solutions, starts
from vrts.robots.model import Configuration, SerialArm

NAMES = ("ur3", "ur5", "ur10", "one-can-urdf")


def arm_of(name: str) -> SerialArm:
    arm = load_scene(name).scene.robot.arm if "urdf" in name else any_arm(name)
    assert isinstance(arm, SerialArm)
    return arm


def drawn(numbers: random.Random) -> Configuration:
    return tuple(numbers.uniform(-math.pi, math.pi) for _ in range(6))  # type: ignore[return-value]


@pytest.mark.parametrize("name", NAMES)
def test_nothing_that_is_reached_is_too_far(name: str) -> None:
    """And stretched out, the arm comes near to what is: the bound says something."""
    arm, numbers = arm_of(name), random.Random(7)
    amounts = [too_far.beyond(arm, forward(arm, drawn(numbers))) for _ in range(3000)]
    assert max(amounts) <= 0.0
    assert max(amounts) > -0.2


@pytest.mark.parametrize("name", NAMES)
def test_what_is_too_far_is_told_after_a_few_steps(
    name: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    arm, numbers = arm_of(name), random.Random(3)
    asked = 0
    real = serial_solutions.approach

    def counted(*given: object, **named: object) -> Approach:
        nonlocal asked
        asked += 1
        return real(*given, **named)  # type: ignore[arg-type]

    monkeypatch.setattr(serial_solutions, "approach", counted)
    for _ in range(5):
        X_BF = forward(arm, drawn(numbers))
        far = Pose(X_BF.rotation, add(X_BF.translation, scale((0.6, 0.8, 0.0), 5.0)))
        assert solutions(arm, far, arm.ready) == ()
        assert asked == 0
        error = reach_error(arm, far)
        assert asked == len(starts(arm)) + 1
        asked = 0
        assert error is not None
        kind, amount = error
        assert kind == "too far"
        assert too_far.beyond(arm, far) <= amount <= 5.0 + 2e-3


def test_a_place_that_is_asked_for_again_is_not_looked_for_again(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    arm = arm_of("ur5")
    close = Pose(forward(arm, arm.ready).rotation, (0.0, 0.001, -0.15))
    found = solutions(arm, close, arm.ready), reach_error(arm, close)
    assert found[0] == ()
    assert found[1] is not None
    assert found[1][0] == "too close"
    monkeypatch.setattr(serial_solutions, "approach", None)
    assert (solutions(arm, close, arm.ready), reach_error(arm, close)) == found


def test_how_far_is_too_far_goes_on_where_the_bound_begins() -> None:
    """Along a ray the amount grows by what the place moves."""
    arm = arm_of("ur5")
    ready = forward(arm, arm.ready)
    ray = scale(ready.translation, 1.0 / math.hypot(*ready.translation))
    at = [Pose(ready.rotation, scale(ray, out_m)) for out_m in (1.2, 1.6, 2.0, 5.0)]
    amounts = [error[1] for X_BF in at if (error := reach_error(arm, X_BF)) is not None]
    moved = [distance(a.translation, b.translation) for a, b in pairwise(at)]
    grown = [b - a for a, b in pairwise(amounts)]
    assert grown == pytest.approx(moved, abs=5 * MM)


def test_a_place_far_away_is_brought_no_nearer_than_links_are_long() -> None:
    arm, far = arm_of("ur5"), Pose(forward(arm_of("ur5"), arm_of("ur5").ready).rotation, (3, 4, 1))
    near = too_far.as_far_as_links(arm, far)
    assert near.rotation == far.rotation
    assert too_far.beyond(arm, near) == pytest.approx(-too_far.REACHED, abs=1e-9)
