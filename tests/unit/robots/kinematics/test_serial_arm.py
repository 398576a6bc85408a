"""Arms without a closed form: solutions from fixed starts, along lines, near singularities."""

import math
import random
from dataclasses import replace
from typing import cast

import pytest

from vrts.base.pose import Pose, distance, rotation_about, rotation_angle, translation
from vrts.base.units import DEG
from vrts.robots.catalog import arm as arm_named
from vrts.robots.catalog import puma
from vrts.robots.kinematics.approach import approach, rotation_vector
from vrts.robots.kinematics.branch import INITIAL_BRANCH, branch_of, has_branches
from vrts.robots.kinematics.chain import fixed_frames
from vrts.robots.kinematics.choice import Choice, OutOfLimits, OutOfReach, Request, choose
from vrts.robots.kinematics.kinematics import (
    forward,
    joint_velocity,
    limit_violations,
    link_poses,
    reach_error,
    solve,
)
from vrts.robots.kinematics.levers import levers
from vrts.robots.kinematics.serial_solutions import (
    FINER,
    MOST_STEPS,
    nearest_turns,
    solutions,
    starts,
)
from vrts.robots.kinematics.singular import singular_at
from vrts.robots.kinematics.tracking import track
from vrts.robots.model import Arm, Configuration, SerialArm, Shoulder

UR5 = arm_named("ur5")
HERE = (0.1, -0.8, 1.5, 0.1, 0.7, 0.1)


def serial(name: str) -> SerialArm:
    """Return a PUMA as an arm of which only the six joints are known."""
    arm = puma(name)
    return SerialArm(
        name=arm.name,
        title=arm.title,
        joints=fixed_frames(arm),
        X_LF=arm.X_LF,
        shoulder_height=arm.shoulder_height,
        lower=arm.lower,
        upper=arm.upper,
        speed=arm.speed,
        ready=arm.ready,
        linear_speed=arm.linear_speed,
        angular_speed=arm.angular_speed,
        acceleration_time=arm.acceleration_time,
        tick=arm.tick,
        links=(),
        skipped_pairs=frozenset(),
    )


def some(arm: Arm, count: int, seed: int = 1) -> list[Configuration]:
    numbers = random.Random(seed)
    limits = [
        (max(lo, -math.pi), min(hi, math.pi)) for lo, hi in zip(arm.lower, arm.upper, strict=True)
    ]
    return [
        cast(Configuration, tuple(numbers.uniform(lo, hi) for lo, hi in limits))
        for _ in range(count)
    ]


def degrees(*angles: float) -> Configuration:
    return cast(Configuration, tuple(angle * DEG for angle in angles))


def change(a: Configuration, b: Configuration) -> float:
    return max(abs(x - y) for x, y in zip(a, b, strict=True))


def test_a_chain_of_a_pumas_joints_moves_like_the_puma() -> None:
    arm, other = puma("puma560"), serial("puma560")
    for q in some(arm, 50):
        X, X_other = forward(arm, q), forward(other, q)
        assert X_other.translation == pytest.approx(X.translation, abs=1e-12)
        assert X_other.rotation == pytest.approx(X.rotation, abs=1e-12)
        v, w = (0.1, -0.2, 0.3), (0.2, 0.1, -0.4)
        rates, others = joint_velocity(arm, q, v, w), joint_velocity(other, q, v, w)
        if rates is not None and others is not None and max(map(abs, rates)) < 10.0:
            assert others == pytest.approx(rates, abs=1e-9)


def test_links_and_flange_belong_together() -> None:
    for q in some(UR5, 10):
        X_BF = link_poses(UR5, q)[6] @ UR5.X_LF
        assert X_BF.translation == pytest.approx(forward(UR5, q).translation, abs=1e-12)


@pytest.mark.parametrize("arm", [UR5, serial("puma761"), serial("puma560")], ids=lambda a: a.name)
def test_every_pose_within_the_limits_is_reached_exactly(arm: SerialArm) -> None:
    for q, near in zip(some(arm, 12), some(arm, 12, seed=2), strict=True):
        X_BF = forward(arm, q)
        found = choose(arm, X_BF, INITIAL_BRANCH, near)
        assert isinstance(found, Choice)
        assert not limit_violations(arm, found.configuration)
        again = forward(arm, found.configuration)
        assert distance(again.translation, X_BF.translation) < 1e-9
        assert rotation_angle(again.rotation, X_BF.rotation) < 1e-8


