"""Whether two runs of one scene are the same motion, in space and in time."""

from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from vrts.base.units import MM
from vrts.engine.batch import batch_of
from vrts.engine.run import Run
from vrts.robots.kinematics.batch import flange_frames

TOLERANCE_MM = 0.01  # that the tool may be elsewhere
STEP_S = 0.004  # between times that are compared, besides the ends of all segments
LEVER_M = 0.3  # from the flange: points so far out show how it is turned
_INSTANT = 1e-6  # [s]

Array = npt.NDArray[np.float64]


class Difference(NamedTuple):
    """How far a run is from another."""

    most_mm: float  # of points on the tool and of the opening of the hand
    first_s: float  # when it is first beyond the tolerance; where none is, when it is largest
    duration_s: float  # by which the other lasts longer

    @property
    def is_none(self) -> bool:
        """Whether they are the same motion."""
        return self.most_mm <= TOLERANCE_MM and abs(self.duration_s) <= _INSTANT


def difference(one: Run, other: Run) -> Difference:
    """Compare where the tool is and how far the hand is open, at the same times."""
    longer = other.horizon_s - one.horizon_s
    until = max(one.horizon_s, other.horizon_s)
    ends = [s.end_s for run in (one, other) for s in run.timeline.segments]
    times = np.unique(np.concatenate([np.arange(0.0, until + STEP_S, STEP_S), np.array(ends)]))
    apart = np.abs(_points(one, times) - _points(other, times)).max(axis=1) / MM
    beyond = np.flatnonzero(apart > TOLERANCE_MM)
    at = int(beyond[0]) if len(beyond) else int(apart.argmax())
    return Difference(float(apart.max()), float(times[at]), longer)


def _points(run: Run, times: Array) -> Array:
    """Return points on the tool, and the opening of the hand, at times [m], shape (m, 10)."""
    values = batch_of(run.timeline).values(times)
    rotations, origins = flange_frames(run.scene.robot.arm, values[:, :6])
    out = [origins + LEVER_M * rotations[:, :, k] for k in (0, 2)]
    return np.concatenate((origins, *out, values[:, 6:7]), axis=1)
