"""The motions given so far, as polynomials of the joints in path time: where the arm is then."""

from bisect import bisect_right
from collections.abc import Iterable
from typing import NamedTuple

from vrts.engine.memory.numbered import Numbered
from vrts.engine.memory.records import INSTANT, ArmPiece, Motion
from vrts.engine.motion.lines.set_points import Piece
from vrts.engine.motion.polynomials import rate, value
from vrts.robots.model import Configuration


class CutOff(NamedTuple):
    """What was taken off, so that it can be put back."""

    path_s: float  # from here on
    pieces: tuple[ArmPiece, ...]  # as they were


class Given:
    """Motions in path time, whose last ones may be taken off again."""

    def __init__(self, initial: Configuration) -> None:
        """Start at rest."""
        self.initial = initial
        self.pieces: list[ArmPiece] = []
        self.motions: Numbered[Motion] = Numbered()
        self.end_s = 0.0  # of the last motion
        self.stayed: Configuration | None = None  # asked for last, by a motion that took no time

    def copy(self) -> "Given":
        """Return independent motions that share the past."""
        other = Given(self.initial)
        other.pieces = self.pieces.copy()
        other.motions = self.motions.copy()
        other.end_s, other.stayed = self.end_s, self.stayed
        return other

    def at(self, path_s: float) -> Configuration:
        """Return the joints at a path time."""
        pieces = self.pieces
        if self.stayed is not None and path_s >= self.end_s:
            return self.stayed
        if not pieces or path_s <= pieces[0].start_s:
            return next((motion.start for motion in self.motions), self.initial)
        piece = pieces[-1]
        if path_s < piece.start_s:
            piece = pieces[bisect_right(pieces, path_s, key=_start) - 1]
        t = min(path_s, piece.end_s) - piece.start_s
        return tuple(value(row, t) for row in piece.rows)  # type: ignore[return-value]

    def rate(self, path_s: float) -> Configuration:
        """Return the velocities in path time just before a path time [rad/s]."""
        k = max(bisect_right(self.pieces, path_s - INSTANT, key=_start) - 1, 0)
        piece = self.pieces[k]
        t = path_s - piece.start_s
        return tuple(rate(row, t) for row in piece.rows)  # type: ignore[return-value]

    def not_before_the_end(self, path_s: float) -> float:
        """Return a path time that is not, by rounding alone, before the end of the last motion."""
        return self.end_s if self.end_s - INSTANT < path_s < self.end_s else path_s

    def add(self, motion: Motion, pieces: Iterable[Piece]) -> None:
        """Give a motion more, with its pieces in path time."""
        number = len(self.motions)
        self.pieces += [ArmPiece(a, b, rows, number) for a, b, rows in pieces]
        self.motions.append(motion)

    def change_last(self, **parts: object) -> None:
        """Change what is known of the last motion."""
        self.motions[-1] = self.motions[-1]._replace(**parts)  # type: ignore[arg-type]

    def cut(self, path_s: float) -> CutOff:
        """Take every piece after a path time off."""
        pieces = self.pieces
        first = bisect_right(pieces, path_s - INSTANT, key=_end)
        removed = tuple(pieces[first:])
        del pieces[first:]
        if removed and removed[0].start_s < path_s - INSTANT:
            pieces.append(removed[0]._replace(end_s=path_s))
        return CutOff(path_s, removed)

    def put_back(self, off: CutOff) -> None:
        """Put back what was taken off, in place of the pieces given since."""
        self.cut(off.path_s)
        if off.pieces[0].start_s < off.path_s - INSTANT:
            self.pieces.pop()
        self.pieces += off.pieces


def _start(piece: ArmPiece) -> float:
    return piece.start_s


def _end(piece: ArmPiece) -> float:
    return piece.end_s
