"""A set point with nothing about it: the short way says what the long one does, to the last bit."""

import math
import random

import pytest

from vrts.base.pose import Vector
from vrts.robots.catalog import puma
from vrts.robots.kinematics.branch import branch_of
from vrts.robots.kinematics.kinematics import forward, joint_velocity, tip
from vrts.robots.kinematics.limits import unlimited
from vrts.robots.kinematics.singular import singular_at
from vrts.robots.kinematics.tracking import track, usual_step
from vrts.robots.model import ArmBranch, Configuration, SphericalWristArm

STEP = 0.028  # [s]


def drawn(arm: SphericalWristArm, draw: random.Random, spread: float) -> Configuration:
    """Return a configuration; with a small spread near READY, where all is singular."""
    a, b, c, d, e, f = [
        ready + spread * draw.uniform(lower - ready, upper - ready)
        for ready, lower, upper in zip(arm.ready, arm.lower, arm.upper, strict=True)
    ]
    return (a, b, c, d, e, f)


def moved(
    arm: SphericalWristArm, q: Configuration, draw: random.Random, most: float
) -> Configuration:
    """Return where the joints are a little later, at up to so much of their full speed."""
    a, b, c, d, e, f = [
        x + draw.uniform(-most, most) * speed * STEP for x, speed in zip(q, arm.speed, strict=True)
    ]
    return (a, b, c, d, e, f)


@pytest.mark.parametrize("name", ["puma560", "puma761", "puma762"])
@pytest.mark.parametrize(("spread", "most"), [(1.0, 0.9), (1.0, 3.0), (0.01, 0.9)])
def test_the_short_way_says_what_the_long_one_does(name: str, spread: float, most: float) -> None:
    arm, draw, short = puma(name), random.Random(11), 0
    step, free = usual_step(arm), unlimited(arm)
    for _ in range(300):
        near = drawn(arm, draw, spread)
        q = moved(arm, near, draw, most)
        X_BF, branch = forward(arm, q), branch_of(arm, near)
        v: Vector = (draw.uniform(-1, 1), draw.uniform(-1, 1), 0.0)
        w: Vector = (0.0, 0.0, 0.0) if draw.random() < 0.5 else (0.1, -0.2, draw.uniform(-1, 1))
        found = step(*X_BF, v, w, branch, near, STEP)
        if found is None:
            continue
        short += 1
        there = track(free, X_BF, branch, near)
        assert there is not None
        assert repr((found[0], branch)) == repr(there)
        assert repr(found[1]) == repr(joint_velocity(arm, found[0], v, w))
        assert singular_at(arm, found[0]) is None
        turns = zip(found[0], near, arm.speed, strict=True)
        assert all(abs(b - a) <= speed * STEP for b, a, speed in turns)
    assert (short > 40) is (spread == 1.0 and most < 1.0)


def test_whatever_is_special_is_left_to_the_long_way() -> None:
    arm = puma("puma761")
    step, still = usual_step(arm), (0.0, 0.0, 0.0)
    ordinary: Configuration = (0.3, -0.6, 2.5, 0.4, 0.8, 0.1)

    def told(q: Configuration, near: Configuration, branch: ArmBranch | None = None) -> bool:
        where = branch or branch_of(arm, near)
        return step(*forward(arm, q), still, still, where, near, STEP) is not None

    assert told(ordinary, ordinary)
    wrist = (*ordinary[:4], math.radians(0.9), ordinary[5])
    straight = (0.3, -0.6, math.atan2(arm.d4, arm.a3) + math.radians(0.5), 0.4, 0.8, 0.1)
    assert not told(wrist, wrist), "near the wrist's singularity"
    assert not told(straight, straight), "near the elbow's"
    assert not told(ordinary, (0.3, -0.6, 2.5, 0.4 - 1.1 * STEP * arm.speed[3], 0.8, 0.1)), "fast"
    far = (forward(arm, ordinary)[0], (9.0, 0.0, 0.0))
    assert step(*far, still, still, branch_of(arm, ordinary), ordinary, STEP) is None


@pytest.mark.parametrize("point", [(0.0, 0.0, 0.0), (0.0, 0.0, 0.15), (0.01, -0.02, 0.15)])
def test_the_tip_is_where_the_flange_has_it(point: Vector) -> None:
    arm, draw = puma("puma560"), random.Random(3)
    where = tip(arm, point)
    for _ in range(100):
        q = drawn(arm, draw, 1.0)
        assert where(q) == forward(arm, q).apply(point)
