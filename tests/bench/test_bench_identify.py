"""What is put into LinuxCNC's configuration is found in its log; and how honest intervals are."""

import os
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
import pytest

from tests.unit.dispatch.rehearsing.faulty import (
    CASES,
    NOISE,
    ROUNDED,
    STEP,
    WHAT,
    Case,
    carried_out,
    log_of,
)
from tests.unit.validate.support import run_of, turning_run
from vrts.base.units import DEG, MM
from vrts.validate.identify.again import Again
from vrts.validate.identify.causes import Cause, Kind
from vrts.validate.identify.forward import Clock, Rows, residuals
from vrts.validate.identify.identified import Identified
from vrts.validate.identify.identify import identify_again, identify_log
from vrts.validate.identify.noise import covariance, left_over, resolution
from vrts.validate.identify.solve import clock_columns, columns, solve
from vrts.validate.identify.ticks import in_even_ticks
from vrts.validate.log.log import RobotLog
from vrts.validate.reports.identified_text import sentence

SIMULATIONS = int(os.environ.get("VRTS_SIMULATIONS", "1000"))
ONLY = os.environ.get("VRTS_CASES", "")


@pytest.mark.skipif(isinstance(WHAT, str), reason="needs LinuxCNC")
def test_faults_of_linuxcnc_are_found_in_its_log() -> None:
    errors, named = looked_at(CASES, 0)
    assert named >= 0.9 * len(errors)
    assert sum(off <= 2.0 for off in errors) >= 0.85 * len(errors)
    assert max(errors) <= 4.0


@pytest.mark.skipif(isinstance(WHAT, str), reason="needs LinuxCNC")
def test_faults_are_found_in_logs_of_programs_with_rounded_corners() -> None:
    errors, named = looked_at(ROUNDED, 1000)
    assert len(errors) >= 5 or ONLY
    assert named == len(errors)
    assert max(errors) <= 4.0


def looked_at(given: Sequence[Case], seed: int) -> tuple[list[float], int]:
    """Return by how many standard errors numbers are off, and how many were named first."""
    cases = [case for case in given if any(one in case.name for one in ONLY.split(","))]
    named = 0
    errors: list[float] = []
    print()
    for number, case in enumerate(cases):
        run, samples = carried_out(case)
        found = identify_log(run, log_of(samples, seed + number, case.slow))
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
    return errors, named


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
                found[Cause(kind)] = sign * size * 0.04
    return found


def tells(again: Again, true: dict[Cause, float]) -> bool:
    """Whether the log changes with every cause: a joint that never needs longest tells nothing."""
    ends = [m.end_s for m in again.with_values(true).motions]
    for cause in true:
        if cause.by_ticks:
            without = again.with_values({c: v for c, v in true.items() if c != cause})
            if [m.end_s for m in without.motions] == ends:
                return False
    return True


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


class Seen(NamedTuple):
    """A number that was put into a simulation, and what was found."""

    kind: Kind
    numbers: int  # so many were put in
    held: bool | None  # by its interval; None: its cause was not named
    off: float  # of its value, in standard errors


@pytest.mark.parametrize(
    ("name", "kinds"), [("smooth", SMOOTH), ("by ticks", TICKS)], ids=["smooth", "ticks"]
)
def test_intervals_hold_what_they_say_where_causes_are_chosen(
    name: str, kinds: tuple[Kind, ...]
) -> None:
    """The whole of `identify`: what causes there are is found out, too, from the log alone.

    Told: how often exactly the causes were named that were put in, and how many intervals of 95 %
    hold the number that was put in, of all that were named rightly. What a controller counts in
    even ticks is what it carries out: no share can be asked of that, for it is right or not.
    """
    again = Again(run_of(SHORT.encode()), kept=5000)
    seen: list[Seen] = []
    exact = more = less = 0
    print()
    for number in range(SIMULATIONS):
        chance = np.random.default_rng((21, number))
        true = drawn(chance, kinds)
        while not tells(again, true):
            true = drawn(chance, kinds)
        found = identify_again(again, simulated(again, true, chance))
        named = {n.cause: n for n in found.numbers}
        # both ways of leading servos are one cause, told within one interval
        named = {Cause(c.kind) if c.kind is Kind.LAG else c: n for c, n in named.items()}
        exact += named.keys() == true.keys()
        more += bool(named.keys() - true.keys())
        less += bool(true.keys() - named.keys())
        for cause, put in true.items():
            value = put
            if cause.kind is Kind.ACCELERATION:
                value = in_even_ticks(again, cause, put)
            it = named.get(cause)
            held = None if it is None else it.low <= value <= it.high
            off = 0.0 if it is None else (it.value - value) / max(it.half / 1.96, 1e-15)
            seen.append(Seen(cause.kind, len(true), held, off))
        if number % 50 == 49 or number == SIMULATIONS - 1:
            print(
                f"{name}: {number + 1} simulations, exactly named {exact}, with another {more},"
                f" without one {less}; covered {share_of(seen, kinds)}",
                flush=True,
            )
    for kind in kinds:
        one = [s for s in seen if s.kind is kind]
        spread = np.sqrt(np.mean([s.off**2 for s in one if s.held is not None] or [0.0]))
        print(f"  {kind.value:13} put in {len(one):4}, covered {share_of(one, (kind,))}", end="")
        print(f", errors {spread:.2f} of what is claimed")
    for count in (1, 2):
        print(f"  {count} at once: {share_of([s for s in seen if s.numbers == count], kinds)}")
    told = [s.held for s in seen if s.held is not None and s.kind is not Kind.ACCELERATION]
    low, high = (0.93, 0.97) if SIMULATIONS >= 1000 else (0.90, 1.0)
    assert low <= sum(told) / len(told) <= high
    assert exact >= 0.9 * SIMULATIONS


def share_of(seen: Sequence[Seen], kinds: tuple[Kind, ...]) -> str:
    """Return how many intervals held the number, of those whose cause was named."""
    whole = Kind.ACCELERATION if len(kinds) > 1 else None
    told = [s.held for s in seen if s.held is not None and s.kind in kinds and s.kind is not whole]
    return f"{sum(told)} of {len(told)} ({sum(told) / max(len(told), 1):.3f})"
