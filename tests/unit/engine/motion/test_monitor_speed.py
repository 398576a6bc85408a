"""The operator's speed stretches time; the path stays [C88]."""

import math

import pytest

from tests.support_engine import TACC, driven, length_of_path, main, refused, runs
from tests.support_programs import ended
from vrts.base.pose import distance
from vrts.engine.run import Run
from vrts.ir.commands import Execute, MonitorSpeed
from vrts.scene.model import Scenario

TOUR = "MOVE a\nMOVE d\nMOVES c\nMOVES b\nDRIVE 1, 20, 60"


def nearest(run: Run, place: tuple[float, float, float], times: int = 3000) -> float:
    """Return how near the tool comes to a place [m]."""
    return min(
        distance(run.at(k * run.horizon_s / times).X_WT.translation, place)
        for k in range(times + 1)
    )


def test_all_times_of_motions_are_stretched() -> None:
    full = runs(TOUR)
    slow = runs(TOUR, scenario=Scenario(monitor_speed=25.0))
    first = full.motions[0].start_s
    for a, b in zip(full.motions, slow.motions, strict=True):
        assert b.end_s - slow.motions[0].start_s == pytest.approx(4 * (a.end_s - first), abs=1e-6)
        assert b.goal == pytest.approx(a.goal, abs=1e-9)


def test_the_path_stays_corners_included() -> None:
    full = runs(TOUR)
    slow = runs(TOUR, scenario=Scenario(monitor_speed=30.0))
    for k in range(200):
        t = k * (full.motions[-1].end_s - full.motions[0].start_s) / 200
        fast_q = full.at(full.motions[0].start_s + t).configuration
        slow_q = slow.at(slow.motions[0].start_s + t / 0.3).configuration
        assert slow_q == pytest.approx(fast_q, abs=1e-6)


def test_a_change_on_the_way_keeps_the_path_too() -> None:
    text = main(TOUR)
    full = driven(text, 30.0)
    changed = driven(text, 60.0, (0.9, MonitorSpeed(20)), (4.0, MonitorSpeed(70)))
    assert ended(changed)[-1] > ended(full)[-1] + 1.0
    assert length_of_path(changed) == pytest.approx(length_of_path(full), rel=1e-3)
    for motion in full.motions[:-1]:
        place = motion.X_WT.translation
        assert nearest(changed, place) == pytest.approx(nearest(full, place), abs=1e-3)


def test_a_change_is_smooth() -> None:
    run = driven(main("DRIVE 1, 150, 50"), 20.0, (1.5, MonitorSpeed(40)))
    before, after = run.at(1.4).velocity[0], run.at(1.5 + TACC + 0.03).velocity[0]
    assert after == pytest.approx(0.4 * before)
    arm = run.scene.robot.arm
    for k in range(200):
        t = 1.4 + k * 0.5 / 200
        rise = (run.at(t + 1e-4).velocity[0] - run.at(t).velocity[0]) / 1e-4
        assert abs(rise) <= arm.speed[0] / TACC


@pytest.mark.parametrize(("speed", "times"), [(100, 1.0), (50, 2.0)])
def test_program_and_monitor_speed_multiply(speed: float, times: float) -> None:
    run = runs(f"SPEED {speed} ALWAYS\nDRIVE 1, 1\nMOVE #PPOINT(150,-90,90,0,0,0)")
    half = runs(
        f"SPEED {speed} ALWAYS\nDRIVE 1, 1\nMOVE #PPOINT(150,-90,90,0,0,0)",
        scenario=Scenario(monitor_speed=50.0),
    )
    assert ended(half)[-1] / ended(run)[-1] == pytest.approx(2.0, rel=0.02)
    constant = math.radians(149) / run.scene.robot.arm.speed[0] * times
    assert ended(run)[-1] == pytest.approx(constant, rel=0.5)


def test_half_of_half_is_four_times_as_long() -> None:
    move = "MOVE #PPOINT(150,-90,90,0,0,0)"
    full = runs(move)
    quarter = runs(f"SPEED 50 ALWAYS\n{move}", scenario=Scenario(monitor_speed=50.0))
    ratio = quarter.motions[0].end_s / full.motions[0].end_s
    assert ratio == pytest.approx(4.0, rel=0.15)  # accelerations are not slower with SPEED


def test_delays_and_the_hand_take_their_own_time() -> None:
    slow = Scenario(monitor_speed=20.0)
    assert runs("DELAY 1", scenario=slow).ended_s == pytest.approx(1.0, abs=0.06)
    hand = [runs("OPENI", scenario=s).ended_s for s in (Scenario(), slow)]
    assert hand[0] == hand[1]


def test_the_speed_is_above_zero_and_at_most_full() -> None:
    run = driven(main("DELAY 1"), 3.0, (0.1, MonitorSpeed(0)), (0.2, MonitorSpeed(500)))
    assert refused(run) == ["Illegal value"]
    assert run.at(3.0).monitor_speed == 100.0


def test_a_program_may_set_it_in_v_plus() -> None:
    run = runs("SPEED 25 MONITOR\nTYPE SPEED(1)\nDRIVE 1, 60, 100", dialect="vplus")
    assert run.output.split() == ["25"]
    assert run.motions[0].end_s - run.motions[0].start_s > 3.2


def test_the_speed_stays_for_the_next_program() -> None:
    text = main("DELAY 1\nDRIVE 1, 40, 100\nDRIVE 1, -40, 100")
    run = driven(text, 40.0, (0.1, MonitorSpeed(50)), (20.0, Execute("main")))
    first, second = run.motions[0], run.motions[2]
    assert second.end_s - second.start_s == pytest.approx(first.end_s - first.start_s, abs=0.03)
