"""Faults put into LinuxCNC's configuration: what robots they make, and what their logs show."""

import re
import tempfile
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import NamedTuple

import numpy as np
import pytest

from tests.unit.dispatch.rehearsing.test_rehearsals import PROGRAMS, SPEED
from vrts.base.units import DEG, MM
from vrts.dispatch.linuxcnc.export import exported_folder
from vrts.dispatch.rehearsing import place
from vrts.dispatch.rehearsing.installed import installed
from vrts.dispatch.rehearsing.rehearse import expected
from vrts.dispatch.rehearsing.running import rehearsed
from vrts.dispatch.rehearsing.samples import STEP_S, Samples, read_samples
from vrts.engine.run import Run
from vrts.pipeline.compiling.reading import ProgramFile
from vrts.pipeline.request import Request
from vrts.pipeline.settings import setting_for
from vrts.validate.identify.causes import Cause, Kind
from vrts.validate.log.log import RobotLog

WHAT = installed()
EVERY = 4  # samples: a row each 4 ms
BEFORE = 100  # samples, from the first motion on
NOISE, STEP = 0.01 * DEG, 0.005 * DEG


class Changed(NamedTuple):
    """A text of the exported folder with another number in it."""

    file: str
    pattern: str  # of which the first group stays
    by: Callable[[float], float]


@dataclass(frozen=True)
class Case:
    """What is wrong in LinuxCNC's configuration, and what has to be found."""

    name: str
    cause: Cause
    true: float
    changes: tuple[Changed, ...] = ()
    zero: tuple[int, float] | None = None  # joint and what its encoder counts too much [rad]
    program: str = "01-stops"
    slow: float = 0.0  # by which share the clock of what writes the log is slow


SETUP, INI, HAL = "library/v_setup.ngc", "machine.ini", "machine.hal"


def times(factor: float) -> Callable[[float], float]:
    def by(value: float) -> float:
        return value * factor

    return by


def plus(more: float) -> Callable[[float], float]:
    def by(value: float) -> float:
        return value + more

    return by


def always(number: float) -> Callable[[float], float]:
    def by(value: float) -> float:
        return number

    return by


def scaled(name: str, factor: float) -> Changed:
    return Changed(SETUP, rf"({re.escape(name)} = )([\d.]+)", times(factor))


def speeds(factor: float, joints: tuple[int, ...], *, lines: bool) -> tuple[Changed, ...]:
    found = [scaled(f"#{196 + joint}", factor) for joint in joints]
    if lines:
        found.append(scaled("#<_v_linear>", factor))
    if lines and joints:
        found.append(scaled("#<_v_angular>", factor))
    return tuple(found)


def link(name: str, dh: str, by_mm: float) -> tuple[Changed, ...]:
    """Return another link in the subroutines and in the kinematics; a3 has another sign there."""
    sign = -1.0 if name == "a3" else 1.0
    # [-20.32] in the subroutines is 20.32 in Craig's convention
    return (
        Changed(SETUP, rf"(#<_v_{name}> = )\[?(-?[\d.]+)\]?", plus(by_mm)),
        Changed(HAL, rf"(genserkins\.{dh} )([\d.]+)", plus(sign * by_mm)),
    )


def acceleration(seconds: float) -> tuple[Changed, ...]:
    return (
        Changed(SETUP, r"(#<_v_tacc> = )([\d.]+)", always(seconds)),
        Changed(SETUP, r"(#<_v_half> = )([\d.]+)", always(seconds)),
    )


def period(ns: int) -> tuple[Changed, ...]:
    return (Changed(INI, r"(SERVO_PERIOD = )(\d+)", always(ns)),)


ALL = tuple(range(6))
# A fault of LinuxCNC's period needs programs that stop: set points of rounded motions are whole
# periods, whatever a period is, and so are samples, so a log of such motions has no fault. In
# ROUNDED it is the clock of what writes the log that is slow or fast.
STOPS, CORNERS, TURNING, LOOPS = "01-stops", "02-corners", "03-turning", "04-loops"
CALLS, FRAMES, BRANCHES, NESTED = "05-calls", "06-frames", "10-branches", "12-nested"
ZEROS = (0.5, CALLS), (-0.3, LOOPS), (0.5, STOPS), (0.4, BRANCHES), (0.3, TURNING), (-0.5, FRAMES)
CASES = [
    *(
        Case(
            f"zero of joint {k + 1}",
            Cause(Kind.ZERO, k),
            by * DEG,
            zero=(k, by * DEG),
            program=program,
        )
        for k, (by, program) in enumerate(ZEROS)
    ),
    Case(
        "link a2", Cause(Kind.COUNTED_LINK, 0, "a2"), 2 * MM, link("a2", "A-2", 2.0), program=CALLS
    ),
    Case(
        "link d4",
        Cause(Kind.COUNTED_LINK, 0, "d4"),
        -1.5 * MM,
        link("d4", "D-3", -1.5),
        program=STOPS,
    ),
    Case(
        "link d2", Cause(Kind.COUNTED_LINK, 0, "d2"), 1 * MM, link("d2", "D-2", 1.0), program=LOOPS
    ),
    Case(
        "link a3",
        Cause(Kind.COUNTED_LINK, 0, "a3"),
        2 * MM,
        link("a3", "A-3", 2.0),
        program=BRANCHES,
    ),
    Case("speeds -8 %", Cause(Kind.SPEEDS), -0.08, speeds(0.92, ALL, lines=True), program=STOPS),
    Case("speeds +6 %", Cause(Kind.SPEEDS), 0.06, speeds(1.06, ALL, lines=True), program=STOPS),
    Case("speeds -15 %", Cause(Kind.SPEEDS), -0.15, speeds(0.85, ALL, lines=True), program=CORNERS),
    Case("lines -10 %", Cause(Kind.LINE_SPEED), -0.1, speeds(0.9, (), lines=True), program=STOPS),
    Case(
        "joint 1 -25 %",
        Cause(Kind.SPEED, 0),
        -0.25,
        speeds(0.75, (0,), lines=False),
        program=STOPS,
    ),
    Case("acceleration 280 ms", Cause(Kind.ACCELERATION), 0.056, acceleration(0.28), program=STOPS),
    Case(
        "acceleration 168 ms",
        Cause(Kind.ACCELERATION),
        -0.056,
        acceleration(0.168),
        program=STOPS,
    ),
    Case("clock 990 us", Cause(Kind.RATE), -0.01, period(990_000), program=FRAMES),
    Case("clock 995 us", Cause(Kind.RATE), -0.005, period(995_000), program=CALLS),
    Case("clock 1008 us", Cause(Kind.RATE), 0.008, period(1_008_000), program=LOOPS),
]


