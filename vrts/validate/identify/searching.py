"""Numbers that work through ticks, looked for beside those that were chosen."""

from collections.abc import Callable, Mapping, Sequence
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from vrts.engine.run import Run
from vrts.validate.clock import clock_shift
from vrts.validate.identify.again import KEPT, Again
from vrts.validate.identify.causes import Cause, Kind
from vrts.validate.identify.clocks import moved
from vrts.validate.identify.forward import Clock, Rows, residuals
from vrts.validate.identify.solve import Fit, objective, solve
from vrts.validate.identify.ticks import (
    CENTRAL,
    Between,
    Weighs,
    between,
    grid_of,
    in_even_ticks,
    search,
)
from vrts.validate.log.log import RobotLog

Array = npt.NDArray[np.float64]

WIDE = 0.08  # a number that works through ticks lies within this share of the best


class Shifts:
    """Where runs lie in a log by their speeds; what was asked before is remembered."""

    def __init__(self, log: RobotLog) -> None:
        """Take the log."""
        self._log = log
        self._known: dict[int, tuple[Run, float]] = {}

    def of(self, run: Run) -> float:
        """Return what to add to times of the log [s]."""
        if id(run) not in self._known:
            if len(self._known) >= KEPT:
                self._known = {}
            self._known[id(run)] = run, clock_shift(run, self._log)
        return self._known[id(run)][1]


class Search(NamedTuple):
    """What causes are looked for in."""

    again: Again
    shifts: Shifts
    rows: Rows
    few: Rows  # some of them
    least: Array  # what rounding makes, of every channel
    clock: Clock  # of the run with the numbers that are assumed
    decide: tuple[Cause, ...]  # numbers that work through ticks and that the run depends on


def weighed(
    s: Search, rows: Rows, fit: Fit, values: Mapping[Cause, float], causes: Sequence[Cause], n: int
) -> Fit:
    """Return a fit with given values of numbers that work through ticks, the clock found anew."""
    run = s.again.with_values(values)
    least = s.least[: rows.channels]
    if s.clock.whole:
        clock = Clock(np.array([s.shifts.of(run)]), np.zeros(len(rows.times), np.intp))
        near = Clock(fit.clock.shifts, clock.which)
        off = [objective(residuals(s.again, rows, c, values), least) for c in (clock, near)]
        begin = clock if off[0] < off[1] else near
        return solve(s.again, rows, begin, values, causes, least, n)
    before = s.again.with_values(fit.values)
    clock = moved(fit.clock, before, run)
    at = np.searchsorted(s.rows.times, rows.times)
    placed = Clock(clock.shifts, clock.which[at])
    return solve(s.again, rows, placed, values, causes, least, n)


def searched(s: Search, fit: Fit, cause: Cause) -> float:
    """Return what a number gains, about."""
    begun = weighed(s, s.few, fit, fit.values, (), 1).objective
    _, reached = looked_for(s, fit, cause)
    return len(s.rows.times) / len(s.few.times) * (begun - reached)


def looked_for(s: Search, fit: Fit, cause: Cause) -> tuple[float, float]:
    """Return the best value of a number, and its objective on some of the rows."""
    now = fit.values.get(cause, 0.0)
    weighs = _by_runs(s, fit, cause, lambda v: weighed(s, s.few, fit, v, (), 3).objective)
    return search(sorted({now, *grid_of(s.again, cause)}), weighs)


def refined(s: Search, fit: Fit, cause: Cause, causes: Sequence[Cause]) -> Fit:
    """Return a fit with one number looked for near where it is."""
    now = fit.values[cause]
    reach = _reach(s, cause)
    weighs = _by_runs(s, fit, cause, lambda v: weighed(s, s.few, fit, v, (), 2).objective)
    value, _ = search([*np.linspace(now - reach, now + reach, 9).tolist(), now], weighs)
    other = weighed(s, s.rows, fit, {**fit.values, cause: value}, causes, 5)
    return other if other.objective < fit.objective else fit


def spans_of_ticks(
    s: Search, fit: Fit, causes: Sequence[Cause]
) -> tuple[dict[Cause, Between], Fit]:
    """Return what the log allows of numbers that work through ticks, and the fit with them.

    What changes the log smoothly is fitted anew for each value.
    """
    found: dict[Cause, Between] = {}
    smooth = tuple(cause for cause in causes if not cause.by_ticks)
    for cause in causes:
        if cause.by_ticks:
            span = _span(s, fit, cause, smooth)
            found[cause] = span
            fit = fit._replace(values={**fit.values, cause: span.value})
    return found, fit


def _span(s: Search, fit: Fit, cause: Cause, smooth: Sequence[Cause]) -> Between:
    weighs = _by_runs(s, fit, cause, lambda v: weighed(s, s.rows, fit, v, smooth, 3).objective)
    best = fit.values[cause]
    span = between(best, weighs(best), _reach(s, cause), weighs)
    if cause.kind not in (Kind.ACCELERATION, Kind.CORNERS):
        return span
    # told as it is carried out, in even ticks; half of one to either side is as near
    half = CENTRAL * s.again.run.scene.robot.arm.tick
    value, *ends = (in_even_ticks(s.again, cause, v) for v in (best, span.low, span.high))
    return Between(value, min(ends) - half, max(ends) + half, span.objective)


def _reach(s: Search, cause: Cause) -> float:
    if cause.kind in (Kind.ACCELERATION, Kind.CORNERS):
        return 2.0 * s.again.run.scene.robot.arm.tick
    return WIDE


def _by_runs(
    s: Search, fit: Fit, cause: Cause, weighs: Callable[[Mapping[Cause, float]], float]
) -> Weighs:
    """Return what weighs one number; values with which the run is the same are weighed once."""
    known: dict[int, tuple[Run, float]] = {}

    def of(value: float) -> float:
        values = {**fit.values, cause: value}
        run = s.again.with_values(values)
        if id(run) not in known:
            known[id(run)] = run, weighs(values)
        return known[id(run)][1]

    return of
