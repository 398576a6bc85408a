"""The trajectory timeline: everything the arm and the hand will have done, as polynomials.

The arm and the hand move independently, so they are kept as two tracks; `segments` joins them into
polynomials of seven coordinates without gaps, cut wherever either track is.
"""

from bisect import bisect_right
from collections.abc import Sequence
from itertools import pairwise
from typing import NamedTuple

from vrts.engine.records import Segment
from vrts.robots.model import Configuration


class ArmPiece(NamedTuple):
    """Polynomials of the six joints on an interval, in powers of (t - start_s)."""

    start_s: float
    end_s: float
    rows: tuple[tuple[float, ...], ...]
    motion: int


class Stroke(NamedTuple):
    """The hand opening changes linearly, or stops at once where start and end coincide."""

    start_s: float
    end_s: float
    start_m: float
    end_m: float


class Timeline:
    """Both tracks of a run up to a horizon. A run that grows gets a new one."""

    def __init__(
        self,
        pieces: Sequence[ArmPiece],
        strokes: Sequence[Stroke],
        configuration: Configuration,
        opening_m: float,
        horizon_s: float,
    ) -> None:
        """Take the tracks in time order, and where arm and hand are before the first of each."""
        self._pieces = tuple(pieces)
        self._strokes = tuple(strokes)
        self._configuration = configuration
        self._opening_m = opening_m
        self.horizon_s = horizon_s
        self._segments: tuple[Segment, ...] | None = None
        self._piece_starts = [piece.start_s for piece in self._pieces]
        self._stroke_starts = [stroke.start_s for stroke in self._strokes]

    def configuration(self, time_s: float) -> Configuration:
        """Return the joint positions at a time [rad]."""
        found = bisect_right(self._piece_starts, time_s)
        if not found:
            return self._configuration
        piece = self._pieces[found - 1]
        t = min(time_s, piece.end_s) - piece.start_s
        return tuple(value(row, t) for row in piece.rows)  # type: ignore[return-value]

    def velocity(self, time_s: float) -> Configuration:
        """Return the joint velocities at a time [rad/s]."""
        found = bisect_right(self._piece_starts, time_s)
        if not found or time_s >= self._pieces[found - 1].end_s:
            return (0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
        piece = self._pieces[found - 1]
        t = time_s - piece.start_s
        return tuple(rate(row, t) for row in piece.rows)  # type: ignore[return-value]

    def opening(self, time_s: float) -> float:
        """Return the hand opening at a time [m]."""
        found = bisect_right(self._stroke_starts, time_s)
        if not found:
            return self._opening_m
        return stroke_at(self._strokes[found - 1], time_s)

    @property
    def segments(self) -> tuple[Segment, ...]:
        """Polynomials in seven coordinates from 0 to the horizon, without gaps."""
        if self._segments is None:
            cuts = {0.0, self.horizon_s}
            for item in (*self._pieces, *self._strokes):
                cuts.add(item.start_s)
                cuts.add(item.end_s)
            times = sorted(cut for cut in cuts if cut <= self.horizon_s)
            self._segments = tuple(
                self._segment(start, end) for start, end in pairwise(times) if end > start
            )
        return self._segments

    @property
    def starts(self) -> tuple[float, ...]:
        """Start of every segment [s]."""
        return tuple(segment.start_s for segment in self.segments)

    def _segment(self, start: float, end: float) -> Segment:
        found = bisect_right(self._piece_starts, start)
        piece = self._pieces[found - 1] if found else None
        motion = None
        if piece is not None and start < piece.end_s:
            motion = piece.motion
            rows = tuple(shifted(row, start - piece.start_s) for row in piece.rows)
        else:
            rows = tuple((position,) for position in self.configuration(start))
        opening, after = self.opening(start), self.opening(end)
        found = bisect_right(self._stroke_starts, start)
        if found and self._strokes[found - 1].end_s > start:
            hand = (opening, (after - opening) / (end - start))
        else:
            hand = (opening,)
        return Segment(start, end, (*rows, hand), motion)


def stroke_at(stroke: Stroke, time_s: float) -> float:
    """Return the opening at a time not before the stroke [m]."""
    if time_s >= stroke.end_s:
        return stroke.end_m
    share = (time_s - stroke.start_s) / (stroke.end_s - stroke.start_s)
    return stroke.start_m + share * (stroke.end_m - stroke.start_m)


def shifted(row: tuple[float, ...], by: float) -> tuple[float, ...]:
    """Return the coefficients of the same polynomial in powers of (t - by); degree at most 3."""
    if by == 0.0:
        return row
    c = (*row, 0.0, 0.0, 0.0, 0.0)[:4]
    moved = (
        c[0] + by * (c[1] + by * (c[2] + by * c[3])),
        c[1] + by * (2.0 * c[2] + 3.0 * by * c[3]),
        c[2] + 3.0 * by * c[3],
        c[3],
    )
    return moved[: len(row)]


def value(row: tuple[float, ...], t: float) -> float:
    """Return a polynomial at a time from its start."""
    total = 0.0
    for coefficient in reversed(row):
        total = total * t + coefficient
    return total


def rate(row: tuple[float, ...], t: float) -> float:
    """Return the derivative of a polynomial at a time from its start."""
    total = 0.0
    for power in range(len(row) - 1, 0, -1):
        total = total * t + power * row[power]
    return total
