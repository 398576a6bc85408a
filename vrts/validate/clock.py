"""Where on the clock of a log a run begins: found by how fast the arm moves when.

Speeds do not depend on where the robot stands or how its tool is measured, and two arms that stand
still are equally fast wherever they are.
"""

import numpy as np
import numpy.typing as npt

from vrts.engine.run import Run
from vrts.validate.log.log import RobotLog
from vrts.validate.sampling import moving, sampled

Array = npt.NDArray[np.float64]

STEP_S = 0.02  # of the comparison
SMOOTHED_S = 0.1  # a speed is that over this time
LONGEST_S = 3600.0  # what is longer is compared in coarser steps


def clock_shift(run: Run, log: RobotLog) -> float:
    """Return what to add to times of a log to have times of the run [s], to about a step.

    Of all shifts with which run and log overlap it is the one with the least squared difference
    of speeds; outside its record an arm is taken to stand still.
    """
    start, end = moving(run)
    length = max(end - start, log.times[-1] - log.times[0])
    step = max(STEP_S, log.step_s, STEP_S * length / LONGEST_S)
    virtual_times = np.arange(start - SMOOTHED_S, end + SMOOTHED_S + step, step)
    real_times = np.arange(log.times[0], log.times[-1] + step, step)
    virtual = sampled(run, virtual_times)
    if log.joints is not None:
        a = _speed(_resampled(log.times, log.joints, real_times), step)
        b = _speed(virtual.joints, step)
    else:
        assert log.positions is not None
        a = _speed(_resampled(log.times, log.positions, real_times), step)
        b = _speed(virtual.positions, step)
    k = _best_lag(a, b)
    return float(virtual_times[0] - real_times[0] - k * step)


def _best_lag(real: Array, virtual: Array) -> int:
    """Return by how many steps the run begins later in the log, where they differ least."""
    n, m = len(real), len(virtual)
    size = 1 << (n + m).bit_length()
    spectrum = np.fft.rfft(real, size) * np.conj(np.fft.rfft(virtual, size))
    products = np.fft.irfft(spectrum, size)  # of real[i + k] and virtual[i]; k wraps around
    lags = np.arange(1 - m, n)
    squares = np.concatenate([[0.0], np.cumsum(virtual**2)])
    inside = squares[np.clip(n - lags, 0, m)] - squares[np.clip(-lags, 0, m)]
    return int(lags[np.argmin(inside - 2.0 * products[lags])])


def _speed(values: Array, step: float) -> Array:
    """Return how fast the arm moves at every step, shape (n,)."""
    width = max(round(SMOOTHED_S / step), 1)
    ahead = np.concatenate([values[width:], np.repeat(values[-1:], width, axis=0)])
    return np.linalg.norm(ahead - values, axis=1) / (width * step)


def _resampled(times: Array, values: Array, at: Array) -> Array:
    known = np.isfinite(values).all(axis=1)
    found = np.empty((len(at), values.shape[1]))
    for k in range(values.shape[1]):
        found[:, k] = np.interp(at, times[known], values[known, k])
    return found
