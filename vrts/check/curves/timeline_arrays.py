"""A timeline as arrays: values, and what they cannot exceed, over any interval of time.

A straight line consists of many short cubics, a joint motion of a few long ones; the few pieces of
a higher degree are kept apart. Bounds over an interval are exact whatever it spans: its first and
last piece by their ends and turning points, the pieces between by the bounds over whole pieces.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import chain
from typing import NamedTuple, TypeAlias

import numpy as np
import numpy.typing as npt

from vrts.check.curves.high_pieces import CUBIC, HighPieces, high_pieces, is_high
from vrts.engine.memory.records import COORDINATES, Segment

Array: TypeAlias = npt.NDArray[np.float64]
Indices: TypeAlias = npt.NDArray[np.int64]

ALL = slice(None)  # coordinates
CONTINUOUS = 1e-8  # [rad, m, s] a step below this is rounding
# [rad/s, m/s] a larger step between pieces is a jump. Smaller ones are ignored: a thousand within
# one interval of 0.3 s move nothing by 1e-6 m; those between set points are about 1e-15
VELOCITY_JUMP = 1e-9


class Spread(NamedTuple):
    """What seven coordinates do over intervals; arrays of shape (m, 7)."""

    lower: Array  # smallest value [rad, m]
    upper: Array  # largest value
    speed: Array  # largest size of the velocity [rad/s, m/s]
    acceleration: Array  # largest size of the acceleration [rad/s^2, m/s^2]


@dataclass(frozen=True, slots=True)
class Curves:
    """Piecewise polynomial motion of seven coordinates."""

    starts: Array  # (n,) [s], increasing
    ends: Array  # (n,) [s]
    powers: Array  # (n, 7, 4), first coefficients, ascending powers of t - start
    motions: Indices  # (n,) index of the motion, -1 while the arm stands still
    turns: Array  # (n, 7, 2) local times of extremes inside the piece; inf where there is none
    turn_values: Array  # (n, 7, 2) values there; 0 where there is none
    bends: Array  # (n, 7) local times of extreme velocity; inf where there is none
    bend_speeds: Array  # (n, 7) size of the velocity there; 0 where there is none
    high: HighPieces | None  # the pieces above degree 3
    high_at: Indices  # (n,) index in `high`, -1 for the others
    each: Array  # (n, 28) maxima of [upper, -lower, speed, acceleration] over each piece

    @property
    def start_s(self) -> float:
        """Start of the first piece."""
        return float(self.starts[0])

    @property
    def end_s(self) -> float:
        """End of the last piece."""
        return float(self.ends[-1])

    @property
    def pieces(self) -> Spread:
        """Bounds over each piece, n of them."""
        return _as_spread(self.each)

    def piece_at(self, t: Array) -> Indices:
        """Return the piece that holds each time: the later one at a joint, the nearest outside."""
        return np.maximum(np.searchsorted(self.starts, t, side="right") - 1, 0)

    def values(self, t: Array, which: slice = ALL) -> Array:
        """Return coordinates, shape (m, 7) or fewer, at times of shape (m,). Constant outside."""
        at = self.piece_at(t)
        u = self._local(at, t)
        found = _values(self.powers[:, which][at], u[:, None])
        rows, high = self._high(at)
        if self.high is not None and len(rows):
            found[rows] = self.high.value.at(high, u[rows])[:, which]
        return found

    def velocities(self, t: Array) -> Array:
        """Return the velocities, shape (m, 7), at times of shape (m,)."""
        at = self.piece_at(t)
        return self._velocities(at, self._local(at, t))

    def jumps(self) -> Array:
        """Return the times between pieces at which a velocity is not continuous."""
        if len(self.starts) < 2:
            return np.empty(0)
        pieces = np.arange(len(self.starts) - 1)
        before = self._velocities(pieces, (self.ends - self.starts)[:-1])
        after = self.powers[1:, :, 1]
        return self.starts[1:][np.abs(before - after).max(axis=1) > VELOCITY_JUMP]

    def steps(self, t0: Array, t1: Array) -> Array:
        """Return the sizes of all steps of the velocity inside of intervals, added up, (m, 7).

        Raises:
            ValueError: A coordinate itself makes a step, or for some time there is no piece.
        """
        pieces = np.arange(len(self.starts) - 1)
        length = (self.ends - self.starts)[:-1]
        late = np.abs(self.starts[1:] - self.ends[:-1]).max(initial=0.0)
        if max(late, self._gap(pieces, length)) > CONTINUOUS:
            raise ValueError("a timeline with a gap")
        sizes = np.abs(self._velocities(pieces, length) - self.powers[1:, :, 1])
        summed = np.vstack([np.zeros((1, COORDINATES)), np.cumsum(sizes, axis=0)])
        first = np.searchsorted(self.starts[1:], t0, side="right")
        last = np.searchsorted(self.starts[1:], t1, side="left")
        return summed[np.maximum(first, last)] - summed[first]

    def _gap(self, pieces: Indices, length: Array) -> float:
        """Return the largest step of a coordinate where one piece meets the next."""
        before = _values(self.powers[pieces], length[:, None])
        rows, high = self._high(pieces)
        if self.high is not None and len(rows):
            before[rows] = self.high.value.at(high, length[rows])
        return float(np.abs(before - self.powers[1:, :, 0]).max(initial=0.0))

    def spread(self, t0: Array, t1: Array) -> Spread:
        """Return exact bounds over intervals; above degree 3 they are wider by rounding.

        Args:
            t0: Starts, shape (m,), in s.
            t1: Ends, shape (m,), not before the starts.
        """
        first = self.piece_at(t0)
        last = np.maximum(np.searchsorted(self.starts, t1, side="left") - 1, first)
        several = last > first
        if np.array_equal(t0, self.starts[first]) and np.array_equal(t1, self.ends[first]):
            return _as_spread(self.each[first])  # whole pieces are known
        u0 = self._local(first, t0)
        u1 = self._local(last, t1)
        split = np.nonzero(several)[0]
        if len(split) == 0:
            return _as_spread(self._within(first, u0, u1))
        # to the end of the first piece, and from the start of the last one
        until = np.where(several, self.ends[first] - self.starts[first], u1)
        both = self._within(
            np.concatenate([first, last[split]]),
            np.concatenate([u0, np.zeros(len(split))]),
            np.concatenate([until, u1[split]]),
        )
        a, b = both[: len(first)], both[len(first) :]
        a[split] = np.maximum(a[split], b)
        between = split[last[split] > first[split] + 1]
        if len(between):
            between = between[np.argsort(first[between], kind="stable")]
            runs = np.stack([first[between] + 1, last[between]], axis=1).ravel()
            inner = np.maximum.reduceat(self.each, runs)[::2]
            a[between] = np.maximum(a[between], inner)
        return _as_spread(a)

    def turn(self, start: Array, middle: Array, end: Array, which: slice) -> Array:
        """Return how far coordinates are from where they are at middles at most, shape (m, k).

        Args:
            start: Starts of intervals, shape (m,), in s.
            middle: Instants within them.
            end: Their ends.
            which: Of the seven coordinates; fewer are less work.
        """
        values = self.values(middle, which)
        lower, upper = self._range(start, end, which)
        return np.maximum(upper - values, values - lower)

    def _range(self, t0: Array, t1: Array, which: slice) -> tuple[Array, Array]:
        """Return the smallest and the largest values over intervals, both (m, k); see `spread`."""
        at = self.piece_at(t0)
        ends = self.ends[at]
        whole = np.array_equal(t0, self.starts[at]) and np.array_equal(t1, ends)
        if whole or (t1 > ends).any():
            spread = self.spread(t0, t1)
            return spread.lower[:, which], spread.upper[:, which]
        u0, u1 = self._local(at, t0), self._local(at, t1)
        lower, upper = self._range_of_cubics(self.powers[:, which][at], at, u0, u1, which)
        rows, high = self._high(at)
        if self.high is not None and len(rows):
            low, most = self.high.value.range(high, u0[rows], u1[rows])
            lower[rows], upper[rows] = low[:, which], most[:, which]
        return lower, upper

    def _local(self, at: Indices, t: Array) -> Array:
        """Return times since the start of pieces, kept inside them."""
        start = self.starts[at]
        return np.clip(t - start, 0.0, self.ends[at] - start)

    def _high(self, at: Indices) -> tuple[Indices, Indices]:
        """Return which of some pieces are above degree 3, and their indices in `high`."""
        high = self.high_at[at]
        rows = np.nonzero(high >= 0)[0]
        return rows, high[rows]

    def _velocities(self, at: Indices, u: Array) -> Array:
        found = _velocities(self.powers[at], u[:, None])
        rows, high = self._high(at)
        if self.high is not None and len(rows):
            found[rows] = self.high.velocity.at(high, u[rows])
        return found

    def _within(self, at: Indices, u0: Array, u1: Array) -> Array:
        """Return [upper, -lower, speed, acceleration], (m, 28), over parts of single pieces."""
        found = self._within_cubics(at, u0, u1)
        rows, high = self._high(at)
        if self.high is not None and len(rows):
            found[rows] = self.high.within(high, u0[rows], u1[rows])
        return found

    def _within_cubics(self, at: Indices, u0: Array, u1: Array) -> Array:
        powers = self.powers[at]
        n = COORDINATES
        found = np.empty((len(at), 4 * n))
        speed, acceleration = found[:, 2 * n : 3 * n], found[:, 3 * n :]
        lower, found[:, :n] = self._range_of_cubics(powers, at, u0, u1, ALL)
        np.negative(lower, out=found[:, n : 2 * n])
        ends = np.array((u0, u1))[:, :, None]
        np.abs(_velocities(powers, ends)).max(axis=0, out=speed)
        bends = self.bends[at]
        inside = (bends > ends[0]) & (bends < ends[1])
        if inside.any():
            np.maximum(speed, np.where(inside, self.bend_speeds[at], 0.0), out=speed)
        np.abs(_accelerations(powers, ends)).max(axis=0, out=acceleration)
        return found

    def _range_of_cubics(
        self, powers: Array, at: Indices, u0: Array, u1: Array, which: slice
    ) -> tuple[Array, Array]:
        """Return the smallest and the largest values over parts of single pieces, both (m, k)."""
        at_ends = _values(powers, np.array((u0, u1))[:, :, None])
        lower, upper = np.minimum(*at_ends), np.maximum(*at_ends)
        turns = self.turns[:, which][at]
        inside = (turns > u0[:, None, None]) & (turns < u1[:, None, None])
        if inside.any():
            values = self.turn_values[:, which][at]
            for turn in range(2):
                now, value = inside[:, :, turn], values[:, :, turn]
                lower = np.minimum(lower, np.where(now, value, np.inf))
                upper = np.maximum(upper, np.where(now, value, -np.inf))
        return lower, upper


def curves(segments: Sequence[Segment]) -> Curves:
    """Return the arrays of a timeline: of the segments that last, or of its only instant.

    Raises:
        ValueError: There is no segment.
    """
    lasting = lasting_of(segments) or segments[:1]
    if not lasting:
        raise ValueError("a timeline without a segment")
    starts = np.array([segment.start_s for segment in lasting])
    ends = np.array([segment.end_s for segment in lasting])
    powers, high, high_at = _powers(lasting, ends - starts)
    motions = np.array([-1 if s.motion is None else s.motion for s in lasting], dtype=np.int64)
    length = (ends - starts)[:, None]
    turns = _roots(powers[:, :, 1], 2.0 * powers[:, :, 2], 3.0 * powers[:, :, 3])
    turns[(turns <= 0.0) | (turns >= length[:, :, None])] = np.inf
    finite = np.isfinite(turns)
    safe = np.where(finite, turns, 0.0)
    turn_values = np.where(finite, _values(powers[:, :, None, :], safe), 0.0)
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        bends = -powers[:, :, 2] / (3.0 * powers[:, :, 3])
    finite = np.isfinite(bends) & (bends > 0.0) & (bends < length)
    bends = np.where(finite, bends, np.inf)
    bend_speeds = np.abs(_velocities(powers, np.where(finite, bends, 0.0))) * finite
    columns = (starts, ends, powers, motions, turns, turn_values, bends, bend_speeds, high, high_at)
    whole = Curves(*columns, np.empty((0, 0)))
    each = whole._within(np.arange(len(starts)), np.zeros(len(starts)), ends - starts)  # pyright: ignore[reportPrivateUsage]
    return Curves(*columns, each)


def lasting_of(segments: Sequence[Segment]) -> list[Segment]:
    """Return the segments that last, which are the pieces of their curves."""
    return [segment for segment in segments if segment.end_s > segment.start_s]


def _powers(segments: Sequence[Segment], length: Array) -> tuple[Array, HighPieces | None, Indices]:
    """Return all coefficients up to degree 3, and the pieces that have more."""
    rows = [row for segment in segments for row in segment.coefficients]
    counts = np.fromiter(map(len, rows), np.int64, len(rows))
    flat = np.fromiter(chain.from_iterable(rows), np.float64, int(counts.sum()))
    order = np.arange(len(flat)) - np.repeat(np.cumsum(counts) - counts, counts)
    powers = np.zeros((len(rows), CUBIC))
    powers[np.arange(CUBIC) < counts[:, None]] = flat[order < CUBIC]  # row after row, both
    powers = powers.reshape(len(segments), COORDINATES, CUBIC)
    high_at = np.full(len(segments), -1, dtype=np.int64)
    longest = counts.reshape(len(segments), COORDINATES).max(axis=1)
    long: list[int] = np.nonzero(longest > CUBIC)[0].tolist()
    pieces = [k for k in long if is_high(segments[k].coefficients)]
    if not pieces:
        return powers, None, high_at
    high_at[pieces] = np.arange(len(pieces))
    high = high_pieces([segments[k].coefficients for k in pieces], length[pieces])
    return powers, high, high_at


def _values(powers: Array, u: Array) -> Array:
    return powers[..., 0] + u * (powers[..., 1] + u * (powers[..., 2] + u * powers[..., 3]))


def _velocities(powers: Array, u: Array) -> Array:
    return powers[..., 1] + u * (2.0 * powers[..., 2] + u * 3.0 * powers[..., 3])


def _accelerations(powers: Array, u: Array) -> Array:
    return 2.0 * powers[..., 2] + 6.0 * powers[..., 3] * u


def _roots(c: Array, b: Array, a: Array) -> Array:
    """Return both real roots of a u^2 + b u + c, last axis 2; not finite where there is none."""
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        half = -0.5 * (b + np.copysign(np.sqrt(b * b - 4.0 * a * c), b))
        roots = np.stack([half / a, c / half], axis=-1)
    return np.where(np.isfinite(roots), roots, np.inf)


def _as_spread(a: Array) -> Spread:
    n = COORDINATES
    return Spread(-a[:, n : 2 * n], a[:, :n], a[:, 2 * n : 3 * n], a[:, 3 * n :])
