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
from vrts.check.collision.pairs.exact import PROBES, Exact, outside
from vrts.check.collision.pairs.findings import (
    BAND,
    COVERED,
    GRAZE,
    REPORTED,
    Closest,
    Findings,
    Touch,
    margin_of,
    pad_of,
    slack_of,
    spans,
)
from vrts.check.collision.pairs.pairs import Pairs
from vrts.check.collision.search.broad import gaps, sides_of
from vrts.check.collision.search.nodes import Level, first_nodes
from vrts.check.collision.search.normals import Normals, Rows, approach
from vrts.check.curves.timeline_arrays import Curves
from vrts.engine.memory.records import GRAVITY
from vrts.geometry.nearest import Engine, Pair
from vrts.geometry.solids import Motion, Places, Solids
from vrts.robots.model import Arm

Array: TypeAlias = npt.NDArray[np.float64]
Flags: TypeAlias = npt.NDArray[np.bool_]
Indices: TypeAlias = npt.NDArray[np.int64]

FINEST = 1e-5  # [s] to which intervals still open are halved
STILL = 0.1  # of the error of a distance: intervals are not halved for what changes it by less
WITHIN = 0.1  # [m] a smallest distance is sought first among bodies this near
BUDGET = 600_000  # exact distances; what is open then is undetermined


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
    engine: Engine,
    *,
    clearance: bool = True,
    band: float = BAND,
) -> Findings:
    """Return every contact and graze, and the smallest distance.

    Args:
        arm: The arm that moves.
        curves: How it moves.
        solids: The convex pieces.
        pairs: Which are tested when, by which rule.
        interval: Start and end of the time to look at, in s.
        engine: What measures distances; its error widens every bound.
        clearance: Whether to look for the smallest distance.
        band: A pair is settled when it stays this far from its tolerance, in m; below zero,
            touches deeper than its tolerance by less than that may be missed.
    """
    return _Search(
        arm, curves, solids, pairs, interval, engine, clearance=clearance, band=band
    ).run()


