"""Which solution a joint-interpolated motion takes."""

import math
from typing import cast

import pytest

from vrts.base.pose import distance, translation
from vrts.base.units import DEG
from vrts.robots.catalog import puma as arm_named
from vrts.robots.kinematics.branch import INITIAL_BRANCH, branch_of
from vrts.robots.kinematics.choice import Choice, OutOfLimits, OutOfReach, Request, choose
from vrts.robots.kinematics.kinematics import forward, limit_violations
from vrts.robots.model import Configuration, Elbow, Shoulder, Wrist

ARM = arm_named("puma761")


def degrees(*angles: float) -> Configuration:
    return cast(Configuration, tuple(angle * DEG for angle in angles))


HERE = degrees(20, -30, 120, 10, 40, 20)
THERE = degrees(40, -40, 130, 15, 50, 10)
REQUESTS = [
    Request(Shoulder.LEFTY, Elbow.ABOVE, Wrist.NOFLIP),
    Request(Shoulder.LEFTY, Elbow.ABOVE, Wrist.FLIP),
    Request(wrist=Wrist.FLIP),
]


def test_the_present_branch_is_kept() -> None:
    found = choose(ARM, forward(ARM, THERE), branch_of(ARM, HERE), HERE)
    assert isinstance(found, Choice)
    assert found.branch == INITIAL_BRANCH
    assert found.configuration == pytest.approx(THERE, abs=1e-9)


@pytest.mark.parametrize("request_", REQUESTS)
def test_a_requested_branch_is_taken(request_: Request) -> None:
    X_BF = forward(ARM, THERE)
    found = choose(ARM, X_BF, branch_of(ARM, HERE), HERE, request_)
    assert isinstance(found, Choice)
    for wanted, taken in zip(request_, found.branch, strict=True):
        assert wanted is None or wanted is taken
    assert branch_of(ARM, found.configuration) == found.branch
    again = forward(ARM, found.configuration)
    assert distance(again.translation, X_BF.translation) < 1e-9
    assert limit_violations(ARM, found.configuration) == ()


def test_noflip_binds_only_when_requested() -> None:
    """From a wrist that is flipped the nearer solution is taken, whatever `present` says."""
    flipped = degrees(40, -40, 130, 5, -50, 10)
    X_BF = forward(ARM, degrees(40, -40, 130, 10, -50, 10))
    free = choose(ARM, X_BF, INITIAL_BRANCH, flipped)
    assert isinstance(free, Choice)
    assert free.branch.wrist is Wrist.FLIP
    bound = choose(ARM, X_BF, INITIAL_BRANCH, flipped, Request(wrist=Wrist.NOFLIP))
    assert isinstance(bound, Choice)
    assert bound.branch.wrist is Wrist.NOFLIP


def test_the_smaller_change_of_the_wrist_wins() -> None:
    found = choose(ARM, forward(ARM, THERE), branch_of(ARM, HERE), HERE)
    other = choose(ARM, forward(ARM, THERE), branch_of(ARM, HERE), HERE, Request(wrist=Wrist.FLIP))
    assert isinstance(found, Choice)
    assert isinstance(other, Choice)

    def change(q: Configuration) -> float:
        return max(abs(q[k] - HERE[k]) for k in (3, 4, 5))

    assert change(found.configuration) < change(other.configuration)


def test_outside_the_limits_it_tells_where_the_pose_is_within_them() -> None:
    behind = degrees(165, -60, 150, 0, 40, 0)  # joint 1 ends at 160
    X_BF = forward(ARM, behind)
    found = choose(ARM, X_BF, INITIAL_BRANCH, ARM.ready)
    assert isinstance(found, OutOfLimits)
    assert [joint for joint, *_ in found.violations] == [1]
    assert found.branch not in found.elsewhere
    assert Shoulder.RIGHTY in {branch.shoulder for branch in found.elsewhere}
    asked = Request(*found.elsewhere[0])
    assert isinstance(choose(ARM, X_BF, INITIAL_BRANCH, ARM.ready, asked), Choice)


def test_out_of_reach_is_told_apart_from_limits() -> None:
    found = choose(ARM, translation(3.0, 0.0, 0.0), INITIAL_BRANCH, HERE)
    assert isinstance(found, OutOfReach)
    assert found.kind == "too far"
    reach = ARM.a2 + math.hypot(ARM.a3, ARM.d4)
    wrist = math.dist((3.0, 0.0, -ARM.d6), (0.0, 0.0, 0.0))
    assert 0.0 < wrist - reach < found.excess_m + ARM.d2
