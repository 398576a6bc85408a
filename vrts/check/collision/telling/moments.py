"""Which pair is deepest, or nearest, at which instant: of many events at once.

What is compared is the distance of pairs at fixed instants. Lower bounds rule most of them out:
boxes, what the search has proven, and gaps along directions that served at other instants. The
others are measured with the help of a proposer, and where that leaves open which is first, by
ourselves alone (`Prover.told`). So the answer is one of a table that nobody's proposals change.
"""

from typing import NamedTuple, TypeAlias

import numpy as np
import numpy.typing as npt

from vrts.check.collision.pairs.arm_state import Prober
from vrts.check.collision.pairs.table import Pairs
from vrts.geometry.proving.prover import EXACT
from vrts.geometry.proving.rows import gaps

Array: TypeAlias = npt.NDArray[np.float64]
Flags: TypeAlias = npt.NDArray[np.bool_]
Indices: TypeAlias = npt.NDArray[np.int64]

SAME = 1e-6  # [m] of distances that differ by less the earlier counts, then the first pair
ERROR = 0.1 * EXACT  # [m] by which bounds may be off, with room for rounding
NOWHERE = -1


class Candidates(NamedTuple):
    """Pairs at instants, of several events; all of shape (m,)."""

    event: Indices
    pair: Indices  # row of the pairs
    time_s: Array
    least: Array  # apart by so much at least [m]
    above: Array  # added to a distance before it is compared: what is allowed [m]

    def at(self, which: Indices) -> "Candidates":
        """Return some of them."""
        return Candidates(
            *(self.event[which], self.pair[which], self.time_s[which]),
            *(self.least[which], self.above[which]),
        )

    @property
    def in_order(self) -> "Candidates":
        """The same by event, time and pair, each once."""
        order = np.lexsort((self.pair, self.time_s, self.event))
        event, pair, time = self.event[order], self.pair[order], self.time_s[order]
        new = np.ones(len(order), dtype=np.bool_)
        new[1:] = (np.diff(event) != 0) | (np.diff(time) != 0.0) | (np.diff(pair) != 0)
        return self.at(order[new])


class Deepest(NamedTuple):
    """Where events are deepest; all of shape (e,)."""

    pair: Indices  # row of the pairs; `NOWHERE` where there is no candidate
    time_s: Array  # NaN where there is none
    upper: Array  # not exceeded then, with what is added; inf where that is not known [m]
    way: Array  # (e, 3) a direction in which the solids are apart by no less


def nowhere(events: int) -> Deepest:
    """Return what is known of events at first."""
    pair, unknown = np.full(events, NOWHERE), np.full(events, np.nan)
    return Deepest(pair, unknown, np.full(events, np.inf), np.full((events, 3), np.nan))


def deepest(prober: Prober, pairs: Pairs, candidates: Candidates, known: Deepest) -> Deepest:
    """Return where events are deepest.

    Args:
        prober: Measures.
        pairs: What the candidates are rows of.
        candidates: Where they may be.
        known: What is known already; the moments themselves are among the candidates.
    """
    rows = candidates.in_order
    table = _Table(prober, pairs, rows)
    chosen = table.first_of_least(known)
    own = np.flatnonzero(chosen != NOWHERE)
    at = chosen[own]
    pair, time_s = known.pair.copy(), known.time_s.copy()
    upper, way = known.upper.copy(), known.way.copy()
    pair[own], time_s[own] = rows.pair[at], rows.time_s[at]
    upper[own], way[own] = table.upper[at], table.way[at]
    return Deepest(pair, time_s, upper, way)


