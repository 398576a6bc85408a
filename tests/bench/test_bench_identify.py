"""What is put into LinuxCNC's configuration is found in its log; and how honest intervals are."""

import os
import re
import tempfile
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import NamedTuple

import numpy as np
import pytest

from tests.unit.dispatch.rehearsing.test_rehearsals import PROGRAMS, SPEED
from tests.unit.validate.support import run_of, turning_run
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
from vrts.validate.identify.again import Again
from vrts.validate.identify.causes import Cause, Kind
from vrts.validate.identify.forward import Clock, Rows, residuals
from vrts.validate.identify.identified import Identified
from vrts.validate.identify.identify import identify_log
from vrts.validate.identify.noise import covariance, left_over, resolution
from vrts.validate.identify.solve import clock_columns, columns, solve
from vrts.validate.log.log import RobotLog
from vrts.validate.reports.identified_text import sentence

WHAT = installed()
EVERY = 4  # samples: a row each 4 ms
BEFORE = 100  # samples, from the first motion on
NOISE, STEP = 0.01 * DEG, 0.005 * DEG
SIMULATIONS = int(os.environ.get("VRTS_SIMULATIONS", "1000"))
ONLY = os.environ.get("VRTS_CASES", "")


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
STOPS, CORNERS, TURNING, LOOPS = "01-stops", "02-corners", "03-turning", "04-loops"
CALLS, FRAMES, BRANCHES, SPEEDS = "05-calls", "06-frames", "10-branches", "11-speeds"
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
    Case("speeds +6 %", Cause(Kind.SPEEDS), 0.06, speeds(1.06, ALL, lines=True), program=CALLS),
    Case("speeds -15 %", Cause(Kind.SPEEDS), -0.15, speeds(0.85, ALL, lines=True), program=LOOPS),
    Case("lines -10 %", Cause(Kind.LINE_SPEED), -0.1, speeds(0.9, (), lines=True), program=TURNING),
    Case(
        "joint 1 -25 %",
        Cause(Kind.SPEED, 0),
        -0.25,
        speeds(0.75, (0,), lines=False),
        program=BRANCHES,
    ),
    Case(
        "acceleration 280 ms", Cause(Kind.ACCELERATION), 0.056, acceleration(0.28), program=FRAMES
    ),
    Case(
        "acceleration 168 ms", Cause(Kind.ACCELERATION), -0.056, acceleration(0.168), program=STOPS
    ),
    Case("clock 990 us", Cause(Kind.RATE), -0.01, period(990_000), program=CORNERS),
    Case("clock 995 us", Cause(Kind.RATE), -0.005, period(995_000), program=CALLS),
    Case("clock 1008 us", Cause(Kind.RATE), 0.008, period(1_008_000), program=SPEEDS),
]


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


def log_of(samples: Samples, seed: int) -> RobotLog:
    """Return the log with an encoder's steps and noise."""
    first = max(int((samples.motions > 0).argmax()) - BEFORE, 0)
    joints = samples.joints[first::EVERY]
    noise = np.random.default_rng(seed).normal(0.0, NOISE, joints.shape)
    told = np.round((joints + noise) / STEP) * STEP
    times = STEP_S * EVERY * np.arange(len(told), dtype=np.float64)
    return RobotLog("linuxcnc.csv", "0" * 64, times, told, None, synthetic=False, findings=())


@pytest.mark.skipif(isinstance(WHAT, str), reason="needs LinuxCNC")
def test_faults_of_linuxcnc_are_found_in_its_log() -> None:
    cases = [case for case in CASES if ONLY in case.name]
    named = 0
    errors: list[float] = []
    for seed, case in enumerate(cases):
        run, samples = carried_out(case)
        found = identify_log(run, log_of(samples, seed))
        first = bool(found.numbers) and found.numbers[0].cause == case.cause
        named += first
        off = _errors_off(found, case)
        errors.append(off)
        print(
            f"{case.name:20} {case.program:12} {off:6.2f} standard errors"
            f"  {'first' if first else 'NOT FIRST'}  {sentence(found)}",
            flush=True,
        )
    print(
        f"{len(cases)} cases: named first {named}, within two standard errors"
        f" {sum(off <= 2.0 for off in errors)}, within four {sum(off <= 4.0 for off in errors)}"
    )
    assert named >= 0.9 * len(cases)
    assert sum(off <= 2.0 for off in errors) >= 0.85 * len(cases)
    assert max(errors) <= 4.0


