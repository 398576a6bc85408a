"""Straight lines: where the tool is, how it turns, how exactly, and which joints that takes."""

import math

import pytest

from tests.support_engine import runs, tool_speed
from tests.support_programs import codes, ended, started
from vrts.base.oat import pose_from_components
from vrts.base.pose import Rotation, distance, multiply, rotation_angle, transpose
from vrts.engine.motion.lines.turning import turning
from vrts.engine.run import Run

TURNS = ["90,90,40", "70,70,20", "90,120,-60", "40,90,0"]


def turn_z(angle: float) -> Rotation:
    c, s = math.cos(angle), math.sin(angle)
    return (c, -s, 0.0, s, c, 0.0, 0.0, 0.0, 1.0)


def turn_y(angle: float) -> Rotation:
    c, s = math.cos(angle), math.sin(angle)
    return (c, 0.0, s, 0.0, 1.0, 0.0, -s, 0.0, c)


def between(start: Rotation, goal: Rotation, u: float) -> Rotation:
    """Return Paul's two rotations at u, written out as in the reference (7.4)."""
    d = multiply(transpose(start), goal)
    psi = math.atan2(d[5], d[2])
    theta = math.atan2(math.hypot(d[2], d[5]), d[8])
    phi = math.remainder(math.atan2(d[7], -d[6]) + psi, math.tau)
    if theta < 1e-12:
        psi, phi = 0.0, math.atan2(d[3], d[0])
    tilt = multiply(multiply(turn_z(psi), turn_y(u * theta)), turn_z(-psi))
    return multiply(multiply(start, tilt), turn_z(u * phi))


def on_the_way(run: Run, motion: int, count: int = 60) -> list[float]:
    begin, end = started(run)[motion], ended(run)[motion]
    return [begin + k * (end - begin) / count for k in range(count + 1)]


@pytest.mark.parametrize("angles", TURNS)
def test_the_tool_turns_about_two_axes_in_step_with_its_way(angles: str) -> None:
    run = runs(f"MOVE a\nBREAK\nSPEED 20\nMOVES TRANS(900,-100,150,{angles})")
    assert codes(run) == []
    start = pose_from_components(900, 200, 100, 90, 90, 0)
    goal = run.motions[1].X_WT
    length = distance(start.translation, goal.translation)
    for t in on_the_way(run, 1):
        X_WT = run.at(t).X_WT
        u = distance(start.translation, X_WT.translation) / length
        expected = between(start.rotation, goal.rotation, u)
        assert rotation_angle(expected, X_WT.rotation) < 1e-4


@pytest.mark.parametrize("speed", [100, 250, 500])
def test_the_tool_stays_on_the_line(speed: int) -> None:
    run = runs(f"MOVE a\nBREAK\nSPEED {speed} MMPS\nMOVES b")
    assert run.motions[1].deviation_m < 1e-6
    for t in on_the_way(run, 1, 500):
        x, _, z = run.at(t).X_WT.translation
        assert math.hypot(x - 0.9, z - 0.1) < 1e-6  # 0.001 mm


def test_the_speed_is_steady_between_the_ends() -> None:
    run = runs("MOVE a\nBREAK\nSPEED 200 MMPS\nMOVES b")
    steady = on_the_way(run, 1, 100)[15:86]
    speeds = [tool_speed(run, t) for t in steady]
    assert max(speeds) - min(speeds) < 1e-3
    assert speeds[0] == pytest.approx(0.4 / (math.ceil(2.0 / 0.028) * 0.028), rel=1e-3)


def test_turning_takes_its_time_when_the_way_is_short() -> None:
    """60 degrees at 100 degrees a second, though the way is only 10 mm."""
    run = runs("MOVE a\nBREAK\nMOVES TRANS(900,210,100,90,90,60)")
    lasts = ended(run)[1] - started(run)[1]
    assert lasts == pytest.approx(math.ceil(0.6 / 0.028) * 0.028 + 0.224)


def test_the_joints_are_those_of_the_line_at_every_instant() -> None:
    """The branch stays, the joints move without steps."""
    run = runs("MOVE a\nBREAK\nMOVES b\nMOVES c\nMOVES a")
    arm = run.scene.robot.arm
    before = run.at(started(run)[1]).configuration
    for k in range(1, 1500):
        t = started(run)[1] + k * (ended(run)[-1] - started(run)[1]) / 1500
        now = run.at(t).configuration
        step = max(abs(x - y) / v for x, y, v in zip(now, before, arm.speed, strict=True))
        assert step < 0.02
        before = now


@pytest.mark.parametrize("tilt", [2e-12, 1e-10, 1e-8, 1e-3, 1.0, 2.5])
def test_a_turn_ends_where_it_should_though_the_hand_hardly_tilts(tilt: float) -> None:
    """Which way the hand tilts is rounding then, and what turns beside it must not take it over."""
    for psi in (0.3, 2.2, -3.0):
        for phi in (0.4, -2.9):
            start = multiply(turn_z(0.7), turn_y(1.1))
            tilted = multiply(multiply(turn_z(psi), turn_y(tilt)), turn_z(phi - psi))
            goal = multiply(start, tilted)
            found = turning(start, goal)
            back = multiply(turn_y(found.theta), turn_z(found.phi - found.psi))
            reached = multiply(start, multiply(turn_z(found.psi), back))
            assert rotation_angle(reached, goal) < 3e-8
