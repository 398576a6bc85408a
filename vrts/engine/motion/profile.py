"""Time scaling of one motion: how its path parameter u goes from 0 to 1.

Time x counts from the nominal departure: a motion of duration T would be at u = x / T if it could
start and stop at once. At each end that straight line is rounded over a zone:

- from or to rest, a parabola of duration A, half of it before the nominal instant;
- into or out of a neighbouring motion, a quartic from W before to W after the nominal instant,
  whose acceleration is zero at both ends [Paul1981]_. Added to the neighbour's, it gives the
  rounded corner; the peak acceleration is 1.5 times the change of speed divided by 2 W.

How long the zones are, and how short a motion may be, is the controller model's to say
[manual language/motion#time-scaling].
"""

import math
from typing import NamedTuple

TICK_TOLERANCE = 1e-6  # of a tick, so that a whole number of them in single precision stays one


class Phase(NamedTuple):
    """u(x) = sum_k c[k] (x - start)^k over a length."""

    start: float  # [s] from the nominal departure
    length: float  # [s]
    coefficients: tuple[float, ...]


class Profile(NamedTuple):
    """The time scaling of a motion."""

    duration: float  # T [s]
    rise: float  # half the first zone [s]
    fall: float  # half the last zone [s]
    from_rest: bool = True
    to_rest: bool = True

    @property
    def begin(self) -> float:
        """Start of the first zone, from the nominal departure [s]; negative."""
        return -self.rise

    @property
    def end(self) -> float:
        """End of the last zone, from the nominal departure [s]."""
        return self.duration + self.fall

    @property
    def total(self) -> float:
        """Time from the start of the first zone to the end of the last [s]."""
        return self.rise + self.duration + self.fall

    @property
    def cruise(self) -> tuple[float, float]:
        """Start and end of the constant speed [s]."""
        return (self.rise, self.duration - self.fall)

    def head(self) -> Phase:
        """Return the first zone."""
        full, half = self.duration, self.rise
        if self.from_rest:
            return Phase(-half, 2.0 * half, (0.0, 0.0, 1.0 / (4.0 * full * half)))
        zone = 2.0 * half
        c = half / full / zone**3
        return Phase(-half, zone, (0.0, 0.0, 0.0, 2.0 * c, -c / zone))

    def body(self) -> Phase | None:
        """Return the part of constant speed; None when the zones meet."""
        start, end = self.cruise
        if end <= start:
            return None
        return Phase(start, end - start, (start / self.duration, 1.0 / self.duration))

    def tail(self) -> Phase:
        """Return the last zone."""
        full, half = self.duration, self.fall
        start, speed = full - half, 1.0 / full
        if self.to_rest:
            return Phase(start, 2.0 * half, (1.0 - half * speed, speed, -1.0 / (4.0 * full * half)))
        zone = 2.0 * half
        c = half / full / zone**3
        return Phase(start, zone, (1.0 - half * speed, speed, 0.0, -2.0 * c, c / zone))

    def phases(self) -> tuple[Phase, ...]:
        """Return all of it in time order."""
        body = self.body()
        return (self.head(), self.tail()) if body is None else (self.head(), body, self.tail())


def at(phase: Phase, x: float) -> tuple[float, float]:
    """Return u and du/dx [1/s] at a time from the nominal departure."""
    t = x - phase.start
    u = rate = 0.0
    for c in reversed(phase.coefficients):
        rate = rate * t + u
        u = u * t + c
    return u, rate


def profile(
    shortest: float,
    acceleration: float,
    deceleration: float,
    tick: float,
    least: float = 0.0,
    *,
    least_accelerations: float,
) -> Profile:
    """Return the profile from rest to rest of a motion.

    Args:
        shortest: Time at full speed [s].
        acceleration: Time to reach full speed [s].
        deceleration: Time to come to rest [s].
        tick: Of the trajectory generator [s]: the duration is a whole number of them.
        least: Least duration [s], of DURATION.
        least_accelerations: Least duration as a multiple of the longer acceleration.
    """
    needed = max(shortest, least_accelerations * max(acceleration, deceleration), least)
    duration = math.ceil(needed / tick - TICK_TOLERANCE) * tick
    return Profile(duration, 0.5 * acceleration, 0.5 * deceleration)
