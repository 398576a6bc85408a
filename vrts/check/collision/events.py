"""From touches of pairs of pieces to events: one pair of names, times, depth, cause.

The search leaves instants and short intervals at which pieces touch. Touches of one pair of names
less than 0.5 s apart are one event; its ends are found to 0.2 ms, its deepest moment by looking
more finely round the deepest touch. A near miss is told like a contact of another depth.
"""

from bisect import bisect_right
from collections.abc import Sequence
from typing import Generic, NamedTuple, TypeAlias, TypeVar

import numpy as np
import numpy.typing as npt

from vrts.base.pose import Vector
from vrts.check.collision.pairs.arm_state import Prober, RunRecord
from vrts.check.collision.pairs.findings import COVERED, EVENT_GAP, REPORTED, Touch, merge
from vrts.check.collision.pairs.pairs import Pairs
from vrts.check.collision.second_opinion import Witness
from vrts.check.curves.timeline_arrays import Curves
from vrts.check.verdict import ContactEvent, NearMiss
from vrts.engine.memory.events import Cause
from vrts.engine.memory.records import Lie
from vrts.geometry.nearest import Nearest

Array: TypeAlias = npt.NDArray[np.float64]
Sides: TypeAlias = tuple[str, str]
Event = TypeVar("Event", ContactEvent, NearMiss)

EDGE_SAMPLES = 12  # within the last millisecond and a half before an end
DEEPEST_SAMPLES = 33  # round the deepest touch, twice


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

    def contact(self, episode: Episode) -> Told[ContactEvent]:
        """Return the event of an episode of contact."""
        pair, interval, time_s = self._told(episode)
        return Told(self._event(episode, pair, interval, time_s), self._witness(pair, time_s))

    def near_miss(self, episode: Episode) -> Told[NearMiss]:
        """Return the near miss of an episode of touches of enlarged pairs."""
        pair, (start_s, end_s), time_s = self._told(episode)
        sides, nearest = self._nearest(episode, pair, time_s)
        event = NearMiss(
            *self.groups[episode.group],
            parts=sides,
            start_s=start_s,
            end_s=end_s,
            nearest_s=time_s,
            distance_m=max(nearest.distance, 0.0),  # less than a graze
            witnesses=(nearest.first, nearest.second),
            held=self._held(start_s),
            cause=self._cause(start_s),
        )
        return Told(event, self._witness(pair, time_s))

    def touch(self, episode: Episode) -> ContactEvent:
        """Return the event of an episode of touches that are no certain contact."""
        known = [touch for touch in episode.touches if not np.isnan(touch.distance)]
        deepest = min(known or episode.touches, key=lambda touch: touch.distance)
        interval = (episode.start_s, episode.end_s)
        return self._event(episode, deepest.pair, interval, deepest.time_s)

    def _told(self, episode: Episode) -> tuple[int, tuple[float, float], float]:
        """Return the pair that is deepest, first and last time, and the deepest moment."""
        first = min(episode.touches, key=lambda touch: touch.start_s)
        last = max(episode.touches, key=lambda touch: touch.end_s)
        start_s = self._edge(first, first.start_s, -REPORTED)
        end_s = self._edge(last, last.end_s, REPORTED)
        known = [touch for touch in episode.touches if not np.isnan(touch.distance)]
        deepest = min(known or episode.touches, key=lambda touch: touch.distance)
        time_s = deepest.time_s
        for width in (COVERED, 2.0 * COVERED / (DEEPEST_SAMPLES - 1)):
            time_s = self._deepest(deepest.pair, time_s, width, start_s, end_s)
        return deepest.pair, (start_s, end_s), time_s

    def _witness(self, pair: int, time_s: float) -> Witness:
        return Witness(int(self.pairs.first[pair]), int(self.pairs.second[pair]), time_s)

    def _nearest(self, episode: Episode, pair: int, time_s: float) -> tuple[Sides, Nearest]:
        """Return the names of two parts in the order of their event, and their nearest points."""
        i, j = self.pairs.first[[pair]], self.pairs.second[[pair]]
        nearest = self.prober.nearest(i, j, np.array([time_s]))[0]
        parts = self.prober.solids.parts
        names = self.groups[episode.group]
        sides = (parts[int(i[0])], parts[int(j[0])])
        if sides[0] == names[1] != sides[1]:
            sides = (sides[1], sides[0])
            nearest = nearest._replace(first=nearest.second, second=nearest.first)
        return sides, nearest

    def _event(
        self, episode: Episode, pair: int, interval: tuple[float, float], deepest_s: float
    ) -> ContactEvent:
        sides, nearest = self._nearest(episode, pair, deepest_s)
        start_s, end_s = interval
        return ContactEvent(
            *self.groups[episode.group],
            parts=sides,
            start_s=start_s,
            end_s=end_s,
            deepest_s=deepest_s,
            depth_m=-nearest.distance,
            point=_between(nearest.first, nearest.second),
            held=self._held(start_s),
            cause=self._cause(start_s),
        )

    def _edge(self, touch: Touch, inner_s: float, step: float) -> float:
        """Return where a contact begins (step < 0) or ends, near a time at which it is there.

        The search leaves less than a step open. Near misses may go on for longer, where a pair
        comes no nearer than the threshold less the tolerance of that search.
        """
        pair = touch.pair
        low, high = float(self.pairs.start_s[pair]), float(self.pairs.end_s[pair])
        reach = 1.5 * step
        while True:
            times = np.clip(inner_s + np.linspace(0.0, reach, EDGE_SAMPLES + 1), low, high)
            deep = self._distances(pair, times) < -self.pairs.tolerance[pair]
            outside = np.nonzero(~deep)[0]
            if len(outside) == 0:
                inner_s = float(times[-1])
                if inner_s in (low, high):
                    return inner_s
                reach *= 4.0
                continue
            inner_s = float(times[max(int(outside[0]) - 1, 0)])
            if abs(reach) <= abs(1.5 * step):
                return inner_s
            reach = max(abs(reach) / EDGE_SAMPLES, abs(1.5 * step)) * np.sign(step)

    def _deepest(
        self, pair: int, time_s: float, width: float, start_s: float, end_s: float
    ) -> float:
        low = max(start_s, float(self.pairs.start_s[pair]), time_s - width)
        high = min(end_s, float(self.pairs.end_s[pair]), time_s + width)
        if high <= low:
            return time_s
        times = np.append(np.linspace(low, high, DEEPEST_SAMPLES), time_s)
        distances = self._distances(pair, times)
        return float(times[int(np.argmin(distances))])

    def _distances(self, pair: int, times: Array) -> Array:
        count = len(times)
        return self.prober.distances(
            np.repeat(self.pairs.first[pair], count),
            np.repeat(self.pairs.second[pair], count),
            times,
        )

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