class _Table:
    """What is known of candidates so far."""

    def __init__(self, prober: Prober, pairs: Pairs, rows: Candidates) -> None:
        self.prober = prober
        self.rows = rows
        first, second = pairs.first[rows.pair], pairs.second[rows.pair]
        self.a, self.b, boxes = prober.placed(first, second, rows.time_s)
        self.lower = np.maximum(boxes, rows.least) + rows.above
        self.upper = np.full(len(rows.pair), np.inf)
        key = rows.event * len(pairs.first) + rows.pair
        self.key = np.unique(key, return_inverse=True)[1]
        self.way = np.full((len(rows.pair), 3), np.nan)

    def first_of_least(self, begin: Deepest) -> Indices:
        """Return, of each event, the first candidate that is deepest but for `SAME`."""
        event, events = self.rows.event, len(begin.pair)
        chosen = np.full(events, NOWHERE)
        there = np.flatnonzero(self.rows.pair == begin.pair[event])
        self._look(there, begin.way[event[there]])
        live = np.arange(len(event))  # candidates that may be chosen
        known, most = begin.upper.copy(), 1
        while len(live):
            np.minimum.at(known, event[live], self.upper[live])
            live = live[self.lower[live] - ERROR <= known[event[live]] + SAME]
            least = np.full(events, np.inf)
            np.minimum.at(least, event[live], self.lower[live])
            own, place = np.unique(event[live], return_index=True)
            first = live[place]
            sure = self.upper[first] + ERROR <= least[own] + SAME
            chosen[own[sure]] = first[sure]
            live, first = live[~np.isin(event[live], own[sure])], first[~sure]
            # asked is what may be less by more than `SAME`, and what is first if nothing is
            bar = known - SAME
            measured = np.isfinite(self.upper[first])
            bar[event[first[measured]]] = self.upper[first[measured]] + 2.0 * ERROR - SAME
            less = live[self.lower[live] < bar[event[live]]]
            unknown = self._lowest(less[np.isinf(self.upper[less])], most)
            asked = np.union1d(unknown, first[~measured & np.isfinite(known[event[first]])])
            most *= 2
            if len(asked):
                self._ask(asked)
                self._look_along(live, asked)
            stuck = first[~np.isin(event[first], event[asked])]
            if len(stuck):
                good = self._settled(stuck, less, events)
                chosen[event[stuck[good]]] = stuck[good]
                live = live[~np.isin(event[live], event[stuck[good]])]
                self.lower[stuck[~good]] = np.inf
        return chosen

    def _lowest(self, some: Indices, most: int) -> Indices:
        """Return, of each pair of each event, the few candidates that may be deepest."""
        order = some[np.lexsort((some, self.lower[some], self.key[some]))]
        _, begins, own = np.unique(self.key[order], return_index=True, return_inverse=True)
        return order[np.arange(len(order)) - begins[own] < most]

    def _ask(self, which: Indices) -> None:
        found = self.prober.prover.exact(self.a.at(which), self.b.at(which))
        above = self.rows.above[which]
        self.lower[which] = np.maximum(self.lower[which], found.lower + above)
        self.upper[which] = found.upper + above
        self.way[which] = found.normal

    def _look_along(self, some: Indices, asked: Indices) -> None:
        """Raise lower bounds by the directions found for the same pair just before and after."""
        size = len(self.key)
        places = np.sort(self.key[asked] * size + asked)
        at = np.searchsorted(places, self.key[some] * size + some)
        for side in (at - 1, at):
            key, number = np.divmod(places[np.clip(side, 0, len(places) - 1)], size)
            same = key == self.key[some]
            self._look(some[same], self.way[number[same]])

    def _look(self, some: Indices, way: Array) -> None:
        """Raise lower bounds of some candidates by directions, shape (m, 3)."""
        if len(some):
            along = gaps(self.prober.solids, self.a.at(some), self.b.at(some), way)
            self.lower[some] = np.maximum(self.lower[some], along + self.rows.above[some])

    def _settled(self, first: Indices, less: Indices, events: int) -> Flags:
        """Return which candidates are deepest but for `SAME`, by what depends on nobody.

        Args:
            first: The candidates, one of an event.
            less: Those that may be deeper by more.
            events: How many there are.
        """
        event = self.rows.event
        some = np.union1d(first, less[np.isin(event[less], event[first])])
        value = self.prober.prover.told(self.a.at(some), self.b.at(some)).distance
        value += self.rows.above[some]
        least = np.full(events, np.inf)
        np.minimum.at(least, event[some], value)
        own = value[np.searchsorted(some, first)]
        return own <= least[event[first]] + SAME
