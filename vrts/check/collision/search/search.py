"""The certified search: intervals of time halved until every one is decided.

A row is a pair of solids in an interval (a node). With the signed distance d at the middle and a
bound b on how far the solids can approach each other before the ends, the distance is at least
d - b throughout. Two bounds are used, the smaller counts:

- of length: the turn of each joint between the two times the largest distance from its axis;
- of speed and acceleration, along the normal n at the middle: |v.n| h + |n x w| r h + a h^2 / 2,
  taken from the gap along n at the middle, since the gap along one direction is never more than
  the distance of convex shapes. So sliding past each other closely costs few nodes.

Boxes along the axes settle most rows without an exact distance, and none is asked for while the
bound is above `CAP`. All rows of all intervals are handled together, level by level.
[Schwarzer2005]_ proves the halving with one distance and one bound to miss nothing.
"""

from typing import NamedTuple, TypeAlias

import numpy as np
import numpy.typing as npt

from vrts.check.collision.pairs.arm_state import instants_of
from vrts.check.collision.pairs.findings import (
    BAND,
    COVERED,
    GRAZE,
    HARDLY,
    LEAF,
    PAD,
    REPORTED,
    SLACK,
    Closest,
    Findings,
    Leaves,
    Touch,
)
from vrts.check.collision.pairs.outside import outside
from vrts.check.collision.pairs.table import Pairs
from vrts.check.collision.search.broad import gaps, sides_of
from vrts.check.collision.search.known_events import KnownEvents, Times
from vrts.check.collision.search.measures import PROBES, Measured, Measures, Open
from vrts.check.collision.search.nodes import Level, first_nodes
from vrts.check.collision.search.normals import Rows, rates
from vrts.check.curves.timeline_arrays import Curves
from vrts.engine.memory.records import GRAVITY
from vrts.geometry.proposing.proposer import Proposer
from vrts.geometry.proving.prover import Prover
from vrts.geometry.solids import Motion, Places, Solids
from vrts.robots.model import Arm

Array: TypeAlias = npt.NDArray[np.float64]
Flags: TypeAlias = npt.NDArray[np.bool_]
Indices: TypeAlias = npt.NDArray[np.int64]

FINEST = 1e-5  # [s] to which intervals still open are halved
STILL = 1e-6  # [m] intervals are not halved for what changes a distance by less
CAP = 0.03  # [m] nothing but boxes is looked at while a pair can come nearer by more
WITHIN = 0.1  # [m] a smallest distance is sought first among bodies this near
BUDGET = 600_000  # questions about distances; what is open then is undetermined


class _Placed(NamedTuple):
    """Where the solids of rows are, each solid at each instant once."""

    places: Places
    solid: Indices  # (m,) of the places
    instant: Indices  # (m,)
    outer: Indices  # (r,) index of the place of each row's outer solid
    inner: Indices  # (r,)


def search(
    arm: Arm,
    curves: Curves,
    solids: Solids,
    pairs: Pairs,
    interval: tuple[float, float],
    proposer: Proposer,
    *,
    clearance: bool = True,
    band: float = BAND,
    nearest: bool = False,
    near: float | None = None,
    begins: Array | None = None,
    budget: int = BUDGET,
) -> Findings:
    """Return every contact and graze, and the smallest distance.

    Args:
        arm: The arm that moves.
        curves: How it moves.
        solids: The convex pieces.
        pairs: Which are tested when, by which rule.
        interval: Start and end of the time to look at, in s.
        proposer: Proposes directions and points; nothing rests on it but how long this takes.
        clearance: Whether to look for the smallest distance.
        band: A pair is settled when it stays this far from its tolerance, in m; below zero,
            touches deeper than its tolerance by less than that may be missed.
        nearest: Whether, of each event, the smallest distance is wanted to `SLACK`, and not all
            of the time that it lasts.
        near: Of pairs that enter the smallest distance, those nearer than this are noted too [m],
            and of each such event the smallest distance is wanted; None: they are not.
        begins: Times at which another motion begins, that has nothing to do with the one before:
            contacts that are known of one say nothing about the other [s]; None: it is one motion.
        budget: Questions about distances; what is open then is undetermined.
    """
    wanted = _Wanted(clearance, band, nearest, near, begins, budget)
    return _Search(arm, curves, Prover(solids, proposer), pairs, interval, wanted).run()


