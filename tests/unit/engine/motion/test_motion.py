"""Motions: times, ends, continuity, limits, straight lines and what refuses them."""

import math
from itertools import pairwise

import pytest

from tests.support_programs import codes, ended, run_body, started
from vrts.base.pose import distance, rotation_angle
from vrts.engine.run import Run
from vrts.ir.instructions import Interpolation
from vrts.robots.kinematics.kinematics import limit_violations

TICK = 0.028


def test_joint_motion_takes_the_slowest_joint_plus_acceleration() -> None:
    run = run_body("DRIVE 1, 100, 100")
    arm = run.scene.robot.arm
    (motion,) = run.motions
    least = math.radians(100.0) / arm.speed[0]
    assert motion.end_s - motion.start_s == pytest.approx(
        math.ceil(least / arm.tick) * arm.tick + arm.acceleration_time, abs=1e-9
    )
    ticks = (motion.end_s - motion.start_s) / arm.tick
    assert ticks == pytest.approx(round(ticks), abs=1e-6)


CARRY = "MOVE a\nMOVES b\nMOVE c\nAPPROS a, 50\nDEPARTS 30\nREADY"
STOPS = CARRY.replace("\n", "\nBREAK\n")


def times(run: Run) -> list[float]:
    return [k * run.horizon_s / 400 for k in range(401)]


def test_motions_that_are_not_rounded_reach_their_goals() -> None:
    run = run_body(STOPS)
    assert codes(run) == []
    assert len(run.motions) == 6
    for motion in run.motions:
        state = run.at(motion.end_s)
        assert state.configuration == pytest.approx(motion.goal, abs=1e-9)
        assert run.at(motion.start_s).configuration == pytest.approx(motion.start, abs=1e-9)
    for before, after in pairwise(run.motions):
        assert before.goal == after.start


@pytest.mark.parametrize("body", [CARRY, STOPS])
def test_positions_and_velocities_are_continuous(body: str) -> None:
    run = run_body(body)
    for before, after in pairwise(run.timeline.segments):
        assert before.end_s == after.start_s
        t = before.end_s - before.start_s
        for a, b in zip(before.coefficients[:6], after.coefficients[:6], strict=True):
            here = sum(c * t**k for k, c in enumerate(a))
            speed = sum(k * c * t ** (k - 1) for k, c in enumerate(a) if k)
            assert here == pytest.approx(b[0], abs=1e-9)
            assert speed == pytest.approx(b[1] if len(b) > 1 else 0.0, abs=1e-6)


def test_joints_keep_their_ranges_and_joint_motions_their_speeds() -> None:
    run = run_body("MOVE a\nMOVE b\nMOVE c\nREADY")
    arm = run.scene.robot.arm
    for time in times(run):
        state = run.at(time)
        assert limit_violations(arm, state.configuration) == ()
        for speed, limit in zip(state.velocity, arm.speed, strict=True):
            assert abs(speed) <= limit * (1 + 1e-9)


def test_a_straight_line_is_straight() -> None:
    run = run_body("MOVE a\nBREAK\nSPEED 500 MMPS\nMOVES b")
    line = run.motions[1]
    assert line.interpolation is Interpolation.LINEAR
    assert 0.0 < line.deviation_m < 1e-6
    start, goal = run.at(line.start_s).X_WT, run.at(line.end_s).X_WT
    length = distance(start.translation, goal.translation)
    assert length == pytest.approx(0.4, abs=1e-6)
    worst = 0.0
    for k in range(500):
        X_WT = run.at(line.start_s + k * (line.end_s - line.start_s) / 500).X_WT
        part = sum(
            (x - a) * (b - a)
            for x, a, b in zip(X_WT.translation, start.translation, goal.translation, strict=True)
        ) / (length * length)
        foot = [
            a + part * (b - a) for a, b in zip(start.translation, goal.translation, strict=True)
        ]
        worst = max(worst, math.dist(X_WT.translation, foot))
        assert rotation_angle(X_WT.rotation, start.rotation) < 1e-5
    assert worst < 1e-6


def test_a_line_goes_at_the_speed_asked_for() -> None:
    run = run_body("MOVE a\nSPEED 200 MMPS\nMOVES b")
    middle = 0.5 * (run.motions[1].start_s + run.motions[1].end_s)
    a, b = (run.at(middle + h).X_WT.translation for h in (-1e-3, 1e-3))
    assert distance(a, b) / 2e-3 == pytest.approx(0.2, rel=0.02)


REFUSED = [
    ("MOVES a", "V305"),
    ("MOVE TRANS(2000,0,0,90,90,0)", "V301"),
    ("DRIVE 3, 200, 50", "V303"),
    ("n = 7\nDRIVE n, 10, 50", "V307"),
    ("MOVE a\nRIGHTY\nMOVES b", "V304"),
]


@pytest.mark.parametrize(("body", "code"), REFUSED)
def test_a_motion_that_cannot_be_made_is_refused(body: str, code: str) -> None:
    run = run_body(body)
    assert codes(run) == [code]
    assert len(run.motions) == body.count("MOVE a")


def test_a_line_that_leaves_the_reach_stops_on_its_way() -> None:
    run = run_body("MOVE a\nMOVES TRANS(1700,200,100,90,90,0)")
    assert codes(run)[0] in ("V301", "V303", "V306")
    assert run.ending.value == "error"
    x = run.at(run.horizon_s).X_WT.translation[0]
    assert 0.9 < x < 1.7


def test_after_a_stop_the_arm_settles_before_it_goes_on() -> None:
    run = run_body("MOVE a\nMOVE b\nBREAK\nMOVE c")
    begin, end = started(run), ended(run)
    assert begin[1] == end[0]
    assert begin[2] >= end[1] + 3 * TICK - 1e-9


def test_moving_twice_to_one_place_moves_once() -> None:
    run = run_body("MOVE a\nBREAK\nMOVE a")
    assert run.motions[1].start == run.motions[1].goal
    assert run.motions[1].end_s == run.motions[1].start_s
