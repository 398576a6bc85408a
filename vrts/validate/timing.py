"""When the real robot was where the simulated one was, motion by motion."""

from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from vrts.engine.memory.records import Motion
from vrts.engine.run import Run
from vrts.validate.log.log import RobotLog
from vrts.validate.offsets import Offsets
from vrts.validate.sampling import sampled

Array = npt.NDArray[np.float64]

SHARES = (0.1, 0.5, 0.9)  # of the time of a motion: when it is looked at
REACH_S = 1.5  # how much earlier or later the real arm is looked for
NOISE_S = 0.1  # passages so close together are one
LEAST_RAD, LEAST_M = 0.02, 0.005  # a motion that covers less tells no time


class Timing(NamedTuple):
    """One motion: by how much the real arm was late [s], negative where it was early."""

    number: int  # of the motion in the run
    line: int  # of its instruction, from 1
    words: str  # the instruction as written
    start_s: float
    end_s: float
    late: tuple[float | None, float | None, float | None]  # at 10 %, 50 % and 90 % of its time


def timings(run: Run, log: RobotLog, offsets: Offsets) -> list[Timing]:
    """Return the timing of every motion of a run, as a log shows it with a shift of its clock."""
    times = log.times + offsets.time_s
    if log.joints is not None:
        known = np.isfinite(log.joints).all(axis=1)
        times, values, least = times[known], log.joints[known], LEAST_RAD
    else:
        assert log.positions is not None
        known = np.isfinite(log.positions).all(axis=1)
        times, values, least = times[known], log.positions[known], LEAST_M
    in_joints = log.joints is not None
    return [
        Timing(
            number,
            motion.cause.span.line,
            " ".join(motion.cause.span.text.split()),
            motion.start_s,
            motion.end_s,
            _late(run, motion, times, values, least, in_joints=in_joints),
        )
        for number, motion in enumerate(run.motions)
        if motion.end_s <= run.horizon_s
    ]


def _late(
    run: Run, motion: Motion, times: Array, values: Array, least: float, *, in_joints: bool
) -> tuple[float | None, float | None, float | None]:
    """Return the lateness at the shares of a motion; None where the arm is hardly moving."""
    first, last = motion.start_s, motion.end_s
    at = np.array([first, *(first + s * (last - first) for s in SHARES), last])
    samples = sampled(run, at)
    places = samples.joints if in_joints else samples.positions
    way = places[-1] - places[0]
    length = float(np.linalg.norm(way))
    if length < least:
        return None, None, None
    direction = way / length
    begin, end = np.searchsorted(times, [first - REACH_S, last + REACH_S])
    covered = (values[begin:end] - places[0]) @ direction
    levels = (places - places[0]) @ direction
    found = [
        _crossing(times[begin:end], covered, float(level), float(when))
        for level, when in zip(levels[1:4], at[1:4], strict=True)
    ]
    return found[0], found[1], found[2]


def _crossing(times: Array, covered: Array, level: float, when: float) -> float | None:
    """Return by how much later than in the run a level is passed upward.

    Of several passages the nearest counts, and those about it, which noise makes.
    """
    upward = np.flatnonzero((covered[:-1] < level) & (covered[1:] >= level))
    if not len(upward):
        return None
    share = (level - covered[upward]) / (covered[upward + 1] - covered[upward])
    passed = times[upward] + share * (times[upward + 1] - times[upward])
    late = passed - when
    nearest = late[np.argmin(np.abs(late))]
    return float(late[np.abs(late - nearest) < NOISE_S].mean())
