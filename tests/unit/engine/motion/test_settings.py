"""SPEED and the other settings of motions: for one motion, for all, and what resets them [C87]."""

import math

import pytest

from tests.support_engine import TACC, TICK, driven, main, runs, tool_speed
from tests.support_programs import codes, ended, started
from vrts.engine.memory.events import SignalChanged
from vrts.engine.run import Run
from vrts.ir.commands import Execute
from vrts.scene.model import Scenario

SWING = "DRIVE 1, 60, 100\nBREAK\nMOVE #PPOINT(-60,-90,90,0,0,0)"


def fractions(run: Run) -> list[float]:
    return [motion.speed_fraction for motion in run.motions]


def lasting(run: Run) -> list[float]:
    """Return the durations of all motions [s]."""
    return [motion.end_s - motion.start_s for motion in run.motions]


SPEEDS = [
    ("SPEED 50\nMOVE a\nMOVE b", [0.5, 1.0]),
    ("SPEED 50 ALWAYS\nMOVE a\nMOVE b", [0.5, 0.5]),
    ("SPEED 50 ALWAYS\nSPEED 20\nMOVE a\nMOVE b", [0.2, 0.5]),
    ("SPEED 50\nSPEED 30\nMOVE a", [0.3]),
    ("SPEED 50\nDRIVE 1, 10, 30\nMOVE b", [0.3, 0.5]),
    ("SPEED 50\nDRIVE 1, 10\nMOVE b", [1.0, 0.5]),
    ("SPEED 50\nMOVE a\nDRIVE 1, 10\nMOVE b", [0.5, 1.0, 1.0]),
    ("SPEED 300\nMOVE a", [1.0]),
    ("PARAMETER SPEED.MAX = 80\nMOVE a\nSPEED 50\nMOVE b", [0.8, 0.5]),
    ("MOVE a\nSPEED 200 MMPS\nMOVES b", [1.0, 0.2]),
    ("MOVE a\nSPEED 10 IPS\nMOVES b", [1.0, 0.254]),
    ("SPEED 250 MMPS\nMOVE a", [0.25]),
    ("SPEED 40\nDELAY 0.2\nMOVE a", [1.0]),
    ("SPEED 40 ALWAYS\nDELAY 0.2\nMOVE a", [0.4]),
]


@pytest.mark.parametrize(("body", "shares"), SPEEDS)
def test_speed(body: str, shares: list[float]) -> None:
    assert fractions(runs(body)) == pytest.approx(shares)


@pytest.mark.parametrize("body", ["SPEED 0", "SPEED -5 ALWAYS", "SPEED 0 MMPS", "DRIVE 1, 5, 0"])
def test_a_speed_is_above_zero(body: str) -> None:
    run = runs(body + "\nMOVE a")
    assert codes(run) == ["V253"]


def test_every_cycle_begins_at_full_speed() -> None:
    text = main("MOVE a\nSPEED 30 ALWAYS\nMOVE b")
    run = driven(text, 20.0, (10.0, Execute("main")))
    assert fractions(run) == pytest.approx([1.0, 0.3, 1.0, 0.3])
    twice = driven(main("STOP"), 1.0, (0.5, Execute("main", 2)))
    assert twice.ending.value == "completed"


def test_a_setting_for_one_motion_does_not_outlive_its_cycle() -> None:
    text = main("IF DEFINED(n) THEN\nMOVE a\nEND\nn = 1\nSPEED 30")
    run = driven(text, 10.0, (1.0, Execute("main")))
    assert fractions(run) == [1.0]


def test_a_joint_motion_at_half_speed_takes_twice_as_long() -> None:
    full, half = (runs(f"SPEED {p}\n{SWING.splitlines()[2]}") for p in (100, 50))
    arm = full.scene.robot.arm
    for run, share in ((full, 1.0), (half, 0.5)):
        least = math.radians(60.0) / (arm.speed[0] * share)
        whole = math.ceil(max(least, 2 * TACC) / TICK - 1e-9) * TICK
        assert lasting(run) == pytest.approx([whole + TACC])


def test_a_line_goes_at_the_speed_asked_for() -> None:
    for unit, speed in (("MMPS", 0.1), ("IPS", 0.1), ("", 0.1)):
        value = {"MMPS": 100.0, "IPS": 100.0 / 25.4, "": 10.0}[unit]
        run = runs(f"MOVE a\nBREAK\nSPEED {value} {unit}\nMOVES b")
        middle = 0.5 * (started(run)[1] + ended(run)[1])
        assert tool_speed(run, middle) == pytest.approx(speed, rel=1e-2)


