"""The trajectory timeline: everything the arm and the hand will have done, as polynomials.

The arm and the hand move independently, so they are kept as two tracks; `segments` joins them into
polynomials of seven coordinates without gaps, cut wherever either track is. The arm's pieces are in
path time; where the operator's speed is not 100 % they are composed with the time scaling.
"""

from bisect import bisect_right
from collections.abc import Iterator, Sequence
from functools import cached_property
from itertools import pairwise

from vrts.engine.memory.records import INSTANT, ArmPiece, Segment, Stroke, stroke_at
from vrts.engine.motion.polynomials import composed, rate, shifted, value
from vrts.engine.motion.time_scale import TimeScale
from vrts.robots.model import Configuration

STILL: Configuration = (0.0, 0.0, 0.0, 0.0, 0.0, 0.0)


class Timeline:
    """Both tracks of a run up to a horizon. A run that grows gets a new one."""

    def __init__(
        self,
        pieces: Sequence[ArmPiece],
        scale: TimeScale,
        strokes: Sequence[Stroke],
        configuration: Configuration,
        opening_m: float,
        horizon_s: float,
    ) -> None:
        """Take the tracks in time order, and where arm and hand are before the first of each."""
        self._in_path_time = pieces
        self._scale = scale
        self._strokes = strokes
        self._configuration = configuration
        self._opening_m = opening_m
        self.horizon_s = horizon_s
        self._segments: tuple[Segment, ...] | None = None
        self._stroke_starts = [stroke.start_s for stroke in strokes]

    @cached_property
    def _pieces(self) -> Sequence[ArmPiece]:
        """The pieces in run time."""
        if self._scale.plain:
            return self._in_path_time
        return in_run_time(self._in_path_time, self._scale, self.horizon_s)

    @cached_property
    def _piece_starts(self) -> Sequence[float]:
        return [piece.start_s for piece in self._pieces]

    def configuration(self, time_s: float) -> Configuration:
        """Return the joint positions at a time [rad]. Nothing is composed for it."""
        path_s = time_s if self._scale.plain else self._scale.path(time_s)
        found = bisect_right(self._in_path_time, path_s, key=_start)
        if not found:
            return self._configuration
        piece = self._in_path_time[found - 1]
        t = min(path_s, piece.end_s) - piece.start_s
        return tuple([value(row, t) for row in piece.rows])  # type: ignore[return-value]

    def velocity(self, time_s: float) -> Configuration:
        """Return the joint velocities at a time [rad/s]."""
        found = bisect_right(self._piece_starts, time_s)
        if not found or time_s >= self._pieces[found - 1].end_s:
            return STILL
        piece = self._pieces[found - 1]
        t = time_s - piece.start_s
        return tuple([rate(row, t) for row in piece.rows])  # type: ignore[return-value]

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
            times: list[float] = []
            for cut in sorted(cuts):
                if cut <= self.horizon_s and (not times or cut > times[-1] + INSTANT):
                    times.append(cut)
            self._segments = tuple(self._between(times))
        return self._segments

    @property
    def segments_or_start(self) -> tuple[Segment, ...]:
        """The same; of a run without any time the instant at which everything stands still."""
        if self.segments:
            return self.segments
        rows = tuple((position,) for position in self.configuration(0.0))
        return (Segment(0.0, 0.0, (*rows, (self.opening(0.0),)), None),)

    @property
    def starts(self) -> tuple[float, ...]:
        """Start of every segment [s]."""
        return tuple(segment.start_s for segment in self.segments)

    def _between(self, times: Sequence[float]) -> Iterator[Segment]:
        """Yield the segments between times, of which no piece and no stroke begins within one."""
        pieces, starts, strokes = self._pieces, self._piece_starts, self._stroke_starts
        of_arm = of_hand = 0  # how many have begun
        resting = (self._opening_m,)
        for start, end in pairwise(times):
            while of_arm < len(starts) and starts[of_arm] <= start + INSTANT:
                of_arm += 1
            while of_hand < len(strokes) and strokes[of_hand] <= start:
                of_hand += 1
            piece = pieces[of_arm - 1] if of_arm else None
            motion = None
            if piece is not None and start < piece.end_s - INSTANT:
                motion = piece.motion
                by = start - piece.start_s
                rows = tuple([shifted(row, by) for row in piece.rows]) if by else piece.rows
            else:
                rows = tuple([(position,) for position in self.configuration(start)])
            stroke = self._strokes[of_hand - 1] if of_hand else None
            now = self._opening_m if stroke is None else stroke_at(stroke, start)
            if stroke is not None and stroke.end_s > start:
                hand = (now, (self.opening(end) - now) / (end - start))
            else:
                if now != resting[0]:
                    resting = (now,)
                hand = resting
            yield Segment(start, end, (*rows, hand), motion)


def _start(piece: ArmPiece) -> float:
    return piece.start_s


def in_run_time(pieces: Sequence[ArmPiece], scale: TimeScale, until_s: float) -> Sequence[ArmPiece]:
    """Return pieces as polynomials of the run time, composed with a time scaling."""
    found: list[ArmPiece] = []
    for piece in pieces:
        start = scale.time(piece.start_s)
        if start > until_s:
            break
        end = min(scale.time(piece.end_s), until_s + 1.0)
        for begin, stop, path in scale.pieces(start, end):
            inner = (path[0] - piece.start_s, *path[1:])
            rows = tuple([composed(row, inner) for row in piece.rows])
            found.append(ArmPiece(begin, stop, rows, piece.motion))
    return found