def _errors_off(found: Identified, case: Case) -> float:
    """Return by how many standard errors the number is off; infinite where it was not found."""
    for number in found.numbers:
        if number.cause == case.cause:
            return abs(number.value - case.true) / max(number.half / 1.96, 1e-12)
    return float("inf")


COVERED: tuple[tuple[str, dict[Cause, float], float], ...] = (
    ("joint zero, rate", {Cause(Kind.ZERO, 2): 0.2 * DEG, Cause(Kind.RATE): 1e-3}, 0.0),
    ("joint zero, lag", {Cause(Kind.ZERO, 1): 0.1 * DEG, Cause(Kind.LAG): 0.02}, 0.0),
    ("two zeros, errors alike", {Cause(Kind.ZERO, k): 0.1 * DEG for k in (0, 4)}, 0.5),
    ("tool, base", {Cause(Kind.TOOL, 2): 1 * MM, Cause(Kind.BASE, 1): 1 * MM}, 0.0),
)


@pytest.mark.parametrize(("name", "true", "alike"), COVERED, ids=[c[0] for c in COVERED])
def test_intervals_hold_what_they_say(name: str, true: dict[Cause, float], alike: float) -> None:
    """Of intervals of 95 %, 93 to 97 of a hundred cover the number that was put in.

    The causes are given here, and the clock is fitted with them. Errors of rows beside one another
    may be alike (`alike` is their correlation); tool positions are measured to 0.1 mm.
    """
    again, chance = Again(turning_run()), np.random.default_rng(20)
    times = np.arange(-0.5, again.run.horizon_s + 0.5, 0.028)
    clock = Clock(np.array([0.0]), np.zeros(len(times), np.intp))
    middle = float(0.5 * (times[0] + times[-1]))
    zeros = np.zeros((len(times), 3))
    exact = Rows(times, np.zeros((len(times), 6)), zeros, middle)
    joints = -residuals(again, exact, clock, true)[:, :6]
    covered = dict.fromkeys(true, 0)
    for _ in range(SIMULATIONS):
        noise = chance.normal(0.0, NOISE, joints.shape)
        for k in range(1, len(noise)):
            noise[k] = alike * noise[k - 1] + np.sqrt(1.0 - alike**2) * noise[k]
        told = np.round((joints + noise) / STEP) * STEP
        shown = -residuals(again, Rows(times, told, zeros, middle), clock, true)[:, 6:]
        rows = Rows(times, told, shown + chance.normal(0.0, 0.1 * MM, shown.shape), middle)
        least = resolution(rows.measured())
        fit = solve(again, rows, clock, true, tuple(true), least)
        J = np.concatenate(
            (
                clock_columns(again, rows, fit.clock, fit.values),
                columns(again, rows, fit.clock, fit.values, tuple(true)),
            ),
            axis=2,
        )
        left = left_over(fit.residual, least)
        spread = np.sqrt(np.diag(covariance(J, left.rms, left.times_correlated)))[1:]
        for (cause, value), one in zip(true.items(), spread.tolist(), strict=True):
            covered[cause] += abs(fit.values[cause] - value) <= 1.96 * one
    shares = {f"{c.kind.value} {c.place}": n / SIMULATIONS for c, n in covered.items()}
    print(f"\n{name}: {SIMULATIONS} simulations, covered {shares}", flush=True)
    assert all(0.93 <= share <= 0.97 for share in shares.values())


SMOOTH = (Kind.ZERO, Kind.TOOL, Kind.BASE, Kind.TURN, Kind.HIDDEN_ZERO, Kind.RATE, Kind.LAG)
TICKS = (Kind.SPEEDS, Kind.SPEED, Kind.ACCELERATION)
SHORT = """\
.PROGRAM short
  SPEED 60 ALWAYS
  MOVE #a
  BREAK
  MOVE #b
  BREAK
  MOVE #c
.END
.LOCATIONS
#a 0 -60 60 0 30 0
#b 50 -80 40 60 60 90
#c -40 -40 70 -50 -60 -120
.END
"""


