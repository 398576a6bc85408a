"""Continuous path: where motions are rounded into each other, and where the arm stops [C86]."""

import math

import pytest

from tests.support_engine import TACC, TICK, runs, tool_speed
from tests.support_programs import codes, ended, started, switched
from vrts.base.pose import distance
from vrts.engine.run import Run

COLLINEAR = "MOVE a\nBREAK\nMOVES d\nMOVES b"  # d is in the middle between a and b

PAIRS = [
    ("joint and joint", "MOVE a\nMOVE b"),
    ("line and line", "MOVE a\nBREAK\nMOVES d\nMOVES c"),
    ("joint and line", "MOVE a\nMOVES d"),
    ("line and joint", "MOVE a\nBREAK\nMOVES d\nMOVE c"),
]


def last_two(run: Run) -> tuple[float, float]:
    """Return when the zone between the last two motions begins and ends [s]."""
    begin = run.motions[-1].start_s
    return begin, begin + 2 * TACC


def test_the_middle_of_three_points_in_line_is_passed_at_full_speed() -> None:
    run = runs(COLLINEAR)
    begin, end = last_two(run)
    assert run.motions[1].blended
    for k in range(11):
        speed = tool_speed(run, begin + k * (end - begin) / 10)
        assert speed == pytest.approx(0.2 / (2 * TACC), rel=0.02)  # 200 mm in the least time


def test_with_cp_off_the_arm_stops_in_the_middle() -> None:
    run = runs("DISABLE CP\n" + COLLINEAR)
    middle = run.motions[1]
    assert not middle.blended
    assert run.at(middle.end_s).velocity == (0.0,) * 6
    assert run.at(middle.end_s).configuration == pytest.approx(middle.goal, abs=1e-9)
    assert run.motions[2].start_s >= middle.end_s


def test_cp_off_does_not_hold_the_program_up() -> None:
    """Every motion ends at rest, but steps run ahead of the arm as before."""
    run = runs("DISABLE CP\nMOVE a\nSIGNAL 1\nMOVE b\nSIGNAL 2")
    on = switched(run)
    assert on[1] < ended(run)[0]
    assert on[2] < ended(run)[1]


def test_cp_acts_from_the_next_motion_on() -> None:
    run = runs("MOVE a\nMOVE b\nDISABLE CP\nMOVE c\nENABLE CP\nMOVE a\nMOVE b")
    assert [motion.blended for motion in run.motions] == [True, False, True, True, False]


@pytest.mark.parametrize(("body"), [body for _, body in PAIRS], ids=[name for name, _ in PAIRS])
def test_any_two_motions_are_rounded(body: str) -> None:
    run = runs(body)
    assert codes(run) == []
    assert run.motions[-2].blended
    begin, end = last_two(run)
    for k in range(21):
        speed = max(abs(v) for v in run.at(begin + k * (end - begin) / 20).velocity)
        assert speed > 0.0
    assert run.at(run.horizon_s).configuration == pytest.approx(run.motions[-1].goal, abs=1e-9)


@pytest.mark.parametrize(("body"), [body for _, body in PAIRS], ids=[name for name, _ in PAIRS])
def test_a_rounded_corner_passes_near_its_point(body: str) -> None:
    run = runs(body)
    corner = run.motions[-2].X_WT.translation
    begin, end = last_two(run)
    miss = min(
        distance(run.at(begin + k * (end - begin) / 200).X_WT.translation, corner)
        for k in range(201)
    )
    assert 0.001 < miss < 0.08


def test_the_corner_of_two_joint_motions_is_missed_by_the_closed_form() -> None:
    """Half way through the zone: (speed in - speed out) * zone * 3/32 from the corner [Paul]."""
    run = runs("DRIVE 1, 40, 100\nDRIVE 1, -40, 100")
    top = max(run.at(k * run.horizon_s / 4000).configuration[0] for k in range(4001))
    full = run.motions[0].end_s - run.motions[0].start_s
    speed = math.radians(40.0) / (math.ceil(2 * TACC / TICK) * TICK)
    assert full > TACC
    assert math.radians(40.0) - top == pytest.approx(2 * speed * 2 * TACC * 3 / 32, rel=1e-3)


