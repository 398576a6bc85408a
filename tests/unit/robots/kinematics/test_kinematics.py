"""Closed-form kinematics against values worked out elsewhere, and against itself."""

import json
import math
import random
from itertools import pairwise
from typing import TypedDict, cast

import numpy as np
import pytest

from tests.places import TESTS
from vrts.base.oat import components, pose_from_components
from vrts.base.pose import IDENTITY, distance, rotation_angle, translation
from vrts.base.units import DEG, MM
from vrts.controllers.models import USUAL
from vrts.robots.catalog import puma as arm_named
from vrts.robots.kinematics.batch import flange_frames, link_frames
from vrts.robots.kinematics.branch import (
    ALL_BRANCHES,
    branch_of,
    elbow_reach,
    shoulder_reach,
)
from vrts.robots.kinematics.kinematics import (
    forward,
    limit_violations,
    link_poses,
    reach_error,
    solve,
)
from vrts.robots.model import Configuration, SphericalWristArm

RULES = USUAL.branches
DATA = TESTS / "data" / "puma_check_values.json"
ARMS = ("puma761", "puma762", "puma560")


class Row(TypedDict):
    joints_deg: list[float]
    xyz_mm: list[float]
    oat_deg: list[float]
    config: str


VALUES = cast("dict[str, list[Row]]", json.loads(DATA.read_text("utf-8")))
ROWS = [(name.lower(), row) for name, rows in VALUES.items() for row in rows]


def configuration(degrees: list[float]) -> Configuration:
    a, b, c, d, e, f = (angle * DEG for angle in degrees)
    return (a, b, c, d, e, f)


def some(arm: SphericalWristArm, count: int) -> list[Configuration]:
    """Return configurations within the limits, the same in every run."""
    numbers = random.Random(arm.name)
    limits = list(zip(arm.lower, arm.upper, strict=True))
    return [
        cast(Configuration, tuple(numbers.uniform(lo, hi) for lo, hi in limits))
        for _ in range(count)
    ]


@pytest.mark.parametrize(("name", "row"), ROWS)
def test_forward_reproduces_the_check_values(name: str, row: Row) -> None:
    X_BF = forward(arm_named(name), configuration(row["joints_deg"]))
    x, y, z = row["xyz_mm"]
    expected = pose_from_components(x, y, z, *row["oat_deg"])
    assert distance(X_BF.translation, expected.translation) < 1e-3 * MM
    assert rotation_angle(X_BF.rotation, expected.rotation) < 1e-3 * DEG


@pytest.mark.parametrize(("name", "row"), ROWS)
def test_branch_is_that_of_the_check_values(name: str, row: Row) -> None:
    arm = arm_named(name)
    q = configuration(row["joints_deg"])
    if abs(shoulder_reach(arm, q)) < 1e-9 or abs(elbow_reach(arm, q)) < 1e-9:
        return  # on the boundary itself the sign is noise
    words = " ".join(part.value.upper() for part in branch_of(arm, q))
    if abs(shoulder_reach(arm, q)) > RULES.shoulder_boundary_m and abs(elbow_reach(arm, q)) > 0.02:
        assert words == row["config"]


@pytest.mark.parametrize("name", ARMS)
def test_every_branch_leads_back_to_the_pose(name: str) -> None:
    arm = arm_named(name)
    for q in some(arm, 300):
        X_BF = forward(arm, q)
        for branch in ALL_BRANCHES:
            found = solve(arm, X_BF, branch, q)
            assert found is not None
            again = forward(arm, found)
            assert distance(again.translation, X_BF.translation) < 1e-9
            assert rotation_angle(again.rotation, X_BF.rotation) < 1e-7
            near_a_boundary = (
                abs(shoulder_reach(arm, found)) < 1e-6
                or abs(elbow_reach(arm, found)) < 1e-6
                or abs(math.sin(found[4])) < math.radians(RULES.wrist_boundary_deg)
            )
            if not near_a_boundary and abs(found[4]) < math.pi:
                assert branch_of(arm, found) == branch


