"""The faults of a robot from its log: read, fitted cause by cause, and judged."""

from itertools import combinations

import numpy as np
import numpy.typing as npt

from vrts.base.units import DEG, MM
from vrts.engine.run import Run
from vrts.validate.clock import clock_shift
from vrts.validate.comparison import log_must_move, must_move, no_instant_in_common
from vrts.validate.identify.again import Again
from vrts.validate.identify.causes import Cause, Kind, causes_for
from vrts.validate.identify.choose import Choice, choose, explained
from vrts.validate.identify.forward import rows_of
from vrts.validate.identify.identified import Identified, Number, Remaining
from vrts.validate.identify.noise import covariance, lasting, left_over
from vrts.validate.identify.solve import clock_columns, columns, solve
from vrts.validate.log.log import GivenLog, RobotLog, read_log
from vrts.validate.sampling import extent_of

Array = npt.NDArray[np.float64]

NORMAL = 1.96  # standard deviations: 95 %
FEWEST = 20  # rows
SAME = 0.9995  # cosine between what two numbers change: they cannot be told apart
USELESS = {  # an interval wider than this says nothing
    Kind.ZERO: 1.0 * DEG,
    Kind.HIDDEN_ZERO: 1.0 * DEG,
    Kind.TURN: 1.0 * DEG,
    Kind.LINK: 10.0 * MM,
    Kind.COUNTED_LINK: 10.0 * MM,
    Kind.TOOL: 10.0 * MM,
    Kind.BASE: 10.0 * MM,
    Kind.RATE: 0.05,
    Kind.LAG: 0.1,
}


def identify(run: Run, given: GivenLog) -> Identified:
    """Return what is wrong with the robot that made a log of a program.

    Args:
        run: The program, run with the numbers that are assumed.
        given: The log.

    Raises:
        Refused: The program or the log tells nothing.
    """
    must_move(run)
    return identify_log(run, read_log(given, extent_of(run)))


def identify_log(run: Run, log: RobotLog) -> Identified:
    """Return what is wrong with the robot that made a log that was read."""
    return identify_again(Again(run), log)


def identify_again(again: Again, log: RobotLog) -> Identified:
    """Return the same of a program that other logs were compared with before."""
    log_must_move(log)
    run = again.run
    rows = rows_of(run, log, clock_shift(run, log))
    if len(rows.times) < FEWEST:
        raise no_instant_in_common()
    found = choose(again, log, rows)
    numbers, clock_half = _numbers(again, found)
    silent, pairs = _untold(again, found)
    first = float(found.fit.clock.shifts[0])
    rate = found.fit.values.get(Cause(Kind.RATE), 0.0)
    return Identified(
        run.scene.robot.arm,
        numbers,
        first + rate * float(rows.times[0] - rows.middle_s),
        clock_half,
        not found.fit.clock.whole,
        _remaining(found),
        explained(found),
        silent,
        pairs,
        len(rows.times),
        log.name,
        log.sha256,
        log.synthetic,
        log.findings,
        run.scene.controller.name,
    )


def _numbers(again: Again, found: Choice) -> tuple[tuple[Number, ...], float]:
    fit = found.fit
    causes = tuple(dict.fromkeys(c for one in found.chosen for c in one.group))
    smooth = [c for c in causes if not c.by_ticks]
    J = np.concatenate(
        (
            clock_columns(again, found.rows, fit.clock, fit.values),
            columns(again, found.rows, fit.clock, fit.values, smooth),
        ),
        axis=2,
    )
    left = left_over(fit.residual, found.least)
    spread = np.sqrt(np.clip(np.diag(covariance(J, left.rms, left.times_correlated)), 0.0, None))
    spread *= lasting(J, fit.residual, left)
    shifts = len(fit.clock.shifts)
    halves = dict(zip(smooth, (NORMAL * spread[shifts:]).tolist(), strict=True))
    alike = {
        c: tuple(g for g in one.alike if not g[0].kind is c.kind is Kind.LAG)
        for one in found.chosen
        for c in one.group
    }
    numbers: list[Number] = []
    for cause in causes:
        value = fit.values[cause]
        if cause.by_ticks:
            span = found.between[cause]
            numbers.append(Number(cause, span.value, span.low, span.high, alike[cause]))
        else:
            half = halves[cause]
            low, high = _other_lag(again, found, cause, value)
            numbers.append(Number(cause, value, low - half, high + half, alike[cause]))
    return tuple(numbers), NORMAL * float(spread[0])


def _other_lag(again: Again, found: Choice, cause: Cause, value: float) -> tuple[float, float]:
    """Return between what a number lies, by both ways of leading servos if the log allows both."""
    other = Cause(Kind.LAG, 1 - cause.place)
    allowed = {c for one in found.chosen if cause in one.group for g in one.alike for c in g}
    if cause.kind is not Kind.LAG or other not in allowed:
        return value, value
    values = {(other if c == cause else c): v for c, v in found.fit.values.items()}
    fit = solve(again, found.rows, found.fit.clock, values, tuple(values), found.least)
    return min(value, fit.values[other]), max(value, fit.values[other])


def _untold(
    again: Again, found: Choice
) -> tuple[tuple[Cause, ...], tuple[tuple[Cause, Cause], ...]]:
    """Return numbers of which a log says nothing, and pairs that it cannot tell apart."""
    fit, rows = found.fit, found.rows
    groups = causes_for(
        again.run.scene.robot.arm,
        joints=rows.joints is not None,
        positions=rows.positions is not None,
        decide=(),
    )
    lags = any(cause.kind is Kind.LAG for cause in fit.values)  # known: the other is no question
    causes = [group[0] for group in groups if len(group) == 1 and group[0] != Cause(Kind.LAG, 1)]
    causes = [cause for cause in causes if cause.kind is not Kind.LAG or not lags]
    sigma = left_over(fit.residual, found.least).rms
    clock = clock_columns(again, rows, fit.clock, fit.values) / sigma[:, None]
    J = columns(again, rows, fit.clock, fit.values, causes) / sigma[:, None]
    A, all_rows = clock.reshape(-1, clock.shape[2]), J.reshape(-1, len(causes))
    beside = all_rows - A @ (np.linalg.pinv(A) @ all_rows)
    size = np.sqrt((beside**2).sum(axis=0))
    silent = [c for c, one in zip(causes, size.tolist(), strict=True) if one * USELESS[c.kind] < 2]
    seen = [k for k, cause in enumerate(causes) if cause not in silent]
    unit = beside[:, seen] / size[seen]
    cosines = unit.T @ unit
    pairs = [
        (causes[seen[a]], causes[seen[b]])
        for a, b in combinations(range(len(seen)), 2)
        if abs(float(cosines[a, b])) > SAME
    ]
    return tuple(silent), tuple(pairs)


def _remaining(found: Choice) -> tuple[Remaining, ...]:
    names: list[str] = []
    if found.rows.joints is not None:
        names += [f"JT{k}" for k in range(1, 7)]
    if found.rows.positions is not None:
        names += list("XYZ")
    before = np.sqrt((found.first.residual**2).mean(axis=0)).tolist()
    after = np.sqrt((found.fit.residual**2).mean(axis=0)).tolist()
    left = left_over(found.fit.residual, found.least)
    return tuple(
        Remaining(*one)
        for one in zip(
            names, before, after, left.patterned.tolist(), found.least.tolist(), strict=True
        )
    )
