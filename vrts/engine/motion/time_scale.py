"""The operator's speed, emergency stops and BRAKE: one map from run time to path time.

Motions are planned in path time, at full monitor speed. Its rate is the monitor speed as a share
of 100 %; a change ramps linearly, so velocities stay continuous, and a stop is a ramp to zero. The
path itself never changes.
"""

import math
from bisect import bisect_left, bisect_right
from typing import NamedTuple

from vrts.engine.motion.polynomials import Row


class Knot(NamedTuple):
    """From a run time on: path = path_s + rate t + slope t^2 / 2, t = time - time_s."""

    time_s: float
    path_s: float
    rate: float
    slope: float = 0.0  # [1/s]


class TimeScale:
    """Path time as a function of run time."""

    __slots__ = ("knots", "rate")

    def __init__(self, rate: float = 1.0) -> None:
        """Start at a steady rate, both times at 0."""
        self.rate = rate  # the steady one: the monitor speed as a share
        self.knots: list[Knot] = [Knot(0.0, 0.0, rate)]

    def copy(self) -> "TimeScale":
        """Return an independent copy."""
        other = TimeScale(self.rate)
        other.knots = self.knots.copy()
        return other

    @property
    def plain(self) -> bool:
        """Whether path time is run time."""
        knot = self.knots[0]
        return len(self.knots) == 1 and self.rate == 1.0 and knot.time_s == knot.path_s

    def path(self, time_s: float) -> float:
        """Return the path time at a run time."""
        knots = self.knots
        if len(knots) == 1:
            return knots[0].path_s + (time_s - knots[0].time_s) * knots[0].rate
        knot = knots[max(bisect_right(knots, time_s, key=_time) - 1, 0)]
        t = time_s - knot.time_s
        return knot.path_s + t * (knot.rate + 0.5 * t * knot.slope)

    def rate_at(self, time_s: float) -> float:
        """Return the rate at a run time."""
        knot = self.knots[max(bisect_right(self.knots, time_s, key=_time) - 1, 0)]
        return knot.rate + (time_s - knot.time_s) * knot.slope

    def time(self, path_s: float) -> float:
        """Return the first run time at which a path time is reached; inf when it never is."""
        knots = self.knots
        k = max(bisect_right(knots, path_s, key=_path) - 1, 0)
        while k and knots[k].path_s == path_s == knots[k - 1].path_s:
            k -= 1  # of knots at the same path time the first counts
        knot = knots[k]
        ahead = path_s - knot.path_s
        if knot.slope == 0.0:
            return knot.time_s + ahead / knot.rate if knot.rate else math.inf
        inside = max(knot.rate * knot.rate + 2.0 * knot.slope * ahead, 0.0)
        return knot.time_s + 2.0 * ahead / (knot.rate + math.sqrt(inside)) if ahead else knot.time_s

    def change(self, time_s: float, rate: float, ramp: float) -> None:
        """Go over to another steady rate from a time on, within `ramp` seconds."""
        self._ramp(time_s, rate, ramp)
        self.rate = rate

    def stop(self, time_s: float, ramp: float) -> float:
        """Ramp down to zero and go on at the steady rate from there; return when that is [s]."""
        self._ramp(time_s, 0.0, ramp)
        last = self.knots.pop()
        self.knots.append(Knot(last.time_s, last.path_s, self.rate))
        return last.time_s

    def change_after_stop(self, rate: float) -> None:
        """Go on at another steady rate once the stop under way is complete."""
        self.rate = rate
        self.knots[-1] = self.knots[-1]._replace(rate=rate)

    def forget(self, before_s: float) -> None:
        """Let go of what only matters before a path time."""
        del self.knots[: max(bisect_left(self.knots, before_s, key=_path) - 1, 0)]

    def pieces(self, start_s: float, end_s: float) -> list[tuple[float, float, Row]]:
        """Return path time as polynomials of (time - start) that together span an interval."""
        knots = self.knots
        first = max(bisect_right(knots, start_s, key=_time) - 1, 0)
        found: list[tuple[float, float, Row]] = []
        for k in range(first, len(knots)):
            knot = knots[k]
            begin = max(start_s, knot.time_s)
            stop = min(end_s, knots[k + 1].time_s) if k + 1 < len(knots) else end_s
            if knot.time_s >= end_s and found:
                break
            if stop <= begin:
                continue
            t = begin - knot.time_s
            at = knot.path_s + t * (knot.rate + 0.5 * t * knot.slope)
            row: Row = (at, knot.rate + t * knot.slope)
            found.append((begin, stop, (*row, 0.5 * knot.slope) if knot.slope else row))
        return found

    def _ramp(self, time_s: float, rate: float, ramp: float) -> None:
        now, path_s = self.rate_at(time_s), self.path(time_s)
        self.knots = [knot for knot in self.knots if knot.time_s < time_s]
        slope = (rate - now) / ramp
        self.knots.append(Knot(time_s, path_s, now, slope))
        self.knots.append(Knot(time_s + ramp, path_s + 0.5 * (now + rate) * ramp, rate))


def _time(knot: Knot) -> float:
    return knot.time_s


def _path(knot: Knot) -> float:
    return knot.path_s
