"""Motions on which a joint is faster than it may be, and the time that is gained by them."""

from collections.abc import Sequence
from typing import NamedTuple, TypeAlias
from weakref import WeakKeyDictionary

import numpy as np
import numpy.typing as npt

from vrts.base.diagnostic import Moment
from vrts.check.collision.of_run import motion_of
from vrts.check.curves.extremes import fastest
from vrts.check.curves.timeline_arrays import Curves, lasting_of
from vrts.engine.memory.records import Motion, Segment
from vrts.engine.motion.overspeed import SPEED_TOLERANCE
from vrts.engine.run import Run

Array: TypeAlias = npt.NDArray[np.float64]


class Fastest(NamedTuple):
    """The largest share of its speed limit that a joint reaches on a motion."""

    motion: Motion
    number: int  # of the motion, in the run
    share: float
    joint: int  # from 0
    speed: float  # [rad/s]
    moment: Moment


def speed_shares(run: Run, known: Curves) -> Array:
    """Return the largest share of its speed limit of every joint on every piece, (pieces, 6)."""
    shares: Array = known.pieces.speed[:, :6] / np.array(run.scene.robot.arm.speed)
    shares[known.motions < 0] = 0.0
    return shares


def over_limit(
    run: Run, segments: Sequence[Segment], known: Curves, shares: Array
) -> list[Fastest]:
    """Return of every motion with a joint above its limit the one most above."""
    too_fast = (shares > 1.0 + SPEED_TOLERANCE).any(axis=1)
    found: list[Fastest] = []
    for motion in np.unique(known.motions[too_fast]).tolist():
        own = np.nonzero(known.motions == motion)[0]
        best, joint = divmod(int(np.argmax(shares[own])), 6)
        segment = segments[int(own[best])]
        speed, at = fastest(segment.coefficients[joint], segment.end_s - segment.start_s)
        share = speed / run.scene.robot.arm.speed[joint]
        time_s = segment.start_s + at
        coordinates: list[float] = known.values(np.array([time_s]))[0].tolist()
        moment = Moment(time_s, tuple(coordinates))
        found.append(Fastest(run.motions[motion], motion, share, joint, speed, moment))
    return found


_known: "WeakKeyDictionary[Run, tuple[tuple[float, float], ...]]" = WeakKeyDictionary()


def overruns(run: Run) -> tuple[tuple[float, float], ...]:
    """Return end [s] of every motion that is too fast for a joint, and what it gains [s], by time.

    Gained is how much longer the motion would take with the joint at its limit where it is fastest.
    Several checks ask; runs are immutable, so once is enough.
    """
    found = _known.get(run)
    if found is None:
        found = _known[run] = _overruns(run)
    return found


def _overruns(run: Run) -> tuple[tuple[float, float], ...]:
    segments = lasting_of(run.timeline.segments)
    if all(segment.motion is None for segment in segments):
        return ()
    known = motion_of(run)
    found: list[tuple[float, float]] = []
    for over in over_limit(run, segments, known, speed_shares(run, known)):
        own = [segment for segment in segments if segment.motion == over.number]
        lasts = sum(segment.end_s - segment.start_s for segment in own)
        found.append((own[-1].end_s, (over.share - 1.0) * lasts))
    return tuple(sorted(found))
