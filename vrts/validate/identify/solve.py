"""Least squares over the numbers that change a log smoothly, the clock among them."""

from collections.abc import Callable, Mapping, Sequence
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from vrts.validate.identify.again import Again
from vrts.validate.identify.causes import Cause, Kind
from vrts.validate.identify.forward import (
    Clock,
    Rows,
    frames_of,
    joints_off,
    positions_off,
    residuals,
)
from vrts.validate.sampling import JOINTS

Array = npt.NDArray[np.float64]

CLOCK_STEP_S = 1e-3
LONGEST_STEP_S = 0.2  # by which a clock is moved at once
STEPS, HALVINGS = 12, 5
ENOUGH = 1e-3  # a step that gains less is the last
WEAKEST = 1e-9  # of the strongest direction: what a log tells less about is left as it is
LAST_S = 1e-4  # a lag is no shorter
MEASURES = (Kind.HIDDEN_ZERO, Kind.LINK, Kind.TOOL, Kind.BASE, Kind.TURN)
"""What positions show beside the joints of the same row, and joints do not."""


class Fit(NamedTuple):
    """What fits best."""

    values: Mapping[Cause, float]
    clock: Clock
    residual: Array  # shape (n, channels)
    objective: float  # n times the logarithms of the mean squares, summed over the channels


def objective(residual: Array, least: Array) -> float:
    """Return twice the negative logarithm of the likelihood, but for a constant."""
    return float(len(residual) * np.log((residual**2).mean(axis=0) + least**2).sum())


def clock_columns(again: Again, rows: Rows, clock: Clock, values: Mapping[Cause, float]) -> Array:
    """Return how a log changes with its clock, shape (n, channels, shifts)."""
    ahead = Clock(clock.shifts + CLOCK_STEP_S, clock.which)
    behind = Clock(clock.shifts - CLOCK_STEP_S, clock.which)
    off = residuals if rows.joints is None else joints_off  # where there are both, joints tell
    change = off(again, rows, behind, values) - off(again, rows, ahead, values)
    found = np.zeros((len(rows.times), rows.channels, len(clock.shifts)))
    tell = np.arange(change.shape[1], dtype=np.intp)
    found[np.arange(len(change))[:, None], tell, clock.which[:, None]] = change / (
        2.0 * CLOCK_STEP_S
    )
    return found


def columns(
    again: Again, rows: Rows, clock: Clock, values: Mapping[Cause, float], causes: Sequence[Cause]
) -> Array:
    """Return how a log changes with numbers, shape (n, channels, k)."""
    found = np.zeros((len(rows.times), rows.channels, len(causes)))
    both = rows.joints is not None and rows.positions is not None
    measures = [cause.kind in MEASURES for cause in causes]
    frames = frames_of(again, rows, clock, values) if both and any(measures) else None
    for k, (cause, measure) in enumerate(zip(causes, measures, strict=True)):
        now = values.get(cause, 0.0)
        more, less = now + cause.step, now - cause.step
        if cause.kind is Kind.LAG:
            more, less = max(more, 2.0 * cause.step), max(less, 0.5 * cause.step)
        if cause.kind is Kind.COUNTED_LINK:
            more, less = _same_ticks(again, values, cause)
        channels, off = slice(None), _off(again, rows, clock, frames if measure else None, cause)
        if both:  # joints tell of times, positions of measures
            channels = slice(JOINTS, None) if measure else slice(JOINTS)
        if more > less:
            change = off({**values, cause: less}) - off({**values, cause: more})
            found[:, channels, k] = change / (more - less)
    return found


def _off(
    again: Again, rows: Rows, clock: Clock, frames: tuple[Array, Array] | None, cause: Cause
) -> Callable[[Mapping[Cause, float]], Array]:
    """Return what tells measured minus modelled, of the channels that a number can change."""

    def off(values: Mapping[Cause, float]) -> Array:
        if rows.joints is None or rows.positions is None:
            return residuals(again, rows, clock, values)
        if frames is None:
            return joints_off(again, rows, clock, values)
        known = frames
        if cause.kind in (Kind.HIDDEN_ZERO, Kind.LINK):
            known = frames_of(again, rows, clock, values)
        return positions_off(again, rows, clock, values, known)

    return off


def _same_ticks(again: Again, values: Mapping[Cause, float], cause: Cause) -> tuple[float, float]:
    """Return two values near the present one with which motions take equally many ticks."""
    now = values.get(cause, 0.0)
    ends = [m.end_s for m in again.with_values(values).motions]
    found = [
        value
        for value in (now + cause.step, now - cause.step)
        if [m.end_s for m in again.with_values({**values, cause: value}).motions] == ends
    ]
    return max([now, *found]), min([now, *found])


def solve(
    again: Again,
    rows: Rows,
    clock: Clock,
    values: Mapping[Cause, float],
    causes: Sequence[Cause],
    least: Array,
    steps: int = STEPS,
) -> Fit:
    """Return what fits best, from given values on, by steps of Gauss and Newton.

    Args:
        again: The program.
        rows: Of the log.
        clock: To begin with.
        values: To begin with; those that are not in `causes` stay as they are.
        causes: That are fitted, beside the clock.
        least: What rounding makes, of every channel.
        steps: At most so many.
    """
    smooth = [cause for cause in causes if not cause.by_ticks]
    now = dict(values)
    residual = residuals(again, rows, clock, now)
    best = objective(residual, least)
    if not np.isfinite(best):  # it stops elsewhere
        return Fit(now, clock, residual, best)
    for _ in range(steps):
        sigma = np.sqrt((residual**2).mean(axis=0) + least**2)
        jacobian = np.concatenate(
            (
                clock_columns(again, rows, clock, now),
                columns(again, rows, clock, now, smooth),
            ),
            axis=2,
        )
        step = least_squares(jacobian / sigma[:, None], residual / sigma)
        shifts = len(clock.shifts)
        step[:shifts] = np.clip(step[:shifts], -LONGEST_STEP_S, LONGEST_STEP_S)
        for halving in range(HALVINGS):
            part = 0.5**halving * step
            moved = Clock(clock.shifts + part[:shifts], clock.which)
            tried = dict(now)
            for cause, by in zip(smooth, part[shifts:].tolist(), strict=True):
                tried[cause] = now.get(cause, 0.0) + by
                if cause.kind is Kind.LAG:
                    tried[cause] = max(tried[cause], LAST_S)
            other = residuals(again, rows, moved, tried)
            reached = objective(other, least)
            if reached < best:
                break
        else:
            break
        gained = best - reached
        clock, now, residual, best = moved, tried, other, reached
        if gained < ENOUGH:
            break
    return Fit(now, clock, residual, best)


def least_squares(jacobian: Array, residual: Array) -> Array:
    """Return the step that makes residuals smallest; what they do not tell stays."""
    flat = jacobian.reshape(-1, jacobian.shape[2])
    scale = np.sqrt((flat**2).sum(axis=0))
    scale[scale == 0.0] = 1.0
    H = (flat / scale).T @ (flat / scale)
    inverse: Array = np.asarray(np.linalg.pinv(H, rcond=WEAKEST, hermitian=True), np.float64)
    step: Array = (inverse @ ((flat / scale).T @ residual.ravel())) / scale
    return step
