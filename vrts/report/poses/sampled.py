"""Where joints and hand are at a steady rate."""

from typing import TypeAlias

import numpy as np
import numpy.typing as npt

from vrts.check.collision.of_run import motion_of
from vrts.engine.run import Run

Array: TypeAlias = npt.NDArray[np.float64]

RATE_HZ = 50.0  # poses a second, as the original system broadcast them


def times_of(run: Run, rate_hz: float = RATE_HZ) -> Array:
    """Return instants at a steady rate, and the end [s]."""
    end = run.horizon_s
    steady = np.arange(0.0, end, 1.0 / rate_hz)
    return np.unique(np.concatenate([steady, [end]]))


def coordinates(run: Run, times: Array) -> tuple[Array, Array]:
    """Return joints [rad] and hand opening [m], shape (n, 7), and their rates."""
    motion = motion_of(run)
    rates = motion.velocities(times)
    rates[times >= motion.end_s] = 0.0
    return motion.values(times), rates