class _Search:
    """One search under way."""

    def __init__(
        self,
        arm: Arm,
        curves: Curves,
        solids: Solids,
        pairs: Pairs,
        interval: tuple[float, float],
        engine: Engine,
        *,
        clearance: bool,
        band: float,
    ) -> None:
        self.arm = arm
        self.curves = curves
        self.solids = solids
        self.pairs = pairs
        self.engine = engine
        self.pad, self.slack, self.margin = pad_of(engine), slack_of(engine), margin_of(engine)
        self.band = band
        self.still = STILL * engine.error
        self.found = Findings()
        self.counts = pairs.counts & clearance
        if not clearance:
            self.found.closest = Closest(-np.inf, -1, 0.0)
        self.sides = sides_of(solids, pairs)
        self.outer, self.inner, self.inner_frame = self.sides
        self.static = (solids.frame == 0) & ~solids.falls
        self.falls = bool(solids.falls.any())
        # below this a row is not decided: a touch, or for pads what may be too deep
        self.floor = np.where(pairs.grazes, -GRAZE, band - pairs.tolerance)
        self.functions: dict[int, Pair] = {}
        self.spans: dict[int, tuple[Array, Array]] = {}
        self.start, self.end = first_nodes(curves, pairs, interval, falls=self.falls)
        self.level = self._level()
        self.node, self.row = self._first_rows()

    def _first_rows(self) -> tuple[Indices, Indices]:
        """Return the rows of the first nodes that boxes of whole bodies do not settle."""
        level, pairs, found = self.level, self.pairs, self.found
        nodes = (self.start, self.end)
        reached = float(self.floor.max(initial=-np.inf))
        near = max(reached, WITHIN) if self.counts.any() else reached
        while True:
            blocks = gaps(
                *(self.solids, pairs, self.sides, level.state, level.motion, nodes),
                near=near + self.pad,
            )
            counts = np.nonzero(self.counts[blocks.first_row])[0]
            if len(counts):
                best = counts[np.argsort(blocks.middle[counts], kind="stable")[:PROBES]]
                self._probe(*blocks.rows(best))
            if found.closest.distance - self.slack <= near or near == np.inf:
                break
            near = found.closest.distance
        bar = self._bar(blocks.first_row)
        return blocks.rows(np.nonzero(blocks.least - self.pad < bar)[0])

    def _probe(self, node: Indices, row: Indices) -> None:
        """Measure some distances, so that the smallest is known better."""
        placed = self._placed(self.level, row, node)
        gap = outside(placed.places, placed.outer, placed.inner)
        self._exact(self.level, placed.places).probe(row, node, placed.outer, placed.inner, gap)

    def run(self) -> Findings:
        """Halve until nothing is open."""
        found = self.found
        while len(self.row):
            found.levels += 1
            found.nodes += len(self.start)
            found.rows += len(self.row)
            if found.exact > BUDGET:
                self._give_up()
                break
            self._step()
        return found

    def _step(self) -> None:
        level = self.level
        node, row = self.node, self.row
        placed = self._placed(level, row, node)
        places, at_outer, at_inner = placed.places, placed.outer, placed.inner
        bound, arms = self._travel(level, placed)
        reach = bound[self.inner_frame[row], at_outer] + self.pad
        if self.falls:
            inner, outer = self.inner[row], self.outer[row]
            reach += self._drop(level, inner, node) + self._drop(level, outer, node)
        gap = outside(places, at_outer, at_inner)
        exact = self._exact(level, places)
        if self.found.closest.distance > -np.inf:
            exact.probe(row, node, at_outer, at_inner, gap)
        keep = np.nonzero(gap - reach < self._bar(row))[0]
        row, node, gap, reach = row[keep], node[keep], gap[keep], reach[keep]
        at_outer, at_inner = at_outer[keep], at_inner[keep]
        distance, normal = exact.measure(row, node, at_outer, at_inner, gap, reach)
        measured = ~np.isnan(distance)
        least = np.where(measured, distance, gap) - reach
        tight = np.nonzero(measured & (least < self._bar(row)))[0]
        if len(tight):
            a, b, n = at_outer[tight], at_inner[tight], normal[tight]
            apart = self._apart(places, row[tight], a, b, n)
            normals = Normals(n, a, arms, places.centres[a])
            apart -= self._along_normal(level, row[tight], node[tight], normals)
            least[tight] = np.maximum(least[tight], apart)
        self._decide(level, row, node, distance, least, reach)

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

    def _exact(self, level: Level, places: Places) -> Exact:
        columns = (self.engine, self._pair_of, self.counts, self.floor, self.found)
        return Exact(*columns, level.middle, places)

    def _pair_of(self, row: int) -> Pair:
        """Return what measures the distance of a pair."""
        known = self.functions.get(row)
        if known is None:
            shapes = self.solids.shapes
            known = self.engine.pair(shapes[int(self.outer[row])], shapes[int(self.inner[row])])
            self.functions[row] = known
        return known

    def _travel(self, level: Level, placed: _Placed) -> tuple[Array, Array]:
        columns = (placed.solid, placed.instant, placed.places.centres)
        return self.solids.travel(level.state, level.motion, *columns)

    def _drop(self, level: Level, solid: Indices, node: Indices) -> Array:
        motion = Motion(level.half[node], np.empty(0), np.empty(0))
        since = level.middle[node] - self.solids.falls_from[solid]
        return self.solids.drop(motion, since, solid, GRAVITY)

    def _bar(self, row: Indices) -> Array:
        """Return what the least distance of rows must reach for them to be settled."""
        sought = self.found.closest.distance - self.slack
        return np.where(
            self.pairs.counts[row], np.maximum(self.floor[row], sought), self.floor[row]
        )

    def _apart(
        self, places: Places, row: Indices, outer: Indices, inner: Indices, normal: Array
    ) -> Array:
        """Return the gaps along normals at the middle, shape (r,), in m.

        Near touching the normal of an exact distance may be any direction; the gap along it is a
        lower bound all the same, and it is measured, not taken for the distance.
        """
        solids = self.solids
        between = np.einsum("ri,ri->r", places.origins[inner] - places.origins[outer], normal)
        between -= solids.reach(self.outer[row], places.rotations[outer], normal)
        between -= solids.reach(self.inner[row], places.rotations[inner], -normal)
        unit = np.abs(np.linalg.norm(normal, axis=1) - 1.0) < 1e-7
        return np.where(unit, between, -np.inf)

    def _along_normal(self, level: Level, row: Indices, node: Indices, normals: Normals) -> Array:
        """Return how far rows can come nearer along normals, shape (r,), in m."""
        return self.pad + approach(
            self.curves,
            self.solids,
            level,
            Rows(node, self.outer[row], self.inner[row], self.inner_frame[row]),
            normals,
            falls=self.falls,
        )

    def _decide(
        self,
        level: Level,
        row: Indices,
        node: Indices,
        distance: Array,
        least: Array,
        reach: Array,
    ) -> None:
        """Settle rows, note what is found, halve the nodes of the rest."""
        found, pairs = self.found, self.pairs
        alive = least < self._bar(row)
        row, node, distance = row[alive], node[alive], distance[alive]
        least, reach = least[alive], reach[alive]
        length = 2.0 * level.half[node]
        tolerance = pairs.tolerance[row]
        measured = ~np.isnan(distance)
        deep = measured & (distance < -tolerance - self.margin)
        brief = (length <= COVERED) | (reach <= self.pad + self.still)
        whole = deep & (distance + reach < -tolerance - self.margin) & brief
        middle = level.middle[node]
        for k in np.nonzero(deep)[0].tolist():
            t, d = float(middle[k]), float(distance[k])
            if whole[k]:
                start, end = float(self.start[node[k]]), float(self.end[node[k]])
                found.contacts.append(Touch(int(row[k]), start, end, t, d))
            else:
                found.contacts.append(Touch(int(row[k]), t, t, t, d))
        if deep.any():
            found.closest = Closest(-np.inf, -1, 0.0)
            self.spans = spans(found.contacts, pairs.group)
        done = whole
        if self.spans:
            done |= (length <= COVERED) & self._covered(row, node)
        harmless = least > self.band - tolerance  # cannot be a contact any more
        short = harmless & (length <= REPORTED) & (least >= self._sought(row))
        grazing = measured & harmless & (distance + reach < -GRAZE) & pairs.grazes[row]
        touching = (short | grazing) & measured & pairs.grazes[row] & (distance < -GRAZE) & ~done
        found.grazes += self._touches(np.nonzero(touching)[0], row, node, middle, distance)
        done |= short | grazing
        sharp = np.where(measured, distance - least <= 2.0 * self.pad, length <= 0.1 * FINEST)
        resolved = (length <= FINEST) | (distance - least <= self.pad + self.still)
        finest = ~harmless & ~deep & resolved & sharp & ~done
        shallow = finest & (distance > BAND - tolerance) & (least > -tolerance)
        grazed = shallow & pairs.grazes[row] & (distance < -GRAZE)
        found.grazes += self._touches(np.nonzero(grazed)[0], row, node, middle, distance)
        found.open += self._touches(np.nonzero(finest & ~shallow)[0], row, node, middle, distance)
        done |= finest
        self._halve(row[~done], node[~done])

    def _touches(
        self, which: Indices, row: Indices, node: Indices, middle: Array, distance: Array
    ) -> list[Touch]:
        columns = (row, self.start[node], self.end[node], middle, distance)
        return [
            Touch(*values) for values in zip(*(c[which].tolist() for c in columns), strict=True)
        ]

    def _sought(self, row: Indices) -> Array:
        sought = self.found.closest.distance - self.slack
        return np.where(self.pairs.counts[row], sought, -np.inf)

    def _covered(self, row: Indices, node: Indices) -> Flags:
        """Return which rows lie between two contacts of one event."""
        covered = np.zeros(len(row), dtype=np.bool_)
        group = self.pairs.group[row]
        for number, (starts, ends) in self.spans.items():
            mine = np.nonzero(group == number)[0]
            at = np.searchsorted(starts, self.start[node[mine]] + REPORTED, side="right") - 1
            inside = (at >= 0) & (self.end[node[mine]] - REPORTED <= ends[np.maximum(at, 0)])
            covered[mine] = inside
        return covered

    def _halve(self, row: Indices, node: Indices) -> None:
        used, again = np.unique(node, return_inverse=True)
        start, end = self.start[used], self.end[used]
        middle = 0.5 * (start + end)
        self.start = np.concatenate([start, middle])
        self.end = np.concatenate([middle, end])
        self.row = np.concatenate([row, row])
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
