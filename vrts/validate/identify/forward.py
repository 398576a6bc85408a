"""What a log of a robot with other numbers would show: the forward model, row by row.

Joints are what the controller commands at the time of the row, behind by the servos' lag, plus
what joints stand off. Positions are those that the arm has with the joints of the same row: base,
links, tool. So where a log has both, the one tells of times and the other of measures.
"""

from collections.abc import Mapping
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from vrts.engine.batch import Batch, batch_of
from vrts.engine.run import Run
from vrts.robots.built import shown_off
from vrts.robots.kinematics.batch import flange_frames
from vrts.validate.identify.again import Again, with_links
from vrts.validate.identify.causes import Cause, Kind
from vrts.validate.log.log import RobotLog
from vrts.validate.offsets import turned
from vrts.validate.sampling import JOINTS, moving, tools_of

Array = npt.NDArray[np.float64]
Places = npt.NDArray[np.intp]
Values = Mapping[Cause, float]

MOST_ROWS = 4000  # of a longer log every second row is looked at, or every third
AROUND_S = 1.0  # of rest before and after the motion

_NODES, _WEIGHTS = np.polynomial.laguerre.laggauss(8)


class Rows(NamedTuple):
    """Rows of a log that have all their values."""

    times: Array  # shape (n,) [s]
    joints: Array | None  # shape (n, 6) [rad]
    positions: Array | None  # shape (n, 3) [m]
    middle_s: float  # of the times: a rate turns about it

    @property
    def channels(self) -> int:
        """How many numbers a row has."""
        return (0 if self.joints is None else 6) + (0 if self.positions is None else 3)

    def measured(self) -> Array:
        """Return all numbers, shape (n, channels)."""
        return np.column_stack([v for v in (self.joints, self.positions) if v is not None])


class Clock(NamedTuple):
    """What is added to times of the log, one number or one for every stretch of the motion."""

    shifts: Array  # shape (s,) [s]
    which: Places  # of them for every row, shape (n,)

    @property
    def whole(self) -> bool:
        """Whether one number holds for all rows."""
        return len(self.shifts) == 1


def spans_of(run: Run) -> Array:
    """Return start and end of every stretch from rest to rest, shape (s, 2) [s]."""
    found: list[tuple[float, float]] = []
    start: float | None = None
    for motion in run.motions:
        if start is None:
            start = motion.start_s
        if not motion.blended:
            if motion.end_s > start:
                found.append((start, motion.end_s))
            start = None
    return np.array(found).reshape(-1, 2)


def alike(run: Run, clock: Clock) -> bool:
    """Whether a run has a stretch for every number of a clock."""
    return clock.whole or len(spans_of(run)) == len(clock.shifts)


def bounds(run: Run, clock: Clock) -> tuple[Array, Array]:
    """Return between which times of the run every row lies, shapes (n,) [s].

    Where every stretch has its own clock, a row belongs to one stretch and the rests beside it.
    """
    n = len(clock.which)
    if clock.whole:
        return np.full(n, -np.inf), np.full(n, np.inf)
    spans = spans_of(run)
    low = np.concatenate(([-np.inf], spans[:-1, 1]))
    high = np.concatenate((spans[1:, 0], [np.inf]))
    return low[clock.which], high[clock.which]


