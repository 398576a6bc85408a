"""From touches of pairs of pieces to events: one pair of names, times, depth, cause.

The search leaves instants and short intervals at which pieces touch. Touches of one pair of names
less than 0.5 s apart are one event; its ends are found to 0.1 ms, its deepest moment by
looking more finely round the deepest touch. A near miss is told like a contact of another depth.
Many events are told together, since asking for many distances costs little more than for a few.
"""

from bisect import bisect_right
from collections.abc import Generator, Mapping, Sequence
from typing import Generic, NamedTuple, TypeAlias, TypeVar

import numpy as np
import numpy.typing as npt

from vrts.base.pose import Vector
from vrts.check.collision.pairs.arm_state import Prober, RunRecord
from vrts.check.collision.pairs.asking import all_told
from vrts.check.collision.pairs.findings import (
    COVERED,
    EVENT_GAP,
    GRAZE,
    REPORTED,
    SLACK,
    Closest,
    Touch,
    merge,
)
from vrts.check.collision.pairs.pairs import Pairs
from vrts.check.collision.second_opinion import Witness
from vrts.check.curves.timeline_arrays import Curves
from vrts.check.verdict import Clearance, ContactEvent, NearMiss
from vrts.engine.memory.events import Cause
from vrts.engine.memory.records import Lie

Array: TypeAlias = npt.NDArray[np.float64]
Flags: TypeAlias = npt.NDArray[np.bool_]
Indices: TypeAlias = npt.NDArray[np.int64]
Sides: TypeAlias = tuple[str, str]
Event = TypeVar("Event", ContactEvent, NearMiss, Clearance)
T = TypeVar("T")

EDGE_SAMPLES = 4  # within the last millisecond and a half before an end
EDGE_PARTS = 4  # of the last of these, in which the end lies: together 0.1 ms
DEEPEST_SAMPLES = 7  # round the deepest moment known, each time three times as near
DEEPEST_ROUNDS = 5
TOUCHES = 16  # of an event that are measured together
SAME = 1e-6  # [m] of depths that differ by less the earlier counts


class _Needs(NamedTuple):
    """Distances that are needed of pairs at instants."""

    pair: Indices  # (m,) rows of the pairs
    time_s: Array  # (m,)
    boxes: bool = False  # whether lower bounds by their boxes will do


_Asking: TypeAlias = Generator[_Needs, Array, T]


class Episode(NamedTuple):
    """Touches of one pair of names that make one event."""

    group: int
    start_s: float
    end_s: float
    touches: tuple[Touch, ...]


def episodes(touches: Sequence[Touch], pairs: Pairs) -> list[Episode]:
    """Return the touches of each pair of names, cut where nothing touches for 0.5 s."""
    by_group: dict[int, list[Touch]] = {}
    for touch in touches:
        by_group.setdefault(int(pairs.group[touch.pair]), []).append(touch)
    found: list[Episode] = []
    for group, own in by_group.items():
        own.sort(key=lambda touch: touch.start_s)
        first = 0
        for start_s, end_s in merge([(touch.start_s, touch.end_s) for touch in own]):
            last = bisect_right(own, end_s, key=lambda touch: touch.start_s)
            found.append(Episode(group, start_s, end_s, tuple(own[first:last])))
            first = last
    return sorted(found, key=lambda episode: (episode.start_s, episode.group))


def apart_from(found: Sequence[Episode], others: Sequence[Episode]) -> list[Episode]:
    """Return the episodes that are not part of the same event as one of the others."""

    def near(a: Episode, b: Episode) -> bool:
        gap = max(a.start_s - b.end_s, b.start_s - a.end_s)
        return a.group == b.group and gap < EVENT_GAP

    return [episode for episode in found if not any(near(episode, other) for other in others)]


class Told(NamedTuple, Generic[Event]):
    """An event, and the two solids and the instant at which it is deepest."""

    event: Event
    witness: Witness


class _Moment(NamedTuple):
    """The times of an event, and the pair of solids that is deepest."""

    pair: int  # row of the pairs
    start_s: float
    end_s: float
    time_s: float  # of the deepest moment


class _Nearest(NamedTuple):
    """Two parts, how far they are apart at most, and the points that show it."""

    parts: Sides
    distance: float  # [m]; negative: overlap at least so deep
    first: Vector
    second: Vector

    @property
    def turned(self) -> "_Nearest":
        """The same, the second part first."""
        return _Nearest((self.parts[1], self.parts[0]), self.distance, self.second, self.first)