class _Wanted(NamedTuple):
    """What a search is to find; see `search`."""

    clearance: bool
    band: float
    nearest: bool
    near: float | None
    begins: Array | None
    budget: int


class _Search:
    """One search under way."""

    def __init__(
        self,
        arm: Arm,
        curves: Curves,
        prover: Prover,
        pairs: Pairs,
        interval: tuple[float, float],
        wanted: _Wanted,
    ) -> None:
        self.arm = arm
        self.curves = curves
        self.prover = prover
        self.solids = solids = prover.solids
        self.pairs = pairs
        self.band = band = wanted.band
        self.nearest = wanted.nearest
        self.found = Findings()
        self.counts = pairs.counts & wanted.clearance
        if not wanted.clearance:
            self.found.closest = Closest(-np.inf, -1, 0.0)
        self.sides = sides_of(solids, pairs)
        self.outer, self.inner, self.inner_frame = self.sides
        self.static = (solids.frame == 0) & ~solids.falls
        self.falls = bool(solids.falls.any())
        # below this a row is not decided: a touch, or for pads what may be too deep
        floor = np.where(pairs.grazes, -GRAZE, band - pairs.tolerance)
        self.measures = Measures(prover, self.sides, self.counts, pairs.tolerance, self.found)
        self.known = KnownEvents(pairs, floor, nearest=wanted.nearest, begins=wanted.begins)
        self.budget = wanted.budget
        self.threshold = -np.inf if wanted.near is None else wanted.near
        self.known.look_near(self.counts, self.threshold)
        self.start, self.end = first_nodes(curves, pairs, interval, falls=self.falls)
        self.level = self._level()
        self.node, self.row = self._first_rows()
        self.way = np.full((len(self.row), 3), np.nan)
        self.noted = np.zeros(len(self.row), dtype=np.bool_)  # lies within a leaf

    def _first_rows(self) -> tuple[Indices, Indices]:
        """Return the rows of the first nodes that boxes of whole bodies do not settle."""
        level, pairs, found = self.level, self.pairs, self.found
        nodes = (self.start, self.end)
        floor = np.maximum(self.known.floor, self.known.near_floor)
        reached = float(floor.max(initial=-np.inf))
        near = max(reached, WITHIN) if self.counts.any() else reached
        while True:
            blocks = gaps(
                *(self.solids, pairs, self.sides, level.state, level.motion, nodes),
                near=near + PAD,
            )
            counts = np.nonzero(self.counts[blocks.first_row])[0]
            if len(counts):
                best = counts[np.argsort(blocks.middle[counts], kind="stable")[:PROBES]]
                self._probe(*blocks.rows(best))
            if found.closest.distance + SLACK <= near or near == np.inf:
                break
            near = found.closest.distance + SLACK
        bar = self.measures.bar(blocks.first_row, floor[blocks.first_row], SLACK)
        return blocks.rows(np.nonzero(blocks.least - PAD < bar)[0])

    def _probe(self, node: Indices, row: Indices) -> None:
        """Measure some distances, so that the smallest is known better."""
        placed = self._placed(self.level, row, node)
        gap = outside(placed.places, placed.outer, placed.inner)
        unknown = np.full((len(row), 3), np.nan)
        nothing = np.zeros(len(row))
        never = np.zeros(len(row), dtype=np.bool_)
        rows = Open(
            *(row, node, placed.outer, placed.inner, gap),
            *(nothing, unknown, nothing, nothing, never),
        )
        self.measures.probe(self.level, placed.places, rows)

    def run(self) -> Findings:
        """Halve until nothing is open."""
        found = self.found
        while len(self.row):
            found.levels += 1
            found.nodes += len(self.start)
            found.rows += len(self.row)
            if self.prover.asked + self.prover.searched > self.budget:
                self._give_up()
                break
            self._step()
        found.asked, found.searched = self.prover.asked, self.prover.searched
        return found

    def _step(self) -> None:
        level, row, node = self.level, self.row, self.node
        placed = self._placed(level, row, node)
        places, at_outer, at_inner = placed.places, placed.outer, placed.inner
        bound, arms = self._travel(level, placed)
        reach = bound[self.inner_frame[row], at_outer] + PAD
        if self.falls:
            inner, outer = self.inner[row], self.outer[row]
            reach += self._drop(level, inner, node) + self._drop(level, outer, node)
        gap = outside(places, at_outer, at_inner)
        slack = np.where(self.noted, -SLACK, SLACK)
        floor, known = self.known.floors(self._times(row, node), slack)
        rows = Open(row, node, at_outer, at_inner, gap, reach, self.way, floor, slack, known)
        if self.found.closest.distance > -np.inf:
            self.measures.probe(level, places, rows)
        alive = np.flatnonzero(gap - reach < self.measures.bar_of(rows))
        rows, self.noted = rows.at(alive), self.noted[alive]
        least = rows.gap - rows.reach
        found = Measured(least, rows.gap.copy(), np.full(len(least), np.inf), rows.way)
        near = np.flatnonzero(rows.reach <= CAP)
        if len(near):
            some = rows.at(near)
            which = Rows(
                some.node, self.outer[some.row], self.inner[some.row], self.inner_frame[some.row]
            )
            moving = rates(
                *(self.curves, self.solids, level, which, arms[:, some.outer]),
                places.centres[some.outer],
                falls=self.falls,
            )
            measured = self.measures.of(level, places, moving, some)
            found.least[near] = np.maximum(least[near], measured.least)
            found.lower[near] = np.maximum(some.gap, measured.lower)
            found.upper[near] = measured.upper
            found.way[near] = measured.way
        self._decide(level, rows, found)

    def _level(self) -> Level:
        middle, half = 0.5 * (self.start + self.end), 0.5 * (self.end - self.start)
        spread = self.curves.spread(self.start, self.end)
        values = self.curves.values(middle)
        turn = np.maximum(spread.upper - values, values - spread.lower)
        state = instants_of(self.arm, values, middle)
        return Level(middle, half, spread, state, Motion(half, turn[:, :6], turn[:, 6]))

    def _placed(self, level: Level, row: Indices, node: Indices) -> _Placed:
        """Place the two solids of every row, each once, and what never moves once for all."""
        count = len(level.middle)
        outer, inner = self.outer[row], self.inner[row]
        key_outer = outer * count + node
        key_inner = inner * count + np.where(self.static[inner], 0, node)
        place_of, known = _distinct(key_outer, key_inner, len(self.static) * count)
        solid, instant = np.divmod(known, count)
        places = self.solids.places(level.state, solid, instant, GRAVITY)
        return _Placed(places, solid, instant, place_of[key_outer], place_of[key_inner])

    def _travel(self, level: Level, placed: _Placed) -> tuple[Array, Array]:
        columns = (placed.solid, placed.instant, placed.places.centres)
        return self.solids.travel(level.state, level.motion, *columns)

    def _drop(self, level: Level, solid: Indices, node: Indices) -> Array:
        motion = Motion(level.half[node], np.empty(0), np.empty(0))
        since = level.middle[node] - self.solids.falls_from[solid]
        return self.solids.drop(motion, since, solid, GRAVITY)

    def _decide(self, level: Level, rows: Open, measured: Measured) -> None:
        """Settle rows, note what is found, halve the nodes of the rest."""
        found, pairs = self.found, self.pairs
        alive = np.flatnonzero(measured.least < self.measures.bar_of(rows))
        row, node, reach = rows.row[alive], rows.node[alive], rows.reach[alive]
        least, lower, upper, way = (column[alive] for column in measured)
        noted = self.noted[alive]
        length = 2.0 * level.half[node]
        tolerance = pairs.tolerance[row]
        known = upper < np.inf
        deep = upper < -tolerance - BAND
        brief = (length <= COVERED) | (reach <= PAD + STILL)
        whole = deep & (upper + reach < -tolerance - BAND) & brief
        middle = level.middle[node]
        for k in np.nonzero(deep)[0].tolist():
            t, d, low = float(middle[k]), float(upper[k]), float(lower[k])
            if whole[k]:
                start, end = float(self.start[node[k]]), float(self.end[node[k]])
                found.contacts.append(Touch(int(row[k]), start, end, t, d, low))
            else:
                found.contacts.append(Touch(int(row[k]), t, t, t, d, low))
        if deep.any():
            found.closest = Closest(-np.inf, -1, 0.0)
            self.known.touched(found.contacts)
        hit = np.flatnonzero(self.counts[row] & (upper < self.threshold - HARDLY))
        if len(hit):
            found.near += self._touches(hit, row, node, upper, lower)
            self.known.neared(found.near)
        times, slack = self._times(row, node), np.where(noted, -SLACK, SLACK)
        done = self._known(times, least, whole, slack)
        harmless = least > self.band - tolerance  # cannot be a contact any more
        short = harmless & (length <= REPORTED) & (least >= self._sought(row))
        grazing = harmless & (upper + reach < -GRAZE) & pairs.grazes[row]
        touching = (short | grazing) & pairs.grazes[row] & (upper < -GRAZE) & ~done
        found.grazes += self._touches(np.nonzero(touching)[0], row, node, upper, lower)
        done |= short | grazing
        # what cannot be measured any better is not halved for ever
        sharp = (upper - least <= 2.0 * PAD) | (length <= 0.1 * FINEST)
        resolved = (length <= FINEST) | (upper - least <= PAD + STILL)
        finest = ~harmless & ~deep & resolved & sharp & ~done
        shallow = finest & known & (lower > BAND - tolerance) & (least > -tolerance)
        grazed = shallow & pairs.grazes[row] & (upper < -GRAZE)
        found.grazes += self._touches(np.nonzero(grazed)[0], row, node, upper, lower)
        found.open += self._touches(np.nonzero(finest & ~shallow)[0], row, node, upper, lower)
        done |= finest
        far = (least >= self.known.nears(times, slack)) | (length <= FINEST)
        done &= far | (resolved & sharp)
        wanted = ~noted & (done | (length <= LEAF) | (reach <= PAD + STILL))
        self._note(times, least, wanted)
        self.noted = (noted | wanted)[~done]
        self._halve(row[~done], node[~done], way[~done])

    def _touches(
        self, which: Indices, row: Indices, node: Indices, upper: Array, lower: Array
    ) -> list[Touch]:
        middle = self.level.middle[node]
        columns = (row, self.start[node], self.end[node], middle, upper, lower)
        return [
            Touch(*values) for values in zip(*(c[which].tolist() for c in columns), strict=True)
        ]

    def _times(self, row: Indices, node: Indices) -> Times:
        return Times(row, self.start[node], self.end[node])

    def _note(self, times: Times, least: Array, wanted: Flags) -> None:
        """Keep intervals that may hold a smallest distance."""
        which = np.flatnonzero(wanted)
        some, slack = times.at(which), np.full(len(which), SLACK)
        if self.nearest:
            near = least[which] < self.known.matters(some, slack)
        else:
            bar = np.maximum(self.known.nears(some, slack), self.found.closest.distance + SLACK)
            near = self.counts[some.row] & (least[which] < bar)
        if near.any():
            self.found.leaves.append(Leaves(*some.at(np.flatnonzero(near)), least[which[near]]))

    def _sought(self, row: Indices) -> Array:
        sought = self.found.closest.distance - SLACK
        return np.where(self.pairs.counts[row], sought, -np.inf)

    def _known(self, times: Times, least: Array, whole: Flags, slack: Array) -> Flags:
        """Return which rows can add nothing to the events that are known."""
        length, matters = times.end_s - times.start_s, self.known.matters(times, slack)
        if self.nearest:
            return (least >= matters) | (length <= FINEST)
        return whole | ((length <= COVERED) & (least >= matters))

    def _halve(self, row: Indices, node: Indices, way: Array) -> None:
        used, again = np.unique(node, return_inverse=True)
        start, end = self.start[used], self.end[used]
        middle = 0.5 * (start + end)
        self.start = np.concatenate([start, middle])
        self.end = np.concatenate([middle, end])
        self.row = np.concatenate([row, row])
        self.way = np.concatenate([way, way])  # what served for the whole serves its halves
        self.noted = np.concatenate([self.noted, self.noted])
        self.node = np.concatenate([again, again + len(used)])
        if len(row):
            self.level = self._level()

    def _give_up(self) -> None:
        for row, node in zip(self.row.tolist(), self.node.tolist(), strict=True):
            if np.isinf(self.pairs.tolerance[row]):
                continue
            start, end = float(self.start[node]), float(self.end[node])
            self.found.open.append(Touch(row, start, end, 0.5 * (start + end), np.nan))


def _distinct(a: Indices, b: Indices, size: int) -> tuple[Indices, Indices]:
    """Return where each key has its place among the distinct keys, and those keys."""
    seen = np.zeros(size, dtype=np.bool_)
    seen[a] = True
    seen[b] = True
    known = np.nonzero(seen)[0]
    place = np.empty(size, dtype=np.int64)
    place[known] = np.arange(len(known))
    return place, known