def rows_of(run: Run, log: RobotLog, shift_s: float) -> Rows:
    """Return the rows about the motion of a run, all of whose values are known."""
    known = np.isfinite(log.times)
    for values in (log.joints, log.positions):
        if values is not None:
            known &= np.isfinite(values).all(axis=1)
    # the real motion may take longer than that of the run: the end of the log is kept
    known &= log.times + shift_s >= moving(run)[0] - AROUND_S
    at = np.flatnonzero(known)
    at = at[:: -(-len(at) // MOST_ROWS) if len(at) else 1]
    times = log.times[at]
    return Rows(
        times,
        None if log.joints is None else log.joints[at],
        None if log.positions is None else log.positions[at],
        0.5 * float(times[0] + times[-1]) if len(times) else 0.0,
    )


def commanded(run: Run, times: Array, low: Array, values: Values) -> Array:
    """Return joints at times, behind by the lag of their servos, shape (n, 6) [rad].

    What was before `low` does not count.
    """
    batch = batch_of(run.timeline)
    smooth, stepped = values.get(Cause(Kind.LAG), 0.0), values.get(Cause(Kind.LAG, 1), 0.0)
    if stepped > 0.0:
        return _between_set_points(batch, times, stepped, run.scene.robot.arm.tick)
    if smooth == 0.0:
        return batch.values(times)[:, :JOINTS]
    return _behind(batch, times, low, smooth)


def _behind(batch: Batch, times: Array, low: Array, lag_s: float) -> Array:
    """Return the exponential average over the past, by the formula of Gauss and Laguerre."""
    found = np.zeros((len(times), JOINTS))
    for node, weight in zip(_NODES, _WEIGHTS, strict=True):
        found += weight * batch.values(np.maximum(times - lag_s * node, low))[:, :JOINTS]
    return found


def _between_set_points(batch: Batch, times: Array, lag_s: float, tick: float) -> Array:
    """Return the same where a servo is led on straight lines from one set point to the next."""
    first = int(np.floor(float(times.min()) / tick)) - 1
    last = int(np.ceil(float(times.max()) / tick)) + 1
    ticks = np.arange(first, last + 1, dtype=np.float64)
    points = batch.values(tick * ticks)[:, :JOINTS]
    behind = lag_s * np.diff(points, axis=0) / tick  # once a line has gone on for long
    kept = np.exp(-tick / lag_s)
    state = np.empty_like(points)
    state[0] = now = points[0]
    for k, further in enumerate(points[1:] - behind - kept * (points[:-1] - behind)):
        state[k + 1] = now = kept * now + further
    at = np.floor(times / tick).astype(np.intp) - first
    into = (times - tick * (at + first))[:, None]
    goal = points[at] + into / tick * (points[at + 1] - points[at])
    off = state[at] - points[at] + behind[at]
    return goal - behind[at] + off * np.exp(-into / lag_s)


def run_times(rows: Rows, clock: Clock, values: Values) -> Array:
    """Return the time of the run at every row [s]."""
    rate = values.get(Cause(Kind.RATE), 0.0)
    return rows.times + rate * (rows.times - rows.middle_s) + clock.shifts[clock.which]


def residuals(again: Again, rows: Rows, clock: Clock, values: Values) -> Array:
    """Return measured minus modelled, shape (n, channels) [rad, m].

    Infinite where the robot would stop more or fewer times than the clock has stretches.
    """
    if not alike(again.with_values(values), clock):
        return np.full((len(rows.times), rows.channels), np.inf)
    if rows.positions is None:
        return joints_off(again, rows, clock, values)
    off = positions_off(again, rows, clock, values, frames_of(again, rows, clock, values))
    if rows.joints is None:
        return off
    return np.column_stack((joints_off(again, rows, clock, values), off))


def joints_off(again: Again, rows: Rows, clock: Clock, values: Values) -> Array:
    """Return measured minus modelled joints of a log that has them, shape (n, 6) [rad]."""
    assert rows.joints is not None
    if not alike(again.with_values(values), clock):
        return np.full((len(rows.times), JOINTS), np.inf)
    return rows.joints - _encoders(again, rows, clock, values)


def _encoders(again: Again, rows: Rows, clock: Clock, values: Values) -> Array:
    run = again.with_values(values)
    times, low = _at(run, rows, clock, values)
    joints = commanded(run, times, low, values)
    return joints + _six(values, Kind.ZERO) + np.array(shown_off(again.run.scene.robot.arm))


def _at(run: Run, rows: Rows, clock: Clock, values: Values) -> tuple[Array, Array]:
    """Return times of the run, and before which nothing counts [s]."""
    low, high = bounds(run, clock)
    return np.clip(run_times(rows, clock, values), low, high), low


def frames_of(again: Again, rows: Rows, clock: Clock, values: Values) -> tuple[Array, Array]:
    """Return rotations and origins of the flange, by the logged joints where there are any."""
    if rows.joints is None:
        shown = _encoders(again, rows, clock, values)
    else:
        shown = rows.joints + _six(values, Kind.HIDDEN_ZERO)
    arm = with_links(again.run.scene.robot.arm, values, Kind.LINK)
    return flange_frames(arm, shown - np.array(shown_off(arm)))


def positions_off(
    again: Again, rows: Rows, clock: Clock, values: Values, frames: tuple[Array, Array]
) -> Array:
    """Return measured minus modelled positions of a log that has them, shape (n, 3) [m]."""
    assert rows.positions is not None
    run = again.with_values(values)
    times, _ = _at(run, rows, clock, values)
    rotations, origins = frames
    tools = tools_of(run)
    which = np.searchsorted(tools.starts, times, side="right")
    tip = tools.origins[which] + tools.rotations[which] @ _three(values, Kind.TOOL)
    points = origins + np.einsum("nij,nj->ni", rotations, tip)
    points = points @ turned(_three(values, Kind.TURN)).T + _three(values, Kind.BASE)
    return rows.positions - points


def _six(values: Values, kind: Kind) -> Array:
    return np.array([values.get(Cause(kind, joint), 0.0) for joint in range(6)])


def _three(values: Values, kind: Kind) -> Array:
    return np.array([values.get(Cause(kind, axis), 0.0) for axis in range(3)])
