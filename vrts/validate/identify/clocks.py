"""Where the motion of a run lies in a log: one shift of the clock, or one for every stretch.

A controller that rests as long as it likes between motions is compared stretch by stretch.
"""

import numpy as np

from vrts.engine.run import Run
from vrts.validate.clock import clock_shift
from vrts.validate.identify.forward import Clock, Rows, commanded, spans_of
from vrts.validate.log.log import RobotLog

FIRST_S = np.arange(-6.0, 6.0, 0.03)  # where the first stretch is looked for
LOOKED_S = np.concatenate((np.arange(-0.2, 0.4, 0.02), np.arange(0.4, 4.0, 0.05)))
LATER_S = np.arange(4.0, 60.0, 0.1)  # looked at where it is in none of those places
NOWHERE = 0.01  # [rad] mean error of a joint in the best place, above which it is in none
NEARER = 0.3  # a later place has so little of that
AS_GOOD, ALIKE = 2.0, 0.002  # times the best, and [rad] more, is as good
FEWEST = 4  # rows of a stretch
FURTHER = 40  # rows that are compared, at most, when a stretch is looked for


def whole(run: Run, log: RobotLog, rows: Rows) -> Clock:
    """Return one shift for all rows."""
    return Clock(np.array([clock_shift(run, log)]), np.zeros(len(rows.times), np.intp))


def by_stretches(run: Run, rows: Rows, begin: Clock) -> Clock | None:
    """Return a shift for every stretch, each looked for after the one before; None: not found."""
    spans = spans_of(run)
    if len(spans) < 2 or rows.joints is None:
        return None
    shifts: list[float] = []
    rests = float(begin.shifts[0])
    for start, end in spans.tolist():
        tried = rests - (LOOKED_S if shifts else FIRST_S)
        off = [_off(run, rows, (start, end), shift) for shift in tried.tolist()]
        if shifts and min(off) > NOWHERE:  # a controller may gather motions for long
            later = rests - LATER_S
            off_later = [_off(run, rows, (start, end), shift) for shift in later.tolist()]
            if min(off_later) < NEARER * min(off):
                tried, off = later, off_later
        if not np.isfinite(min(off)):
            return None
        rests = float(tried[soonest(off) if shifts else int(np.argmin(off))])
        shifts.append(rests)
    found = np.array(shifts)
    middles = 0.5 * (spans[:-1, 1] - found[:-1] + spans[1:, 0] - found[1:])
    return Clock(found, np.searchsorted(middles, rows.times).astype(np.intp))


def soonest(off: list[float]) -> int:
    """Return the first place that is about as good as the best: the same motion may come again."""
    enough = AS_GOOD * min(off) + ALIKE
    ends = [np.inf, *off, np.inf]
    return next(k for k, one in enumerate(off) if one <= enough and ends[k] >= one <= ends[k + 2])


def _off(run: Run, rows: Rows, span: tuple[float, float], shift: float) -> float:
    assert rows.joints is not None
    first, last = np.searchsorted(rows.times, [span[0] - shift, span[1] - shift])
    if last - first < FEWEST:
        return np.inf
    every = max((last - first) // FURTHER, 1)
    times = rows.times[first:last:every] + shift
    joints = commanded(run, times, np.full(len(times), -np.inf), {})
    return float(np.abs(rows.joints[first:last:every] - joints).mean())


def moved(clock: Clock, before: Run, after: Run) -> Clock:
    """Return a clock for a run with other numbers: the middles of stretches stay in the log.

    Where it stops more or fewer times nothing can be compared, and the clock stays.
    """
    a, b = spans_of(before), spans_of(after)
    if clock.whole or len(a) != len(b):
        return clock
    return Clock(clock.shifts + b.mean(axis=1) - a.mean(axis=1), clock.which)