def slow(share: float, program: str) -> Case:
    name = f"log {'slow' if share > 0.0 else 'fast'} {abs(share):.1%}"
    return Case(name, Cause(Kind.RATE), share, program=program, slow=share)


ROUNDED = [
    slow(0.005, CORNERS),
    slow(-0.008, NESTED),
    slow(0.003, NESTED),
    Case(
        "acceleration 168 ms",
        Cause(Kind.ACCELERATION),
        -0.056,
        acceleration(0.168),
        program=CORNERS,
    ),
    Case(
        "acceleration 280 ms", Cause(Kind.ACCELERATION), 0.056, acceleration(0.28), program=CORNERS
    ),
    Case(
        "acceleration 280 ms", Cause(Kind.ACCELERATION), 0.056, acceleration(0.28), program=NESTED
    ),
    Case("speeds +6 %", Cause(Kind.SPEEDS), 0.06, speeds(1.06, ALL, lines=True), program=NESTED),
    Case("lines -10 %", Cause(Kind.LINE_SPEED), -0.1, speeds(0.9, (), lines=True), program=NESTED),
    Case(
        "zero of joint 2",
        Cause(Kind.ZERO, 1),
        0.2 * DEG,
        zero=(1, 0.2 * DEG),
        program=CORNERS,
    ),
    Case(
        "link d4",
        Cause(Kind.COUNTED_LINK, 0, "d4"),
        1.5 * MM,
        link("d4", "D-3", 1.5),
        program=NESTED,
    ),
]
"""Programs with rounded corners: eight and eleven of them."""


def carried_out(case: Case) -> tuple[Run, Samples]:
    """Return the run without the fault, and what LinuxCNC did with it."""
    assert not isinstance(WHAT, str)
    program = PROGRAMS / case.program / "program.v2"
    setting = setting_for(program)
    assert setting is not None
    found = exported_folder(Request(ProgramFile(program.read_bytes(), program.name), setting), None)
    assert found.files is not None
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for file, data in found.files.items():
            (folder / file).parent.mkdir(parents=True, exist_ok=True)
            (folder / file).write_bytes(data)
        run = expected(folder)
        for change in case.changes:
            changed(folder / change.file, change)
        with pytest.MonkeyPatch.context() as patch:
            if case.zero is not None:
                patch.setattr(place, "PINS", encoder(*case.zero))
            outcome = rehearsed(folder, run, WHAT, SPEED)
    assert outcome.errors == (), outcome.errors
    return run, read_samples(outcome.samples)


def changed(path: Path, change: Changed) -> None:
    text = path.read_text()
    found = re.search(change.pattern, text)
    assert found, change.pattern
    new = f"{found[1]}[{change.by(float(found[2])):.10g}]"
    if change.file != SETUP:
        new = new.replace("[", "").replace("]", "")
    path.write_text(text[: found.start()] + new + text[found.end() :])


def encoder(joint: int, by: float) -> tuple[str, ...]:
    """Return HAL's pins with an encoder that counts too much."""
    pins = [pin for pin in place.PINS if f"joint.{joint}." not in pin]
    return (
        *("loadrt scale count=1", "addf scale.0 servo-thread -2", "setp scale.0.gain 1"),
        f"setp scale.0.offset {by / DEG:.9f}",
        f"net counted joint.{joint}.pos-cmd => scale.0.in",
        f"net c{joint} scale.0.out => sampler.0.pin.{joint}",
        *pins,
    )


def log_of(samples: Samples, seed: int, slow: float = 0.0) -> RobotLog:
    """Return the log with an encoder's steps and noise, by a clock that may be slow."""
    first = max(int((samples.motions > 0).argmax()) - BEFORE, 0)
    joints = samples.joints[first::EVERY]
    noise = np.random.default_rng(seed).normal(0.0, NOISE, joints.shape)
    told = np.round((joints + noise) / STEP) * STEP
    times = STEP_S * EVERY / (1.0 + slow) * np.arange(len(told), dtype=np.float64)
    return RobotLog("linuxcnc.csv", "0" * 64, times, told, None, synthetic=False, findings=())