def test_duration_is_the_least_time_of_motions() -> None:
    body = "DRIVE 1, 30\nDRIVE 2, 30\nDELAY 1"
    body = body.replace("\n", "\nBREAK\n")
    run, always, free = (
        runs(setting + body, dialect="vplus")
        for setting in ("DURATION 3\n", "DURATION 3 ALWAYS\n", "")
    )
    whole = math.ceil(3.0 / TICK) * TICK + TACC
    assert lasting(run) == pytest.approx([whole, lasting(free)[1]])
    assert lasting(always) == pytest.approx([whole, whole])
    for found in (run, always, free):  # a DELAY keeps its time
        assert found.horizon_s - ended(found)[1] == pytest.approx(1.0, abs=5 * TICK)


def test_duration_shorter_than_needed_changes_nothing() -> None:
    plain, short = (runs(f"DURATION {t}\nREADY\nDRIVE 1, 40", dialect="vplus") for t in (0, 0.1))
    assert lasting(plain) == lasting(short)


def test_acceleration_and_deceleration_take_their_share_of_the_time() -> None:
    slow = runs("ACCEL 50, 25\nDRIVE 1, 150, 50", dialect="vplus")
    least = math.radians(150) / (0.5 * slow.scene.robot.arm.speed[0])
    whole = math.ceil(least / TICK) * TICK
    assert lasting(slow) == pytest.approx([whole + 0.5 * 2 * TACC + 0.5 * 4 * TACC])
    segments = [s for s in slow.timeline.segments if s.motion == 0]
    assert segments[0].end_s - segments[0].start_s == pytest.approx(2 * TACC)
    assert segments[-1].end_s - segments[-1].start_s == pytest.approx(4 * TACC)


@pytest.mark.parametrize("step", ["ACCEL 0", "ACCEL 100, -1", "ACCEL 5000"])
def test_an_acceleration_out_of_range_is_refused(step: str) -> None:
    assert codes(runs(step, dialect="vplus")) == ["V253"]


SETTLING = [
    ("", 3),
    ("FINE\n", 3),
    ("COARSE\n", 1),
    ("COARSE ALWAYS\n", 1),
    ("NONULL\n", 0),
    ("NONULL ALWAYS\n", 0),
    ("NONULL ALWAYS\nNULL\n", 3),
    ("COARSE ALWAYS\nFINE\n", 3),
    ("NONULL\nCOARSE\n", 0),
]


@pytest.mark.parametrize(("setting", "ticks"), SETTLING)
def test_ticks_until_a_stop_counts_as_reached(setting: str, ticks: int) -> None:
    run = runs(f"{setting}MOVE a\nBREAK\nSIGNAL 1")
    (on,) = [e.time_s for e in run.events if isinstance(e, SignalChanged)]
    assert on - ended(run)[0] == pytest.approx(ticks * TICK)


def test_settling_is_of_the_next_motion_only() -> None:
    run = runs("COARSE\nMOVE a\nBREAK\nMOVE b\nBREAK\nSIGNAL 1")
    on = run.events[-1].time_s
    assert on - ended(run)[1] == pytest.approx(3 * TICK)


def test_integration_is_accepted_and_changes_nothing() -> None:
    plain, integrated = runs("MOVE a"), runs("INTON ALWAYS\nMOVE a\nINTOFF")
    assert lasting(plain) == lasting(integrated)


def test_single_keeps_the_wrist_within_half_a_turn() -> None:
    start = "MOVE #PPOINT(0,-45,135,0,60,200)\nBREAK\nSET p = HERE\n"
    for setting, beyond in (("", True), ("SINGLE ALWAYS\n", False), ("SINGLE\n", False)):
        run = runs(f"{start}{setting}MOVE p")
        turned = max(abs(math.degrees(run.motions[-1].goal[k])) for k in (3, 5))
        assert (turned > 180.001) is beyond
    run = runs(f"{start}SINGLE ALWAYS\nMULTIPLE\nMOVE p")
    assert math.degrees(run.motions[-1].goal[5]) == pytest.approx(200.0)


def test_speed_tells_the_speeds() -> None:
    run = runs(
        "SPEED 60 ALWAYS\nSPEED 20\nTYPE SPEED(1), SPEED(2), SPEED(3)\nMOVE a\n"
        "TYPE SPEED(3)\nSPEED 300 MMPS\nTYPE SPEED(3)",
        scenario=Scenario(monitor_speed=80.0),
    )
    assert run.output.split() == ["80", "60", "20", "60", "300"]
