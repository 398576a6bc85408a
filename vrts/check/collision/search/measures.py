"""What is proven of pairs at the middles of their intervals, and throughout these.

Directions are tried in the order of what they cost: the one that served for the longer interval
before it was halved, or that between the boxes; then what is proposed; then what our own search
finds. Only rows that are not settled yet are asked about again. A claim that nobody has proven may
decide that a row is halved, never that it is settled or a contact.
"""

from typing import NamedTuple, TypeAlias

import numpy as np
import numpy.typing as npt

from vrts.check.collision.pairs.findings import BAND, COVERED, PAD, Closest, Findings
from vrts.check.collision.search.broad import Sides
from vrts.check.collision.search.nodes import Level
from vrts.check.collision.search.normals import Rates
from vrts.geometry.proving.prover import Prover
from vrts.geometry.proving.rows import Placed, gaps, placed, uppers
from vrts.geometry.solids import Places

Array: TypeAlias = npt.NDArray[np.float64]
Flags: TypeAlias = npt.NDArray[np.bool_]
Indices: TypeAlias = npt.NDArray[np.int64]

TIGHT = 1e-6  # [m] bounds this near to each other need no better direction
NEAR = 1e-3  # [m] of what may touch, only proofs count
FIRST = 4  # rows that are looked at before all others for a small distance
PROBES = 32  # rows looked at early at each level


class Open(NamedTuple):
    """Pairs of solids in nodes that boxes do not settle; all of shape (r,)."""

    row: Indices
    node: Indices
    outer: Indices  # place of the outer solid
    inner: Indices  # place of the inner one
    gap: Array  # between the boxes [m]
    reach: Array  # how far the pair can come nearer in the node [m]
    way: Array  # (r, 3) direction that served before, outer to inner; NaN where there is none
    floor: Array  # (r,) what stays so far apart is settled, the smallest distance apart [m]
    slack: Array  # (r,) nor does it matter to that, if so much farther apart [m]
    known: Flags  # (r,) whether it lies in an event of which the smallest distance is wanted

    def at(self, which: Indices) -> "Open":
        """Return some of the rows."""
        return Open(
            *(self.row[which], self.node[which], self.outer[which], self.inner[which]),
            *(self.gap[which], self.reach[which], self.way[which]),
            *(self.floor[which], self.slack[which], self.known[which]),
        )


class Measured(NamedTuple):
    """What is proven of such pairs."""

    least: Array  # (r,) they stay apart by so much throughout the node [m]
    lower: Array  # (r,) apart by at least so much at its middle [m]
    upper: Array  # (r,) and at most by so much; inf where nobody needs to know [m]
    way: Array  # (r, 3) the best direction

    def put(self, which: Indices, lower: Array, way: Array) -> None:
        """Take over better directions of some rows."""
        better = lower > self.lower[which]
        self.lower[which[better]] = lower[better]
        self.way[which[better]] = way[better]


