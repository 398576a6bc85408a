"""Events in words of the report: from what is sought to times, parts, points, depth and cause.

What is promised, whoever proposed:

- the deepest or nearest moment is one of the instants that `instants` fixes: of those at which
  the distance is the smallest of all but for a micrometre, the first, and then the first pair;
- the distance told there is within 0.1 mm of the smallest of the whole event. Where an instant so
  near to it is not among the fixed ones, the search's own deepest touch is told instead;
- an event begins and ends at the first and last instants of a grid, 0.25 ms apart, that lie in it.

Many events are told together, since asking for many distances costs little more than for a few.
"""

from collections.abc import Sequence
from typing import Generic, NamedTuple, TypeAlias, TypeVar

import numpy as np
import numpy.typing as npt

from vrts.base.pose import Vector
from vrts.check.collision.pairs.arm_state import Prober, RunRecord
from vrts.check.collision.pairs.findings import GRAZE, SLACK, Closest, Leaves, leaves
from vrts.check.collision.pairs.table import Pairs
from vrts.check.collision.second_opinion import Witness
from vrts.check.collision.telling.cause import cause_at, held_at
from vrts.check.collision.telling.edges import Edge, edges_of
from vrts.check.collision.telling.instants import CELL, Instants, finer_instants, instants_in
from vrts.check.collision.telling.moments import (
    NOWHERE,
    SAME,
    Candidates,
    Deepest,
    deepest,
    nowhere,
)
from vrts.check.collision.telling.sought import Sought, graze
from vrts.check.verdict import Clearance, ContactEvent, NearMiss

Array: TypeAlias = npt.NDArray[np.float64]
Indices: TypeAlias = npt.NDArray[np.int64]
Event = TypeVar("Event", ContactEvent, NearMiss, Clearance)


class Told(NamedTuple, Generic[Event]):
    """An event, and the two solids and the instant at which it is deepest."""

    event: Event
    witness: Witness


class Moment(NamedTuple):
    """Where an event is deepest."""

    pair: int  # row of the pairs
    time_s: float


class Nearest(NamedTuple):
    """Two parts at a moment, how far they are apart at most, and the points that show it."""

    moment: Moment
    parts: tuple[str, str]
    distance: float  # [m]; negative: overlap at least so deep
    first: Vector
    second: Vector

    @property
    def turned(self) -> "Nearest":
        """The same, the second part first."""
        parts = self.parts[1], self.parts[0]
        return Nearest(self.moment, parts, self.distance, self.second, self.first)