def drawn(chance: np.random.Generator, kinds: tuple[Kind, ...]) -> dict[Cause, float]:
    """Return one cause, or two, with a size that a log of this noise tells well."""
    found: dict[Cause, float] = {}
    for kind in chance.choice(np.array(kinds, dtype=object), 1 + int(chance.random() < 0.4)):
        sign, size = chance.choice((-1.0, 1.0)), chance.uniform(1.0, 3.0)
        place = int(chance.integers(3 if kind in (Kind.TOOL, Kind.BASE, Kind.TURN) else 6))
        match kind:
            case Kind.ZERO | Kind.HIDDEN_ZERO | Kind.TURN:
                found[Cause(kind, place)] = sign * size * 0.1 * DEG
            case Kind.TOOL | Kind.BASE:
                found[Cause(kind, place)] = sign * size * 0.5 * MM
            case Kind.RATE:
                found[Cause(kind)] = sign * size * 2e-3
            case Kind.LAG:
                found[Cause(kind)] = size * 0.01
            case Kind.SPEED:
                found[Cause(kind, place)] = sign * size * 0.06
            case Kind.SPEEDS:
                found[Cause(kind)] = sign * size * 0.04
            case _:
                found[Cause(kind)] = sign * 0.028 * int(size)
    return found


def simulated(again: Again, true: dict[Cause, float], chance: np.random.Generator) -> RobotLog:
    """Return a log with noise of joints, encoder steps, and positions measured to 0.1 mm."""
    run = again.with_values(true)
    times = np.arange(-0.5, run.horizon_s + 0.5, 0.028)
    clock = Clock(np.array([0.0]), np.zeros(len(times), np.intp))
    middle, zeros = float(0.5 * (times[0] + times[-1])), np.zeros((len(times), 3))
    joints = -residuals(again, Rows(times, np.zeros((len(times), 6)), zeros, middle), clock, true)
    told = joints[:, :6] + chance.normal(0.0, NOISE, (len(times), 6))
    told = np.round(told / STEP) * STEP
    shown = -residuals(again, Rows(times, told, zeros, middle), clock, true)[:, 6:]
    shown += chance.normal(0.0, 0.1 * MM, shown.shape)
    return RobotLog("log", "0" * 64, times, told, shown, synthetic=True, findings=())


@pytest.mark.parametrize(
    ("name", "kinds", "share"), [("smooth", SMOOTH, 1.0), ("by ticks", TICKS, 0.1)]
)
def test_intervals_hold_what_they_say_where_causes_are_chosen(
    name: str, kinds: tuple[Kind, ...], share: float
) -> None:
    """The whole of `identify`: what causes there are is found out, too, from the log alone.

    Told: how often exactly the causes were named that were put in, and how many intervals of 95 %
    hold the number that was put in, of all that were named rightly.
    """
    again, chance = Again(run_of(SHORT.encode())), np.random.default_rng(21)
    count = max(round(share * SIMULATIONS), 1)
    exact = inside = rightly = more = less = 0
    by_kind: dict[str, list[bool]] = {}
    for number in range(count):
        true = drawn(chance, kinds)
        found = identify_log(again.run, simulated(again, true, chance))
        named = {n.cause: n for n in found.numbers}
        # both ways of leading servos are one cause, told within one interval
        named = {Cause(c.kind) if c.kind is Kind.LAG else c: n for c, n in named.items()}
        exact += named.keys() == true.keys()
        more += bool(named.keys() - true.keys())
        less += bool(true.keys() - named.keys())
        for cause, value in true.items():
            if cause in named:
                held = named[cause].low <= value <= named[cause].high
                by_kind.setdefault(cause.kind.value, []).append(held)
                inside, rightly = inside + held, rightly + 1
        if number % 50 == 49 or number == count - 1:
            shares = {kind: f"{sum(v)}/{len(v)}" for kind, v in by_kind.items()}
            print(
                f"{name}: {number + 1} simulations, exactly named {exact}, with another {more},"
                f" without one {less}; covered {inside} of {rightly}"
                f" ({inside / max(rightly, 1):.3f}) {shares}",
                flush=True,
            )
    assert inside >= 0.93 * rightly