def test_slower_programs_round_less() -> None:
    misses: list[float] = []
    for percent in (100, 50, 25):
        run = runs(f"SPEED {percent} ALWAYS\nMOVE a\nBREAK\nMOVES b\nMOVES c")
        corner = run.motions[1].X_WT.translation
        begin, end = last_two(run)
        middle = run.at(0.5 * (begin + end)).X_WT.translation
        misses.append(distance(middle, corner))
    assert misses[0] > 1.5 * misses[1] > 2.0 * misses[2] > 0.0


BREAKING = ["BREAK", "DELAY 0.1", "TOOL NULL", "BASE", "OPENI", "CLOSEI", "RELAXI", "LEFTY"]


@pytest.mark.parametrize("step", BREAKING)
def test_steps_that_break_continuous_path(step: str) -> None:
    run = runs(f"MOVE a\n{step}\nMOVE b")
    first, second = run.motions
    assert not first.blended
    assert run.at(first.end_s).velocity == (0.0,) * 6
    assert run.at(first.end_s).configuration == pytest.approx(first.goal, abs=1e-9)
    assert second.start_s >= first.end_s


GOES_ON = ["x = 1", "SIGNAL 1", "OPEN", "SPEED 50", "WAIT", 'TYPE "x"', "COARSE", "CALL p"]


@pytest.mark.parametrize("step", GOES_ON)
def test_steps_that_do_not(step: str) -> None:
    run = runs(f"MOVE a\n{step}\nMOVE b", ".PROGRAM p\nTYPE 1\n.END\n")
    assert run.motions[0].blended


def test_a_motion_with_another_arm_branch_starts_from_rest() -> None:
    run = runs("MOVE a\nFLIP\nMOVE a\nMOVE b")
    assert codes(run) == []
    assert [motion.blended for motion in run.motions] == [False, True, False]


def test_a_motion_that_comes_too_late_starts_from_rest() -> None:
    """The program waits until the arm slows down already."""
    for wait, blended in ((0.3, True), (1.5, False)):
        run = runs(f"TIMER 1 = 0\nMOVE a\nWAIT TIMER(1) > {wait}\nMOVE b")
        assert run.motions[0].blended is blended
    assert run.motions[1].start_s >= run.motions[0].end_s
    assert run.at(run.motions[0].end_s).velocity == (0.0,) * 6


@pytest.mark.parametrize(("setting", "ticks"), [("FINE", 3), ("COARSE", 1), ("NONULL", 0)])
def test_a_stop_that_nobody_asked_for_settles_too(setting: str, ticks: int) -> None:
    run = runs(f"DISABLE CP\n{setting}\nMOVE a\nMOVE b")
    assert started(run)[1] - ended(run)[0] == pytest.approx(ticks * TICK)


def test_accelerations_stay_within_one_and_a_half_of_speed_by_time() -> None:
    run = runs("MOVE a\nMOVE b\nMOVE c\nMOVE a\nDRIVE 1, 30, 100\nREADY")
    arm = run.scene.robot.arm
    for segment in run.timeline.segments:
        for row, most in zip(segment.coefficients[:6], arm.speed, strict=True):
            for k in range(5):
                t = k * (segment.end_s - segment.start_s) / 4
                second = sum(n * (n - 1) * c * t ** (n - 2) for n, c in enumerate(row) if n > 1)
                assert abs(second) <= 1.5 * most / TACC * (1 + 1e-9)


def test_a_motion_that_goes_nowhere_can_be_joined() -> None:
    run = runs("MOVE a\nMOVE a\nMOVE b")
    assert codes(run) == []
    assert run.at(run.horizon_s).configuration == pytest.approx(run.motions[2].goal, abs=1e-9)