class Measures:
    """Measures the rows of a search."""

    def __init__(
        self,
        prover: Prover,
        sides: Sides,
        counts: Flags,
        tolerance: Array,
        found: Findings,
    ) -> None:
        """Take what stays the same at all levels.

        Args:
            prover: Proves distances.
            sides: Which solid of each pair is the outer one.
            counts: Whether a pair enters minimum clearance, shape (p,).
            tolerance: Deeper than this is a contact, shape (p,), in m.
            found: Where the smallest distance is kept.
        """
        self.prover = prover
        self.sides = sides
        self.counts = counts
        self.deep = -tolerance - 1.1 * BAND  # an upper bound below this shows a contact
        self.near = NEAR - np.minimum(tolerance, 0.0)
        self.found = found

    def bar(self, row: Indices, floor: Array, slack: Array | float) -> Array:
        """Return what the least distance of pairs must reach for them to be settled."""
        sought = self.found.closest.distance + slack
        return np.where(self.counts[row], np.maximum(floor, sought), floor)

    def bar_of(self, rows: Open) -> Array:
        """Return the same for rows."""
        return self.bar(rows.row, rows.floor, rows.slack)

    def probe(self, level: Level, places: Places, rows: Open) -> None:
        """Look at the rows that promise the smallest distances."""
        closest = self.found.closest.distance
        best = np.flatnonzero(self.counts[rows.row] & (rows.gap < closest))
        if len(best) > PROBES:
            best = best[np.argpartition(rows.gap[best], PROBES)[:PROBES]]
        best = best[np.argsort(rows.gap[best], kind="stable")]
        for some in (best[:FIRST], best[FIRST:]):
            near = some[rows.gap[some] < self.found.closest.distance]
            if len(near):
                self._probed(level, places, rows.at(near))

    def _probed(self, level: Level, places: Places, rows: Open) -> None:
        a, b = self._placed(places, rows)
        found = self.prover.proposed(a, b)
        upper = uppers(self.prover.solids, a, b, found.first, found.second)
        self._note(level, rows, upper)
        # of hulls no point is known to be inside; and what is claimed may be wrong
        unknown = np.flatnonzero(upper == np.inf)
        self._nearer(level, rows.at(unknown), a.at(unknown), b.at(unknown), found.claim[unknown])

    def _nearer(self, level: Level, rows: Open, a: Placed, b: Placed, claim: Array) -> None:
        """Search ourselves where the smallest distance is claimed, until no claim is smaller."""
        for k in np.argsort(claim, kind="stable").tolist():
            closest = self.found.closest.distance
            if np.isfinite(claim[k]) and claim[k] >= closest:
                break
            one = np.array([k])
            if rows.gap[k] >= closest:
                continue
            found = self.prover.searched_for(
                a.at(one), b.at(one), rows.way[one], apart=np.array([closest])
            )
            self._note(level, rows.at(one), found.upper)

    def of(self, level: Level, places: Places, rates: Rates, rows: Open) -> Measured:
        """Return what is proven of rows."""
        count = len(rows.row)
        a, b = self._placed(places, rows)
        known = np.isfinite(rows.way[:, :1])
        way = np.where(known, rows.way, _between_boxes(places, rows))
        lower = gaps(self.prover.solids, a, b, way)
        found = Measured(np.empty(count), lower, np.full(count, np.inf), way)
        every = np.arange(count)
        self._throughout(found, rates, rows, every)
        asked = np.flatnonzero(found.least < self.bar_of(rows))
        if not len(asked):
            return found
        proposed = self.prover.proposed(a.at(asked), b.at(asked))
        found.put(asked, proposed.lower, proposed.normal)
        self._throughout(found, rates, rows, asked)
        still = found.least[asked] < self.bar_of(rows.at(asked))
        left = asked[still]
        if len(left):
            x, y = proposed.first[still], proposed.second[still]
            found.upper[left] = uppers(self.prover.solids, a.at(left), b.at(left), x, y)
            self._note(level, rows.at(left), found.upper[left])
            self._searched(level, rates, rows, found, left, proposed.claim[still], a, b)
        return found

    def _searched(
        self,
        level: Level,
        rates: Rates,
        rows: Open,
        found: Measured,
        left: Indices,
        claim: Array,
        a: Placed,
        b: Placed,
    ) -> None:
        """Search ourselves for what was proposed badly, or must be known for certain."""
        row, lower, upper = rows.row[left], found.lower[left], found.upper[left]
        # within an event a contact is no news, but how near it comes at least
        deep = np.where(rows.known, -np.inf, self.deep[rows.row])
        loose = ~(upper - lower <= TIGHT) & (upper >= deep[left])
        plain = np.abs(claim - lower) <= TIGHT  # a direction that does what the points claim
        plain &= (lower > self.near[row]) & (level.half[rows.node[left]] > 0.5 * COVERED)
        unknown = np.flatnonzero(loose & plain & self.counts[row])
        if len(unknown):
            one = left[unknown]
            self._nearer(level, rows.at(one), a.at(one), b.at(one), claim[unknown])
        which = left[loose & ~plain]
        if not len(which):
            return
        row = rows.row[which]
        searched = self.prover.searched_for(
            a.at(which),
            b.at(which),
            found.way[which],
            apart=self.bar_of(rows.at(which)) + rows.reach[which],
            deep=deep[which],
        )
        found.put(which, searched.lower, searched.normal)
        found.upper[which] = np.minimum(found.upper[which], searched.upper)
        self._throughout(found, rates, rows, which)
        self._note(level, rows.at(which), searched.upper)

    def _throughout(self, found: Measured, rates: Rates, rows: Open, which: Indices) -> None:
        """Compute how far rows stay apart in all of their nodes, along their directions."""
        approach = rates.approach(which, found.way[which]) + PAD
        found.least[which] = found.lower[which] - np.minimum(rows.reach[which], approach)

    def _note(self, level: Level, rows: Open, upper: Array) -> None:
        """Keep the smallest distance."""
        near = np.flatnonzero(self.counts[rows.row] & (upper < self.found.closest.distance))
        if len(near):
            k = int(near[np.argmin(upper[near])])
            self.found.closest = Closest(
                float(upper[k]), int(rows.row[k]), float(level.middle[rows.node[k]])
            )

    def _placed(self, places: Places, rows: Open) -> tuple[Placed, Placed]:
        outer, inner = self.sides.outer[rows.row], self.sides.inner[rows.row]
        return placed(places, outer, rows.outer), placed(places, inner, rows.inner)


def _between_boxes(places: Places, rows: Open) -> Array:
    """Return unit vectors along which the boxes of rows are apart, or overlap least, (r, 3)."""
    between = places.centres[rows.inner] - places.centres[rows.outer]
    gap = np.abs(between) - places.halves[rows.outer] - places.halves[rows.inner]
    size = np.maximum(gap, 0.0)
    size[np.arange(len(gap)), gap.argmax(axis=1)] += 1e-9  # at least one side
    way = np.copysign(size, between)
    return way / np.sqrt(np.einsum("ri,ri->r", way, way))[:, None]
