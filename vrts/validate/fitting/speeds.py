"""How fast joints are, from how long motions take.

A motion takes as long as its slowest joint needs, rounded up to a whole number of ticks: a motion
of n ticks tells that the joint which decides it is at least so fast that it needs n ticks, and not
so fast that it would need one less. What all motions allow in common is the answer.
"""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
import numpy.typing as npt
from scipy.optimize import least_squares

from vrts.validate.fitted import Estimate

Array = npt.NDArray[np.float64]

PLAY = 0.05  # of a tick: what noise may add to a duration or take away


class Leg(NamedTuple):
    """One motion as fitted."""

    ways: tuple[float, ...]  # absolute, of every joint [rad]; of a line its one length [m]
    fraction: float  # of full speed
    duration: float  # T [s]


def speeds(
    legs: Sequence[Leg], assumed: Sequence[float], tick: float, shortest: float
) -> list[Estimate | None]:
    """Return the speed of every joint at full speed; None where no motion tells it.

    Args:
        legs: Motions.
        assumed: Speeds to begin with [rad/s], or the one speed of lines [m/s].
        tick: Of the controller [s].
        shortest: What is shorter than this was as long as acceleration wants [s].
    """
    telling = [leg for leg in legs if leg.duration > shortest + tick]
    if not telling:
        return [None] * len(assumed)
    ways = np.array([np.array(leg.ways) / leg.fraction for leg in telling])
    durations = np.array([leg.duration for leg in telling])

    def residuals(slowness: Array) -> Array:
        return (ways * slowness).max(axis=1) + 0.5 * tick - durations

    first = 1.0 / np.array(assumed)
    fit = least_squares(residuals, first, loss="soft_l1", f_scale=tick, x_scale=first)
    slowness = np.abs(fit.x)
    decides = np.argmax(ways * slowness, axis=1)
    found: list[Estimate | None] = []
    for joint in range(len(assumed)):
        own = decides == joint
        if not own.any():
            found.append(None)
            continue
        found.append(_estimate(ways[own, joint], durations[own], tick, 1.0 / slowness[joint]))
    return found


def _estimate(ways: Array, durations: Array, tick: float, fitted: float) -> Estimate:
    """Return what motions allow that one joint decides; where they disagree, what fits best."""
    ticks = np.round(durations / tick)
    if float(np.abs(durations / tick - ticks).max()) > 0.5 - PLAY:
        ticks = durations / tick
    low = float((ways / (ticks * tick)).max())
    high = float((ways / np.maximum((ticks - 1.0) * tick, 1e-9)).min())
    if low < high:
        return Estimate(0.5 * (low + high), low, high, len(ways))
    return Estimate(float(fitted), min(high, float(fitted)), max(low, float(fitted)), len(ways))
