"""How far a real robot was from the simulated one, sample by sample, and what that comes to."""

from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from vrts.engine.run import Run
from vrts.validate.log.log import RobotLog
from vrts.validate.offsets import Offsets, predicted
from vrts.validate.sampling import commanded, moving, sampled, tool_poses

Array = npt.NDArray[np.float64]

STILL_M_S = 1e-4  # slower than this a path has no direction


class Measures(NamedTuple):
    """What a series of errors comes to, in its own unit; the mean square in its square."""

    mean: float
    mean_square: float
    rms: float
    largest: float  # absolute


class Errors(NamedTuple):
    """Real minus simulated, at the instants of the log while the arm was under way."""

    times: Array  # of the run, shape (n,) [s]
    real: Array  # the real tool in W, shape (n, 3) [m]
    virtual: Array  # the simulated tool in W, displaced as the real robot, shape (n, 3) [m]
    joints: Array | None  # shape (n, 6) [rad]
    from_joints: bool  # `real` was worked out from logged joints

    @property
    def path(self) -> Array:
        """The error of the tool in X, Y and Z, shape (n, 3) [m]."""
        return self.real - self.virtual


def errors_of(run: Run, log: RobotLog, offsets: Offsets) -> Errors:
    """Return the errors of a log with offsets taken into account."""
    start, end = moving(run)
    times = log.times + offsets.time_s
    under_way = (times >= start) & (times <= end)
    if log.positions is not None:
        real = log.positions
    else:
        assert log.joints is not None
        _, real = tool_poses(run, times, commanded(run, log.joints))
    kept = under_way & np.isfinite(real).all(axis=1)
    times, real = times[kept], real[kept]
    joints = None
    if log.joints is not None:
        joints = log.joints[kept] - sampled(run, times).joints
    return Errors(
        times, real, predicted(run, times, offsets), joints, from_joints=log.positions is None
    )


def measures(errors: Array) -> Measures:
    """Return the measures of one series; NaN is left out."""
    known = errors[np.isfinite(errors)]
    if not len(known):
        return Measures(0.0, 0.0, 0.0, 0.0)
    square = float((known**2).mean())
    return Measures(float(known.mean()), square, square**0.5, float(np.abs(known).max()))


def lengths(errors: Errors) -> Array:
    """Return the length of the path error, shape (n,) [m]."""
    return np.linalg.norm(errors.path, axis=1)


def along_and_across(run: Run, errors: Errors) -> tuple[Array, Array]:
    """Return the error along the path, positive where the real tool is ahead, and beside it [m].

    Both are NaN where the simulated tool stands still.
    """
    v = sampled(run, errors.times).velocities
    speed = np.linalg.norm(v, axis=1)
    slow = speed < STILL_M_S
    direction = v / np.where(slow, 1.0, speed)[:, None]
    along = (errors.path * direction).sum(axis=1)
    across = np.linalg.norm(errors.path - along[:, None] * direction, axis=1)
    along[slow], across[slow] = np.nan, np.nan
    return along, across
