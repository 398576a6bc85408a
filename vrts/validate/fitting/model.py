"""How far along its way a motion is, as the engine's `profile` has it, behind by a servo's lag.

The same formulas as in `engine.motion.profile`, for many times at once and for any real numbers in
place of whole ticks: a fit needs to go smoothly from one number to another.
"""

from typing import NamedTuple

import numpy as np
import numpy.typing as npt
from scipy.signal import lfilter

Array = npt.NDArray[np.float64]

GRID_S = 0.004  # of the servo's lag
BEFORE_S = 0.4  # the grid begins so long before the first departure


class Shared(NamedTuple):
    """What all motions have in common [s]."""

    acceleration: float  # A: from rest to full speed
    half_blend: float  # W: half a corner
    lag: float = 0.0  # of the servos


def progress(
    x: Array, duration: float, rise: float, fall: float, *, ends: tuple[bool, bool]
) -> Array:
    """Return u, from 0 to 1, at times x from the nominal departure [s].

    Args:
        x: Times, shape (n,).
        duration: T.
        rise: Half the first zone.
        fall: Half the last zone.
        ends: Whether the motion begins at rest, and whether it ends at rest.
    """
    u = x / duration
    u = np.where(x < rise, _zone(x, duration, rise, at_rest=ends[0]), u)
    back = 1.0 - _zone(duration - x, duration, fall, at_rest=ends[1])
    return np.where(x > duration - fall, back, u)


def _zone(x: Array, duration: float, half: float, *, at_rest: bool) -> Array:
    """Return u in the first zone, 0 before it."""
    share = np.clip((x + half) / (2.0 * half), 0.0, 1.0)
    if at_rest:
        return half / duration * share**2
    return half / duration * (2.0 * share**3 - share**4)


def chain_values(
    times: Array, ways: Array, departure: float, durations: Array, shared: Shared
) -> Array:
    """Return how far from its start an arm is on a chain of motions, shape (n, c).

    Args:
        times: Shape (n,) [s].
        ways: Of every motion, shape (k, c).
        departure: Of the first motion, nominal [s].
        durations: Of every motion, shape (k,) [s].
        shared: Acceleration, corners and lag.
    """
    begin = min(departure - BEFORE_S, float(times[0])) - GRID_S
    count = int((float(times[-1]) - begin) / GRID_S) + 3
    grid = begin + GRID_S * np.arange(count, dtype=np.float64)
    u = np.zeros((count, len(durations)))
    at, last = departure, len(durations) - 1
    for k, duration in enumerate(durations.tolist()):
        rise = 0.5 * shared.acceleration if k == 0 else shared.half_blend
        fall = 0.5 * shared.acceleration if k == last else shared.half_blend
        u[:, k] = progress(grid - at, duration, rise, fall, ends=(k == 0, k == last))
        at += duration
    if shared.lag > 0.0:
        kept = float(np.exp(-GRID_S / shared.lag))
        u = lfilter([1.0 - kept], [1.0, -kept], u, axis=0)
    found = np.empty((len(times), len(durations)))
    for k in range(len(durations)):
        found[:, k] = np.interp(times, grid, u[:, k])
    return found @ ways