class Teller:
    """Makes events of episodes."""

    def __init__(
        self,
        run: RunRecord,
        curves: Curves,
        prober: Prober,
        pairs: Pairs,
        groups: Sequence[tuple[str, str]],
    ) -> None:
        self.run = run
        self.curves = curves
        self.prober = prober
        self.pairs = pairs
        self.groups = groups

    def contacts(self, found: Sequence[Episode]) -> list[Told[ContactEvent]]:
        """Return the events of episodes of contact."""
        return [
            Told(self._event(episode, moment, nearest), self._witness(moment))
            for episode, moment, nearest in self._all_told(found)
        ]

    def near_misses(
        self, found: Sequence[Episode]
    ) -> tuple[list[Told[NearMiss]], list[ContactEvent]]:
        """Return the near misses of episodes of touches of enlarged pairs, and those that graze."""
        misses: list[Told[NearMiss]] = []
        grazes: list[ContactEvent] = []
        for episode, moment, nearest in self._all_told(found):
            if nearest.distance < -GRAZE:
                grazes.append(self._event(episode, moment, nearest))
            else:
                miss = self._near_miss(episode, moment, nearest)
                misses.append(Told(miss, self._witness(moment)))
        return misses, grazes

    def touches(self, found: Sequence[Episode]) -> list[ContactEvent]:
        """Return the events of episodes of touches that are no certain contact."""
        moments = all_told([self._doubtful(episode) for episode in found], self._answer)
        nearest = self._nearest(found, moments)
        return [self._event(*own) for own in zip(found, moments, nearest, strict=True)]

    def closest(self, found: Closest) -> Told[Clearance] | None:
        """Return the smallest distance, at the moment near the one found at which it is least."""
        if not np.isfinite(found.distance):
            return None
        pair = found.pair
        low, high = float(self.pairs.start_s[pair]), float(self.pairs.end_s[pair])
        (time_s,) = all_told([self._earliest(pair, found.time_s, low, high)], self._answer)
        (pair,) = all_told([self._first_of(self.pairs.counts, pair, time_s)], self._answer)
        moment = _Moment(pair, low, high, time_s)
        witness = self._witness(moment)
        bounds = self.prober.told(
            np.array([witness.first]), np.array([witness.second]), np.array([time_s])
        )
        (x,), (y,) = bounds.first.tolist(), bounds.second.tolist()
        parts = self.prober.solids.parts
        clearance = Clearance(
            distance_m=float(bounds.upper[0]),
            tolerance_m=SLACK,
            time_s=time_s,
            bodies=(parts[witness.first], parts[witness.second]),
            witnesses=(tuple(x), tuple(y)),
        )
        return Told(clearance, witness)

    def _near_miss(self, episode: Episode, moment: _Moment, nearest: _Nearest) -> NearMiss:
        return NearMiss(
            *self.groups[episode.group],
            parts=nearest.parts,
            start_s=moment.start_s,
            end_s=moment.end_s,
            nearest_s=moment.time_s,
            distance_m=max(nearest.distance, 0.0),  # less than a graze
            witnesses=(nearest.first, nearest.second),
            held=self._held(moment.start_s),
            cause=self._cause(moment.start_s),
        )

    def _event(self, episode: Episode, moment: _Moment, nearest: _Nearest) -> ContactEvent:
        return ContactEvent(
            *self.groups[episode.group],
            parts=nearest.parts,
            start_s=moment.start_s,
            end_s=moment.end_s,
            deepest_s=moment.time_s,
            depth_m=-nearest.distance,
            point=_between(nearest.first, nearest.second),
            held=self._held(moment.start_s),
            cause=self._cause(moment.start_s),
        )

    def _witness(self, moment: _Moment) -> Witness:
        first, second = self.pairs.first[moment.pair], self.pairs.second[moment.pair]
        return Witness(int(first), int(second), moment.time_s)

    def _all_told(self, found: Sequence[Episode]) -> list[tuple[Episode, _Moment, _Nearest]]:
        """Return, for each episode, its times and its nearest points."""
        moments = all_told([self._moment(episode) for episode in found], self._answer)
        return list(zip(found, moments, self._nearest(found, moments), strict=True))

    def _answer(self, asked: Mapping[int, _Needs]) -> Mapping[int, Array]:
        """Return the distances that questions need, measured together."""
        told: dict[int, Array] = {}
        for boxes in (False, True):
            some = {number: needs for number, needs in asked.items() if needs.boxes is boxes}
            if not some:
                continue
            pair = np.concatenate([needs.pair for needs in some.values()])
            times = np.concatenate([needs.time_s for needs in some.values()])
            measure = self.prober.outside if boxes else self.prober.distances
            distances = measure(self.pairs.first[pair], self.pairs.second[pair], times)
            ends = np.cumsum([len(needs.pair) for needs in some.values()])[:-1]
            told.update(zip(some, np.split(distances, ends), strict=True))
        return told

    def _moment(self, episode: Episode) -> _Asking[_Moment]:
        """Return the pair that is deepest, first and last time, and the deepest moment."""
        first = min(episode.touches, key=lambda touch: touch.start_s)
        last = max(episode.touches, key=lambda touch: touch.end_s)
        start_s = yield from self._edge(first, first.start_s, -REPORTED)
        end_s = yield from self._edge(last, last.end_s, REPORTED)
        pair, time_s = yield from self._deepest(episode)
        low = max(start_s, float(self.pairs.start_s[pair]))
        high = min(end_s, float(self.pairs.end_s[pair]))
        time_s = yield from self._earliest(pair, time_s, low, high)
        pair = yield from self._partner(pair, time_s)
        return _Moment(pair, start_s, end_s, time_s)

    def _doubtful(self, episode: Episode) -> _Asking[_Moment]:
        """Return the same of touches that are no certain contact, by the touches alone."""
        pair, time_s = yield from self._deepest(episode)
        low = max(episode.start_s, float(self.pairs.start_s[pair]))
        high = min(episode.end_s, float(self.pairs.end_s[pair]))
        time_s = yield from self._earliest(pair, time_s, low, high)
        pair = yield from self._partner(pair, time_s)
        return _Moment(pair, episode.start_s, episode.end_s, time_s)

    def _deepest(self, episode: Episode) -> _Asking[tuple[int, float]]:
        """Return the pair and the time of the deepest touch, the earliest of several.

        How deep a touch is at most is known; only those that may be the deepest are measured.
        """
        likely = sorted(episode.touches, key=lambda touch: (touch.least, touch.time_s, touch.pair))
        measured: list[tuple[float, Touch]] = []
        least = np.inf
        for first in range(0, len(likely), TOUCHES):
            some = [touch for touch in likely[first : first + TOUCHES] if touch.least <= least]
            if not some:
                break
            pairs = np.array([touch.pair for touch in some])
            distances = yield _Needs(pairs, np.array([touch.time_s for touch in some]))
            measured += zip(distances.tolist(), some, strict=True)
            least = min(least, float(distances.min()))
        deepest = min(
            (touch for distance, touch in measured if distance <= least + SAME),
            key=lambda touch: (touch.time_s, touch.pair),
        )
        return deepest.pair, deepest.time_s

    def _earliest(self, pair: int, time_s: float, low: float, high: float) -> _Asking[float]:
        """Return when a pair is nearest: near a moment, or earlier where it is as near as there.

        An arm that stands still, or slides along a face, is as near for a while. Such a while
        begins where a piece of the motion begins.
        """
        starts = self.curves.starts
        starts = starts[(low < starts) & (starts < high)]
        if len(starts):
            (least,) = yield _Needs(np.array([pair]), np.array([time_s]))
            near = yield _Needs(np.full(len(starts), pair), starts, boxes=True)
            times = np.append(starts[near <= least + SAME], time_s)
            distances = yield _Needs(np.full(len(times), pair), times)
            same = times[distances <= distances.min() + SAME]
            time_s = float(same.min())
        return (yield from _least(pair, time_s, low, high))

    def _partner(self, pair: int, time_s: float) -> _Asking[int]:
        """Return the first of the pairs with the same names that are equally deep at a time."""
        pairs = self.pairs
        same = pairs.group == pairs.group[pair]
        same &= (pairs.tolerance == pairs.tolerance[pair]) & (pairs.counts == pairs.counts[pair])
        return (yield from self._first_of(same, pair, time_s))

    def _first_of(self, same: Flags, pair: int, time_s: float) -> _Asking[int]:
        """Return the first of some pairs that are equally near at a time, one of them known."""
        pairs = self.pairs
        same = same & (pairs.start_s <= time_s) & (time_s <= pairs.end_s)
        rows = np.flatnonzero(same)
        near = yield _Needs(rows, np.full(len(rows), time_s), boxes=True)
        (own,) = yield _Needs(np.array([pair]), np.array([time_s]))
        rows = rows[(near <= own + SAME) & (rows != pair)]
        if not len(rows):
            return pair
        distances = yield _Needs(rows, np.full(len(rows), time_s))
        equal = rows[distances <= min(float(own), float(distances.min())) + SAME].tolist()
        if own <= distances.min() + SAME:
            equal.append(pair)
        return min(equal)

    def _edge(self, touch: Touch, inner_s: float, step: float) -> _Asking[float]:
        """Return where a contact begins (step < 0) or ends, near a time at which it is there.

        The search leaves less than a step open. Near misses may go on for longer, where a pair
        comes no nearer than the threshold less the tolerance of that search.
        """
        pair = touch.pair
        low, high = float(self.pairs.start_s[pair]), float(self.pairs.end_s[pair])
        tolerance = float(self.pairs.tolerance[pair])
        reach = 1.5 * step
        while True:
            times = np.clip(inner_s + np.linspace(0.0, reach, EDGE_SAMPLES + 1), low, high)
            beyond = (yield _Needs(np.full(len(times), pair), times)) + tolerance
            outside = np.nonzero(~(beyond < 0.0))[0]
            if len(outside) == 0:
                inner_s = float(times[-1])
                if inner_s in (low, high):
                    return inner_s
                reach *= 4.0
                continue
            out = int(outside[0])
            if abs(reach) <= abs(1.5 * step) and out > 0:
                return (yield from self._between_samples(touch, times[out - 1], times[out]))
            inner_s = float(times[max(out - 1, 0)])
            if abs(reach) <= abs(1.5 * step):
                return inner_s
            reach = max(abs(reach) / EDGE_SAMPLES, abs(1.5 * step)) * np.sign(step)

    def _between_samples(self, touch: Touch, inner_s: float, outer_s: float) -> _Asking[float]:
        """Return when a pair passes its tolerance, between a time in contact and one that is not.

        Distances may have a kink there, so only what is left of four parts is taken for straight.
        """
        times = np.linspace(inner_s, outer_s, EDGE_PARTS + 1)
        distances = yield _Needs(np.full(len(times), touch.pair), times)
        beyond = distances + float(self.pairs.tolerance[touch.pair])
        out = max(int(np.argmax(beyond >= 0.0)), 1)
        share = beyond[out - 1] / (beyond[out - 1] - beyond[out])
        return float(times[out - 1] + share * (times[out] - times[out - 1]))

    def _nearest(self, found: Sequence[Episode], moments: Sequence[_Moment]) -> list[_Nearest]:
        """Return the nearest points at moments, in the order of the names of their episodes."""
        if not moments:
            return []
        pair = np.array([moment.pair for moment in moments])
        first, second = self.pairs.first[pair], self.pairs.second[pair]
        times = np.array([moment.time_s for moment in moments])
        bounds = self.prober.told(first, second, times)
        parts = self.prober.solids.parts
        told: list[_Nearest] = []
        columns = (first, second, bounds.upper, bounds.first, bounds.second)
        rows = zip(*(column.tolist() for column in columns), strict=True)
        for episode, (i, j, distance, x, y) in zip(found, rows, strict=True):
            own = _Nearest((parts[i], parts[j]), distance, tuple(x), tuple(y))
            names = self.groups[episode.group]
            told.append(own.turned if own.parts[0] == names[1] != own.parts[1] else own)
        return told

    def _held(self, time_s: float) -> str | None:
        """Return the object between the pads at a time."""
        for body, placements in self.run.placements.items():
            for placement in placements:
                gripped = placement.lie is Lie.HELD and placement.support is None
                if gripped and placement.start_s <= time_s <= placement.end_s:
                    return body
        return None

    def _cause(self, time_s: float) -> Cause | None:
        """Return the instruction under way; without a motion, the last one that did a thing."""
        motion = int(self.curves.motions[self.curves.piece_at(np.array([time_s]))[0]])
        if motion >= 0:
            return self.run.motions[motion].cause
        cause = None
        for event in self.run.events:
            if event.time_s > time_s:
                break
            cause = event.cause or cause
        return cause


def _between(a: Vector, b: Vector) -> Vector:
    return (0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1]), 0.5 * (a[2] + b[2]))


def _least(pair: int, time_s: float, low: float, high: float) -> _Asking[float]:
    """Return when a pair is nearest, looking more and more closely round a moment."""
    width = COVERED
    for _ in range(DEEPEST_ROUNDS):
        first, last = max(low, time_s - width), min(high, time_s + width)
        near = np.linspace(first, max(first, last), DEEPEST_SAMPLES)
        times = np.unique(np.append(near, time_s))
        distances = yield _Needs(np.full(len(times), pair), times)
        time_s = float(times[_first_of_least(distances)])
        width *= 2.0 / (DEEPEST_SAMPLES - 1)
    return time_s


def _first_of_least(distances: Array) -> int:
    """Return where distances are smallest for the first time, but for rounding."""
    return int(np.flatnonzero(distances <= distances.min() + SAME)[0])