class Teller:
    """Tells events of one run."""

    def __init__(
        self, run: RunRecord, prober: Prober, pairs: Pairs, groups: Sequence[tuple[str, str]]
    ) -> None:
        self.run = run
        self.prober = prober
        self.pairs = pairs
        self.groups = groups

    def touches(self, sought: Sequence[Sought]) -> list[Told[ContactEvent]]:
        """Return events of touches."""
        nearest = self._all_nearest(sought)
        return self._events(sought, nearest)

    def near_misses(
        self, sought: Sequence[Sought]
    ) -> tuple[list[Told[NearMiss]], list[Told[ContactEvent]]]:
        """Return near misses, and those of them that are grazes."""
        nearest = self._all_nearest(sought)
        touch = [one.distance < -GRAZE for one in nearest]
        missed = [(s, n) for s, n, hit in zip(sought, nearest, touch, strict=True) if not hit]
        grazed = [
            (_grazing(s, n, self.pairs), n)
            for s, n, hit in zip(sought, nearest, touch, strict=True)
            if hit
        ]
        times = self._times([s for s, _ in missed])
        misses = [
            Told(self._near_miss(s, n, *own), self._witness(n.moment))
            for (s, n), own in zip(missed, times, strict=True)
        ]
        return misses, self._events([s for s, _ in grazed], [n for _, n in grazed])

    def closest(
        self, found: Closest, near: Leaves, misses: Sequence[Told[NearMiss]]
    ) -> Told[Clearance] | None:
        """Return the smallest distance of all.

        Args:
            found: What the search has found.
            near: Intervals in which it may be.
            misses: Near misses, where all that is so near is among them.
        """
        if not np.isfinite(found.distance):
            return None
        if misses:
            return _nearest_of(misses)
        likely = near.at(np.flatnonzero(near.least < found.distance + SLACK))
        (moment,) = self._moments([likely], [np.zeros(len(likely.pair))])
        known = Moment(found.pair, found.time_s)
        (nearest,) = self._nearest([known if moment is None else moment])
        if nearest.distance > found.distance + SLACK:
            (nearest,) = self._nearest([known])
        clearance = Clearance(
            distance_m=nearest.distance,
            tolerance_m=SLACK,
            time_s=nearest.moment.time_s,
            bodies=nearest.parts,
            witnesses=(nearest.first, nearest.second),
        )
        return Told(clearance, self._witness(nearest.moment))

    def _all_nearest(self, sought: Sequence[Sought]) -> list[Nearest]:
        """Return the nearest points of events at their deepest moments."""
        likely = [one.likely for one in sought]
        above = [s.above_of(own.pair) for s, own in zip(sought, likely, strict=True)]
        moments = self._moments(likely, above)
        known = [Moment(one.known.pair, one.known.time_s) for one in sought]
        nearest = self._nearest([m or own for m, own in zip(moments, known, strict=True)])
        worse = [
            k
            for k, (one, found) in enumerate(zip(sought, nearest, strict=True))
            if found.distance + float(one.above_of(np.array([found.moment.pair]))[0])
            > one.best + SLACK
        ]
        for k, found in zip(worse, self._nearest([known[k] for k in worse]), strict=True):
            nearest[k] = found
        names = [self.groups[one.episode.group] for one in sought]
        return [
            own.turned if own.parts[0] == name[1] != own.parts[1] else own
            for own, name in zip(nearest, names, strict=True)
        ]

    def _moments(self, likely: Sequence[Leaves], above: Sequence[Array]) -> list[Moment | None]:
        """Return the deepest moments in intervals, by what is added to distances there."""
        every = leaves(likely)
        event = np.repeat(np.arange(len(likely)), [len(own.pair) for own in likely])
        allowed = np.concatenate([np.empty(0), *above])

        def chosen(which: Indices, found: Instants, known: Deepest) -> Deepest:
            leaf = which[found.leaf]
            candidates = Candidates(
                event[leaf], every.pair[leaf], found.time_s, every.least[leaf], allowed[leaf]
            )
            return deepest(self.prober, self.pairs, candidates, known)

        everywhere, known = np.arange(len(event)), nowhere(len(likely))
        known = chosen(everywhere, instants_in(self.prober, self.pairs, every), known)
        at = known.time_s[event]
        there = np.flatnonzero((every.start_s <= at + CELL) & (at - CELL <= every.end_s))
        finer = finer_instants(self.prober, self.pairs, every.at(there), at[there])
        known = chosen(there, finer, known)
        moments = zip(known.pair.tolist(), known.time_s.tolist(), strict=True)
        return [None if pair == NOWHERE else Moment(pair, time) for pair, time in moments]

    def _nearest(self, moments: Sequence[Moment]) -> list[Nearest]:
        """Return the nearest points at moments."""
        if not moments:
            return []
        pair = np.array([moment.pair for moment in moments])
        first, second = self.pairs.first[pair], self.pairs.second[pair]
        bounds = self.prober.told(first, second, np.array([m.time_s for m in moments]))
        parts = self.prober.solids.parts
        columns = (first, second, bounds.upper, bounds.first, bounds.second)
        rows = zip(*(column.tolist() for column in columns), strict=True)
        return [
            Nearest(moment, (parts[i], parts[j]), distance, tuple(x), tuple(y))
            for moment, (i, j, distance, x, y) in zip(moments, rows, strict=True)
        ]

    def _times(self, sought: Sequence[Sought]) -> list[tuple[float, float]]:
        """Return when events begin and end."""
        wanted: list[Edge] = []
        for one in sought:
            touches = one.episode.touches
            first = min(touches, key=lambda touch: (touch.start_s, touch.time_s))
            last = max(touches, key=lambda touch: (touch.end_s, touch.time_s))
            wanted.append(Edge(one.rows, one.limit, first.start_s, first.time_s, -1))
            wanted.append(Edge(one.rows, one.limit, last.end_s, last.time_s, 1))
        found = edges_of(self.prober, self.pairs, wanted)
        return list(zip(found[::2], found[1::2], strict=True))

    def _events(
        self, sought: Sequence[Sought], nearest: Sequence[Nearest]
    ) -> list[Told[ContactEvent]]:
        rows = zip(sought, nearest, self._times(sought), strict=True)
        return [Told(self._event(s, n, *own), self._witness(n.moment)) for s, n, own in rows]

    def _event(self, one: Sought, nearest: Nearest, start_s: float, end_s: float) -> ContactEvent:
        return ContactEvent(
            *self.groups[one.episode.group],
            parts=nearest.parts,
            start_s=min(start_s, nearest.moment.time_s),
            end_s=max(end_s, nearest.moment.time_s),
            deepest_s=nearest.moment.time_s,
            depth_m=-nearest.distance,
            point=_between(nearest.first, nearest.second),
            held=held_at(self.run, start_s),
            cause=cause_at(self.run, self.prober.curves, start_s),
        )

    def _near_miss(self, one: Sought, nearest: Nearest, start_s: float, end_s: float) -> NearMiss:
        return NearMiss(
            *self.groups[one.episode.group],
            parts=nearest.parts,
            start_s=min(start_s, nearest.moment.time_s),
            end_s=max(end_s, nearest.moment.time_s),
            nearest_s=nearest.moment.time_s,
            distance_m=max(nearest.distance, 0.0),  # less than a graze
            witnesses=(nearest.first, nearest.second),
            held=held_at(self.run, start_s),
            cause=cause_at(self.run, self.prober.curves, start_s),
        )

    def _witness(self, moment: Moment) -> Witness:
        first, second = self.pairs.first[moment.pair], self.pairs.second[moment.pair]
        return Witness(int(first), int(second), moment.time_s)


def _nearest_of(misses: Sequence[Told[NearMiss]]) -> Told[Clearance]:
    """Return the nearest of near misses, the first of several, as the smallest distance of all."""
    least = min(miss.event.distance_m for miss in misses)
    same = [miss for miss in misses if miss.event.distance_m <= least + SAME]
    event, witness = min(same, key=lambda miss: (miss.event.nearest_s, miss.witness))
    clearance = Clearance(event.distance_m, SLACK, event.nearest_s, event.parts, event.witnesses)
    return Told(clearance, witness)


def _grazing(one: Sought, nearest: Nearest, pairs: Pairs) -> Sought:
    """Return a near miss as the graze that it is: round its deepest moment."""
    pair, at = nearest.moment
    touch = one.known._replace(pair=pair, start_s=at, end_s=at, time_s=at)
    return graze(one.episode._replace(start_s=at, end_s=at, touches=(touch,)), pairs)


def _between(a: Vector, b: Vector) -> Vector:
    return (0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1]), 0.5 * (a[2] + b[2]))
