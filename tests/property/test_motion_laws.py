"""Laws of motion: no gaps, smooth velocities, bounded accelerations, straight lines, stops."""

import math
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.laws import examples
from tests.support_programs import ALONE, PLACES, compiled, program, run_body
from vrts.base.pose import subtract
from vrts.base.units import MM
from vrts.engine.controller import advance, start
from vrts.engine.memory.records import Motion
from vrts.engine.motion.polynomials import composed, rate, shifted, value
from vrts.engine.run import Run
from vrts.ir.commands import Execute, MonitorSpeed, Panic, Proceed, TimedCommand
from vrts.ir.instructions import Interpolation
from vrts.robots.kinematics.kinematics import forward
from vrts.scene.model import Scenario

ARM = ALONE.robot.arm
TICK = ARM.tick
STEADY = 1e-6  # [rad/s] of a velocity that is continuous
SETTLING = 3 * TICK  # at a stop with FINE

MOVES = st.sampled_from(
    [
        "MOVE a",
        "MOVE b",
        "MOVE c",
        "MOVES a",
        "MOVES b",
        "MOVES c",
        "APPRO a, 80",
        "APPROS b, 60",
        "DEPART 40",
        "DEPARTS 30",
        "DRIVE 1, 20",
        "DRIVE 6, -40, 30",
        "READY",
        "SPEED 40",
        "SPEED 300 MMPS ALWAYS",
        "SPEED 100 ALWAYS",
        "BREAK",
        "DELAY 0.2",
        "BRAKE",
        "OPEN",
        "CLOSE",
        "COARSE ALWAYS",
        "TOOL TRANS(0,0,100,90,-90,0)",
    ]
)
BODIES = st.lists(MOVES, min_size=2, max_size=9).map(lambda lines: "\n".join(["MOVE c", *lines]))


def smooth(run: Run) -> None:
    segments = run.timeline.segments
    assert segments[0].start_s == 0.0
    for before, after in pairwise(segments):
        assert before.end_s == after.start_s
        t = before.end_s - before.start_s
        for k, (a, b) in enumerate(
            zip(before.coefficients[:6], after.coefficients[:6], strict=True)
        ):
            assert value(a, t) == pytest.approx(value(b, 0.0), abs=1e-9)
            assert rate(a, t) == pytest.approx(rate(b, 0.0), abs=STEADY), (k, before.end_s)


def times_of(motion: Motion) -> np.ndarray:
    return np.linspace(motion.start_s, motion.end_s, 40)


@settings(max_examples=examples(40))
@given(BODIES)
def test_position_and_velocity_are_continuous(body: str) -> None:
    smooth(run_body(body))


@settings(max_examples=examples(40))
@given(
    BODIES,
    st.lists(
        st.tuples(
            st.integers(0, 6000),
            st.sampled_from([MonitorSpeed(25.0), MonitorSpeed(100.0), Panic(), Proceed()]),
        ),
        max_size=4,
    ),
)
def test_so_are_they_when_the_operator_interferes(
    body: str, commands: list[tuple[int, MonitorSpeed | Panic | Proceed]]
) -> None:
    timed = [TimedCommand(ms / 1000, command) for ms, command in commands]
    run = advance(
        start(compiled(program(body)), ALONE), 20.0, [TimedCommand(0.0, Execute("main")), *timed]
    )
    smooth(run)


@settings(max_examples=examples(40))
@given(BODIES)
def test_joint_motions_and_their_corners_accelerate_within_bounds(body: str) -> None:
    """At most 1.5 times the joint's full speed within the acceleration time."""
    run = run_body("\n".join(line for line in body.split("\n") if "S " not in line))
    for segment in run.timeline.segments:
        for joint, row in enumerate(segment.coefficients[:6]):
            second = tuple(k * (k - 1) * c for k, c in enumerate(row))[2:] or (0.0,)
            length = segment.end_s - segment.start_s
            most = max(abs(value(second, length * k / 20)) for k in range(21))
            assert most <= 1.5 * ARM.speed[joint] / ARM.acceleration_time * (1 + 1e-9)


@settings(max_examples=examples(40))
@given(BODIES)
def test_stops_are_exact(body: str) -> None:
    run = run_body(body)
    for before, after in pairwise(run.motions):
        if before.blended or before.cut:
            continue
        assert run.at(before.end_s).configuration == pytest.approx(before.goal, abs=1e-9)
        assert after.start_s >= before.end_s - 1e-9


@settings(max_examples=examples(40))
@given(BODIES)
def test_lines_are_straight_where_the_joints_can_follow(body: str) -> None:
    run = run_body(body)
    for k, motion in enumerate(run.motions):
        if motion.interpolation is not Interpolation.LINEAR or motion.blended or motion.cut:
            continue
        before = run.motions[k - 1]
        begin = motion.start_s + (2 * ARM.acceleration_time if before.blended else 0.0)
        if motion.end_s <= begin:
            continue
        times = np.linspace(begin, motion.end_s, 60)
        poses = [forward(ARM, run.at(float(t)).configuration) @ motion.X_FT for t in times]
        speeds = [run.at(float(t)).velocity for t in times]
        if any(abs(v) > limit for q in speeds for v, limit in zip(q, ARM.speed, strict=True)):
            continue  # a finding of the speed check
        ends = (poses[0].translation, poses[-1].translation)
        travel = np.array(subtract(ends[1], ends[0]))
        length = float(np.linalg.norm(travel))
        if length < 1e-6:
            continue
        for pose in poses:
            offset = np.array(subtract(pose.translation, ends[0]))
            away = offset - travel * float(offset @ travel) / length**2
            allowed = 0.001 * MM * max(length / (motion.end_s - begin) / 0.5, 1.0)
            assert float(np.linalg.norm(away)) <= allowed