def test_of_all_solutions_the_nearest_is_taken() -> None:
    near = UR5.ready
    X_BF = forward(UR5, degrees(-20, -80, 100, -110, -90, 30))
    assert isinstance(UR5, SerialArm)
    found = solutions(UR5, X_BF, near)
    assert len(found) >= 4  # elbow up and down, wrist either way, shoulder either way
    changes = [change(q, near) for q in found]
    assert changes == pytest.approx(sorted(changes), abs=1e-5)  # rounding does not choose
    choice = choose(UR5, X_BF, INITIAL_BRANCH, near)
    assert isinstance(choice, Choice)
    assert choice.configuration == found[0]
    assert choice.configuration == pytest.approx(degrees(-20, -80, 100, -110, -90, 30), abs=1e-7)


def test_the_same_question_has_the_same_answer() -> None:
    X_BF = forward(UR5, degrees(50, -70, 80, -60, -80, 10))
    answers = {solve(UR5, X_BF, INITIAL_BRANCH, UR5.ready) for _ in range(3)}
    assert len(answers) == 1


def test_turns_nearest_to_the_present_ones_are_taken() -> None:
    q = degrees(10, -80, 90, -100, -90, 20)
    near = degrees(10, -80, 90, -100, -90, 20 - 360)
    found = solve(UR5, forward(UR5, q), INITIAL_BRANCH, near)
    assert found is not None
    assert found == pytest.approx(near, abs=1e-7)


def test_branches_mean_nothing() -> None:
    assert not has_branches(UR5)
    assert has_branches(puma("puma761"))
    assert branch_of(UR5, UR5.ready) == INITIAL_BRANCH
    righty = INITIAL_BRANCH._replace(shoulder=Shoulder.RIGHTY)
    assert branch_of(UR5, UR5.ready, righty) == righty
    X_BF = forward(UR5, degrees(10, -80, 90, -100, -90, 20))
    free = choose(UR5, X_BF, INITIAL_BRANCH, UR5.ready)
    asked = choose(UR5, X_BF, INITIAL_BRANCH, UR5.ready, Request(shoulder=Shoulder.RIGHTY))
    assert free == asked


def test_too_far_says_by_how_much() -> None:
    down = forward(UR5, UR5.ready).rotation
    found = choose(UR5, Pose(down, (1.05, 0.1, 0.1)), INITIAL_BRANCH, UR5.ready)
    assert isinstance(found, OutOfReach)
    assert found.kind == "too far"
    for more, reached in ((-2e-3, False), (2e-3, True)):
        nearer = Pose(down, (1.05 - found.excess_m - more, 0.1, 0.1))
        assert (reach_error(UR5, nearer) is None) is reached


def test_too_close_to_the_own_axis() -> None:
    X_BF = forward(UR5, UR5.ready)
    found = reach_error(UR5, Pose(X_BF.rotation, (0.0, 0.02, 0.3)))
    assert found is not None
    assert found[0] == "too close"
    assert found[1] == pytest.approx(0.10915 - 0.02, abs=1e-3)  # its wrist passes axis 1 so far


def test_a_pose_beyond_the_limits_names_the_joint() -> None:
    arm = serial("puma761")
    narrow = replace(arm, lower=degrees(-20, -80, 60, -90, 20, -90), upper=degrees(*[90.0] * 6))
    found = choose(narrow, forward(arm, degrees(-50, -40, 80, 10, 40, 0)), INITIAL_BRANCH, HERE)
    assert isinstance(found, OutOfLimits)
    assert [joint for joint, *_ in found.violations] == [1]
    assert found.elsewhere == ()


def test_a_straight_line_is_followed_set_point_by_set_point() -> None:
    q = degrees(-20, -80, 100, -110, -90, 30)
    X0 = forward(UR5, q)
    for number in range(1, 41):
        X_BF = translation(0.0, 0.005 * number, 0.0) @ X0
        found = track(UR5, X_BF, INITIAL_BRANCH, q)
        assert found is not None
        following, branch = found
        assert branch == INITIAL_BRANCH
        assert change(following, q) < 2.0 * DEG
        assert distance(forward(UR5, following).translation, X_BF.translation) < 1e-9
        q = following


