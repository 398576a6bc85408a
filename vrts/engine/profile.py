"""Time scaling of a motion from rest to rest: constant acceleration, constant speed, and back.

The path parameter u goes from 0 to 1. With `duration` T and acceleration time A the speed rises to
1/T within A, stays, and falls to zero within A, so the motion takes T + A [assumed, val2.md 7.3].
"""

import math
from typing import NamedTuple

TICK_TOLERANCE = 1e-9  # of a tick, so that an exact multiple is not rounded up


class Phase(NamedTuple):
    """u(t) = sum_k c[k] t^k for t from 0 to `length_s`."""

    start_s: float
    length_s: float
    coefficients: tuple[float, float, float]


class Profile(NamedTuple):
    """A trapezoidal profile."""

    duration: float  # T [s]
    acceleration_time: float  # A [s], at most T

    @property
    def total(self) -> float:
        """Time from rest to rest [s]."""
        return self.duration + self.acceleration_time

    def at(self, t: float) -> tuple[float, float]:
        """Return u and du/dt [1/s] at a time from the start."""
        full, rise = self.duration, self.acceleration_time
        if t < rise:
            return (t * t / (2.0 * full * rise), t / (full * rise))
        if t <= full:
            return ((t - 0.5 * rise) / full, 1.0 / full)
        left = self.total - t
        return (1.0 - left * left / (2.0 * full * rise), left / (full * rise))

    def phases(self) -> tuple[Phase, ...]:
        """Return u as polynomials of the time from each phase's start."""
        full, rise = self.duration, self.acceleration_time
        bend = 1.0 / (2.0 * full * rise)
        speed = 1.0 / full
        gained = rise * rise * bend
        rising = Phase(0.0, rise, (0.0, 0.0, bend))
        falling = Phase(full, rise, (1.0 - gained, speed, -bend))
        if full - rise <= 0.0:
            return (rising, falling)
        return (rising, Phase(rise, full - rise, (gained, speed, 0.0)), falling)


def profile(shortest: float, acceleration_time: float, tick: float) -> Profile:
    """Return the profile of a motion that takes at least `shortest` at full speed [s].

    At least twice the acceleration time, rounded up to whole ticks [assumed, val2.md 7.3].
    """
    least = max(shortest, 2.0 * acceleration_time)
    return Profile(math.ceil(least / tick - TICK_TOLERANCE) * tick, acceleration_time)