@pytest.mark.parametrize("name", ARMS)
def test_the_branch_of_a_configuration_leads_back_to_it(name: str) -> None:
    arm = arm_named(name)
    compared = 0
    for q in some(arm, 300):
        if abs(math.sin(q[4])) < 0.01 or abs(elbow_reach(arm, q)) < RULES.elbow_boundary_m:
            continue
        if abs(shoulder_reach(arm, q)) < RULES.shoulder_boundary_m:
            continue
        found = solve(arm, forward(arm, q), branch_of(arm, q), q)
        assert found is not None
        assert found == pytest.approx(q, abs=1e-6)
        compared += 1
    assert compared > 200


@pytest.mark.parametrize("name", ARMS)
def test_batch_equals_scalar(name: str) -> None:
    arm = arm_named(name)
    rows = some(arm, 50)
    rotations, origins = flange_frames(arm, np.array(rows))
    link_rotations, link_origins = link_frames(arm, np.array(rows))
    for k, q in enumerate(rows):
        X_BF = forward(arm, q)
        assert rotations[k].ravel() == pytest.approx(X_BF.rotation, abs=1e-12)
        assert origins[k] == pytest.approx(X_BF.translation, abs=1e-12)
        for number, pose in enumerate(link_poses(arm, q)):
            assert link_rotations[number, k].ravel() == pytest.approx(pose.rotation, abs=1e-12)
            assert link_origins[number, k] == pytest.approx(pose.translation, abs=1e-12)


def test_the_last_link_frame_carries_the_flange() -> None:
    arm = arm_named("puma761")
    for q in some(arm, 20):
        X_BF = link_poses(arm, q)[-1] @ translation(0.0, 0.0, arm.d6)
        assert X_BF.translation == pytest.approx(forward(arm, q).translation, abs=1e-12)


def test_ready_of_the_560_is_that_of_the_manual() -> None:
    arm = arm_named("puma560")
    expected = (-20.32, 149.09, 921.12, 90.0, -90.0, 0.0)
    assert components(forward(arm, arm.ready)) == pytest.approx(expected, abs=1e-3)


def test_limits_name_every_joint_outside_them() -> None:
    arm = arm_named("puma761")
    assert limit_violations(arm, arm.upper) == ()
    assert limit_violations(arm, arm.lower) == ()
    beyond = (arm.upper[0] + 0.01, *arm.ready[1:5], arm.lower[5] - 0.01)
    assert [joint for joint, *_ in limit_violations(arm, beyond)] == [1, 6]
    assert limit_violations(arm, beyond)[0][1:] == (beyond[0], arm.lower[0], arm.upper[0])


def test_the_turn_nearest_the_present_one_is_taken() -> None:
    arm = arm_named("puma761")
    q = configuration([10, -30, 120, 20, 40, -170])
    near = configuration([10, -30, 120, 20, 40, 170])
    branch = branch_of(arm, q)
    found = solve(arm, forward(arm, q), branch, near)
    assert found is not None
    assert found[5] == pytest.approx(190 * DEG)


@pytest.mark.parametrize(("x", "kind"), [(3.0, "too far"), (0.2, "too close")])
def test_out_of_reach_says_why(x: float, kind: str) -> None:
    arm = arm_named("puma761")
    X_BF = IDENTITY._replace(translation=(x if kind == "too far" else 0.05, 0.0, arm.d6))
    found = reach_error(arm, X_BF)
    assert found is not None
    assert found[0] == kind
    assert found[1] > 0.0
    assert all(solve(arm, X_BF, branch, arm.ready) is None for branch in ALL_BRANCHES)


def test_the_excess_is_how_far_the_location_must_come_back() -> None:
    arm = arm_named("puma761")
    reach = arm.a2 + math.hypot(arm.a3, arm.d4)
    for beyond in (0.001, 0.1, 1.0):
        level = math.sqrt((reach + beyond) ** 2 + arm.d2**2)
        found = reach_error(arm, translation(level, 0.0, arm.d6))
        assert found is not None
        assert found == ("too far", pytest.approx(beyond, abs=1e-9))
    inside = math.sqrt((reach - 1e-6) ** 2 + arm.d2**2)
    assert reach_error(arm, translation(inside, 0.0, arm.d6)) is None


def test_numbers_of_the_three_arms_differ() -> None:
    poses = [forward(arm_named(name), arm_named(name).ready).translation for name in ARMS]
    assert all(distance(a, b) > 0.01 for a, b in pairwise(poses))