def test_a_line_out_of_reach_ends() -> None:
    beyond = Pose(forward(UR5, UR5.ready).rotation, (1.0, 0.1, 0.1))
    assert track(UR5, beyond, INITIAL_BRANCH, degrees(0, -20, 20, -90, -90, 0)) is None


SINGULAR = [
    (degrees(0, -90, 0, -90, -90, 0), "elbow straight"),
    (degrees(0, -90, 90, -90, 0, 0), "axes of joints 4 and 6 side by side"),
]


@pytest.mark.parametrize(("q", "why"), SINGULAR, ids=[why for _, why in SINGULAR])
def test_singular_configurations_are_known(q: Configuration, why: str) -> None:
    assert why
    assert singular_at(UR5, q) == "singular"
    assert singular_at(UR5, UR5.ready) is None


def test_at_a_singularity_joint_velocities_are_undefined() -> None:
    q = degrees(0, -90, 90, -90, 0, 0)
    assert joint_velocity(UR5, q, (0.1, 0.0, 0.0), (0.0, 0.0, 0.0)) is None


def test_no_point_of_the_hand_is_farther_from_an_axis_than_its_lever() -> None:
    point = (0.03, -0.02, 0.15)
    for arm in (UR5, puma("puma560")):
        bounds = levers(arm, point)
        for q in some(arm, 30):
            at = forward(arm, q).apply(point)
            for lever, X_BL in zip(bounds, link_poses(arm, q)[1:], strict=True):
                x, y, _ = X_BL.inverse().apply(at)
                assert math.hypot(x, y) <= lever + 1e-12


def test_starts_are_within_the_limits() -> None:
    assert isinstance(UR5, SerialArm)
    assert len(starts(UR5)) == 16
    for q in (*starts(UR5), *starts(UR5, FINER)):
        assert not limit_violations(UR5, q)


def test_a_pose_that_the_coarse_grid_misses_is_found_by_the_finer_one() -> None:
    assert isinstance(UR5, SerialArm)
    X_BF = forward(UR5, (1.67, 2.38, -0.46, -2.01, 0.56, -3.0))
    near = (1.73, -0.82, -0.77, -0.02, -0.9, -0.59)
    coarse = [approach(UR5, X_BF, start, MOST_STEPS) for start in (near, *starts(UR5))]
    within = [nearest_turns(UR5, end.configuration, near) for end in coarse if end.reached]
    assert all(limit_violations(UR5, q) for q in within)
    found = solutions(UR5, X_BF, near)
    assert found
    assert not limit_violations(UR5, found[0])


def test_far_away_there_are_no_solutions() -> None:
    assert isinstance(UR5, SerialArm)
    X_BF = Pose(forward(UR5, UR5.ready).rotation, (30.0, 0.0, 0.0))
    assert solutions(UR5, X_BF, UR5.ready) == ()
    found = reach_error(UR5, X_BF)
    assert found is not None
    assert found == ("too far", pytest.approx(30.0 - 0.83, abs=0.1))


@pytest.mark.parametrize("angle", [0.0, 1e-9, 0.5, 3.0, math.pi - 1e-9, math.pi])
def test_axis_times_angle_is_found_for_every_turn(angle: float) -> None:
    axis = (0.6, 0.0, 0.8)
    found = rotation_vector(rotation_about(axis, angle))
    sign = 1.0 if found[2] >= 0.0 else -1.0  # half a turn has two axes
    assert found == pytest.approx([sign * angle * part for part in axis], abs=1e-7)


def test_the_best_so_far_is_returned_when_steps_run_out() -> None:
    assert isinstance(UR5, SerialArm)
    X_BF = forward(UR5, degrees(-20, -80, 100, -110, -90, 30))
    near = UR5.ready
    coarse, fine = approach(UR5, X_BF, near, 1), approach(UR5, X_BF, near, 30)
    assert not coarse.reached
    assert fine.reached
    assert fine.gap_m < coarse.gap_m < distance(X_BF.translation, forward(UR5, near).translation)
