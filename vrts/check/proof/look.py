"""Solids of a run at chosen instants, and how they meet there: proposals for a certificate."""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from vrts.check.curves.timeline_arrays import Curves
from vrts.check.proof.checker import Moments
from vrts.check.proof.given import Array, Indices, Points, Span
from vrts.check.proof.meeting_points import Met, Placed, parted
from vrts.geometry.solids import Solids
from vrts.robots.model import Arm


class Seen(NamedTuple):
    """The pair of solids that comes nearest at an instant."""

    distance: float  # [m]; below zero they overlap, by at most so much
    first: int  # solids
    second: int
    met: Met  # of one pair


class Look:
    """Looks at solids in a run."""

    def __init__(self, arm: Arm, move: Curves, all_of: Solids) -> None:
        self.arm, self.move, self.all_of = arm, move, all_of

    def pairs(self, at: Moments, a: Indices, b: Indices, k: Indices) -> tuple[Placed, Array]:
        """Return pairs of solids at instants, and where to begin to part them."""
        rotation_a, origin_a, centre_a = at.place(self.all_of, a, k)
        rotation_b, origin_b, centre_b = at.place(self.all_of, b, k)
        return Placed(a, b, rotation_a, origin_a, rotation_b, origin_b), centre_b - centre_a

    def met(self, a: Indices, b: Indices, time_s: Array) -> Met:
        """Return how pairs of solids meet, each at an instant."""
        at = Moments(self.arm, self.move, time_s, time_s)
        pairs, way = self.pairs(at, a, b, np.arange(len(time_s)))
        return parted(self.all_of, pairs, way)

    def nearest(
        self, time_s: Array, sides: Sequence[tuple[Sequence[int], Sequence[int], Span]]
    ) -> list[Seen | None]:
        """Return the nearest pair at each instant, of unions that are there at times."""
        rows = [
            (i, j, k)
            for first, second, (start_s, end_s) in sides
            for k in np.flatnonzero((time_s >= start_s) & (time_s <= end_s)).tolist()
            for i in first
            for j in second
        ]
        found: list[Seen | None] = [None] * len(time_s)
        if not rows:
            return found
        a, b, k = np.array(rows).T
        met = self.met(a, b, time_s[k])
        distance = np.where(met.gap > 0, met.apart, met.gap)
        order = np.argsort(distance, kind="stable")[::-1]
        for row in order.tolist():
            one = Met(*(column[row] for column in met))
            found[k[row]] = Seen(float(distance[row]), int(a[row]), int(b[row]), one)
        return found


def points_of(use: int, shown: Sequence[tuple[float, int, int, Met]]) -> Points:
    """Return pairs of points of single pairs of solids at times."""
    n = len(shown)
    return Points(
        np.full(n, use, dtype=np.int64),
        np.array([time_s for time_s, *_ in shown], dtype=np.float64),
        np.array([(i, j) for _, i, j, _ in shown], dtype=np.int64).reshape(n, 2),
        np.array([met.corners for *_, met in shown], dtype=np.float64).reshape(n, 2, 4, 3),
        np.array([met.weights for *_, met in shown], dtype=np.float64).reshape(n, 4),
    )
