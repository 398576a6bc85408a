"""Distances at the middles of one level: by boxes for all rows, exact ones where needed."""

from collections.abc import Callable
from typing import TypeAlias

import numpy as np
import numpy.typing as npt

from vrts.check.collision.pairs.findings import Closest, Findings, slack_of
from vrts.geometry.nearest import Engine, Pair, Transform
from vrts.geometry.solids import Places

Array: TypeAlias = npt.NDArray[np.float64]
Flags: TypeAlias = npt.NDArray[np.bool_]
Indices: TypeAlias = npt.NDArray[np.int64]

CAP = 0.03  # [m] no exact distance while the bound is larger
PROBES = 32  # rows of a level measured early, to find a small distance soon


class Exact:
    """Asks for exact distances at the middles of a level."""

    def __init__(
        self,
        engine: Engine,
        pair_of: Callable[[int], Pair],
        counts: Flags,
        floor: Array,
        found: Findings,
        middle: Array,
        places: Places,
    ) -> None:
        """Prepare for one level.

        Args:
            engine: What measures.
            pair_of: Returns what measures a pair of solids.
            counts: Whether a pair enters minimum clearance, shape (p,).
            floor: At this least distance a pair is settled, clearance apart, shape (p,), in m.
            found: Where the smallest distance and the number of questions are kept.
            middle: Middles of the intervals, shape (n,), in s.
            places: Where solids are then; their rows are `outer` and `inner` below.
        """
        self.engine = engine
        self.slack = slack_of(engine)
        self.pair_of = pair_of
        self.counts = counts
        self.floor = floor
        self.found = found
        self.middle = middle
        self.places = places
        self.transforms: list[Transform | None] = [None] * len(places.origins)

    def probe(
        self, row: Indices, node: Indices, outer: Indices, inner: Indices, gap: Array
    ) -> None:
        """Look at the rows that promise the smallest distances."""
        counts = self.counts[row] & (gap < self.found.closest.distance)
        rows = np.nonzero(counts)[0]
        if len(rows) > PROBES:
            rows = rows[np.argpartition(gap[rows], PROBES)[:PROBES]]
        for k in rows[np.argsort(gap[rows])].tolist():
            if gap[k] < self.found.closest.distance:
                self._distance(int(row[k]), int(node[k]), int(outer[k]), int(inner[k]))

    def measure(
        self, row: Indices, node: Indices, outer: Indices, inner: Indices, gap: Array, reach: Array
    ) -> tuple[Array, Array]:
        """Return distances, shape (r,), NaN where none was needed, and normals, shape (r, 3)."""
        count = len(row)
        distance = np.full(count, np.nan)
        normal = np.zeros((count, 3))
        within = np.nonzero(reach <= CAP)[0]
        within = within[np.argsort(gap[within], kind="stable")]
        least = (gap - reach)[within].tolist()
        floor = self.floor[row[within]].tolist()
        columns = zip(
            within.tolist(),
            least,
            floor,
            row[within].tolist(),
            node[within].tolist(),
            outer[within].tolist(),
            inner[within].tolist(),
            strict=True,
        )
        for k, low, bottom, r, n, a, b in columns:
            if low >= bottom and low >= self.found.closest.distance - self.slack:
                continue
            distance[k] = self._distance(r, n, a, b)
            normal[k] = self.pair_of(r).normal
        return distance, normal

    def _distance(self, row: int, node: int, outer: int, inner: int) -> float:
        self.found.exact += 1
        distance = self.pair_of(row).distance(self._transform(outer), self._transform(inner))
        if distance < self.found.closest.distance and self.counts[row]:
            self.found.closest = Closest(distance, row, float(self.middle[node]))
        return distance

    def _transform(self, at: int) -> Transform:
        known = self.transforms[at]
        if known is None:
            known = self.engine.transform(self.places.rotations[at], self.places.origins[at])
            self.transforms[at] = known
        return known


def outside(places: Places, a: Indices, b: Indices) -> Array:
    """Return a lower bound on signed distances, (r,), from the boxes along the axes.

    Boxes that overlap say little: the shapes in them cannot overlap deeper than the boxes do.
    """
    square = np.zeros(len(a))
    widest = np.full(len(a), -np.inf)
    for axis in range(3):
        centre = np.ascontiguousarray(places.centres[:, axis])
        half = np.ascontiguousarray(places.halves[:, axis])
        gap = np.abs(centre[a] - centre[b])
        gap -= half[a]
        gap -= half[b]
        np.maximum(widest, gap, out=widest)
        np.maximum(gap, 0.0, out=gap)
        gap *= gap
        square += gap
    return np.where(widest > 0.0, np.sqrt(square), widest)