@settings(max_examples=examples(40))
@given(
    st.lists(
        st.sampled_from(["MOVE a", "MOVE b", "MOVES a", "MOVES b", "MOVE c", "MOVES c"]),
        min_size=2,
        max_size=6,
    ),
    st.sampled_from([10.0, 25.0, 50.0, 73.0]),
)
def test_the_operators_speed_leaves_the_path(lines: list[str], percent: float) -> None:
    # a motion to where the arm is already stops it, and stops begin and end with a tick
    moves = [line for before, line in pairwise(["MOVE c", *lines]) if before[-1] != line[-1]]
    body = "\n".join(["NONULL ALWAYS", "MOVE c", *moves])  # settling is no part of the path
    full = run_body(body)
    slow = run_body(body, scenario=Scenario(monitor_speed=percent))
    share = percent / 100.0
    assert len(slow.motions) == len(full.motions)
    assert [m.blended for m in slow.motions] == [m.blended for m in full.motions]
    end = full.motions[-1].end_s
    for k in range(80):
        x = (end - TICK) * k / 80
        one = full.at(TICK + x).configuration
        other = slow.at(TICK + x / share).configuration
        assert other == pytest.approx(one, abs=1e-8)


@pytest.mark.parametrize("speed", [100.0, 50.0, 20.0])
def test_the_time_of_a_motion_is_that_of_the_closed_form(speed: float) -> None:
    run = run_body(f"SPEED {speed} ALWAYS\nMOVE a\nBREAK\nMOVES b\nBREAK\nMOVE c")
    first, line, last = run.motions
    rise = ARM.acceleration_time
    for motion in (first, last):
        needed = max(
            abs(b - a) / (v * speed / 100.0)
            for a, b, v in zip(motion.start, motion.goal, ARM.speed, strict=True)
        )
        ticks = math.ceil(max(needed, 2 * rise) / TICK - 1e-9)
        assert motion.end_s - motion.start_s == pytest.approx(ticks * TICK + rise, abs=1e-9)
    length = abs(400.0) * MM
    ticks = math.ceil(max(length / (ARM.linear_speed * speed / 100.0), 2 * rise) / TICK - 1e-9)
    assert line.end_s - line.start_s == pytest.approx(ticks * TICK + rise, abs=1e-9)
    assert line.start_s == pytest.approx(first.end_s + SETTLING + TICK, abs=1e-9)


def test_corners_miss_their_point_as_published() -> None:
    """Three sixteenths of both changes within W: 3/16 (dB + dC) [Paul1981]_."""
    run = run_body(
        "MOVE #PPOINT(0,-60,120,0,30,0)\nMOVE #PPOINT(60,-60,120,0,30,0)\n"
        "MOVE #PPOINT(60,-60,120,0,30,90)"
    )
    corner = run.motions[1]
    assert corner.blended
    zone = corner.end_s  # it begins W before the nominal instant
    q = run.at(zone + ARM.acceleration_time).configuration
    first = run.timeline.velocity(zone)[0]
    second = run.timeline.velocity(zone + 2 * ARM.acceleration_time)[5]
    assert corner.goal[0] - q[0] == pytest.approx(3 / 16 * first * ARM.acceleration_time, abs=1e-9)
    assert q[5] - corner.goal[5] == pytest.approx(3 / 16 * second * ARM.acceleration_time, abs=1e-9)


def test_a_slower_program_speed_rounds_less() -> None:
    def missed(speed: int) -> float:
        run = run_body(f"SPEED {speed} ALWAYS\nMOVE c\nMOVES a\nMOVES b\nMOVES c")
        corner = run.motions[1]
        assert corner.blended
        goal = corner.X_WT.translation
        return min(
            math.dist((forward(ARM, run.at(t).configuration) @ corner.X_FT).translation, goal)
            for t in np.linspace(corner.start_s, corner.end_s + 0.5, 400).tolist()
        )

    distances = [missed(speed) for speed in (60, 30, 15)]
    assert distances[0] > 1.8 * distances[1] > 3.2 * distances[2] > 0.0


ROWS = st.lists(st.floats(-10, 10), min_size=1, max_size=5).map(tuple)


@given(ROWS, st.lists(st.floats(-2, 2), min_size=1, max_size=3).map(tuple), st.floats(-1.5, 1.5))
def test_polynomials_compose_and_shift(
    row: tuple[float, ...], inner: tuple[float, ...], t: float
) -> None:
    assert value(composed(row, inner), t) == pytest.approx(
        value(row, value(inner, t)), rel=1e-9, abs=1e-7
    )
    assert value(shifted(row, inner[0]), t) == pytest.approx(
        value(row, t + inner[0]), rel=1e-9, abs=1e-7
    )


def test_places_are_where_the_tests_think() -> None:
    assert PLACES["a"].split()[1] == "200"
    assert PLACES["b"].split()[1] == "-200"
