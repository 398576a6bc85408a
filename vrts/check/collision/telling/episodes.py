"""Touches of one pair of names less than 0.5 s apart make one episode, which becomes one event."""

from bisect import bisect_right
from collections.abc import Sequence
from typing import NamedTuple

from vrts.check.collision.pairs.findings import EVENT_GAP, Touch, merge
from vrts.check.collision.pairs.table import Pairs


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
