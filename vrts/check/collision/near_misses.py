"""Who comes nearer than a threshold without touching? Certified like contacts.

Whatever comes nearer than the threshold less 0.01 mm is found, for every instant of the run, and
nothing is told that is not nearer by 0.005 mm: so a way that keeps the threshold exactly is no near
miss, however it is rounded. Where the smallest clearance of all is larger than the threshold the
search need not look.
"""

from collections.abc import Sequence

import numpy as np

from vrts.check.collision.closer_look import Within, rested
from vrts.check.collision.pairs.findings import HARDLY, SLACK, Findings, Touch, leaves
from vrts.check.collision.telling.episodes import apart_from, episodes
from vrts.check.collision.telling.sought import Sought, near_miss

CERTAIN = 2.0 * HARDLY  # [m] whatever is nearer than a threshold by more is found


def near_misses(
    look: Within, found: Findings, known: Sequence[Sought], threshold: float
) -> list[Sought]:
    """Return the near misses of a run, in order of time: with them the smallest distance of all.

    Args:
        look: The run and its pairs.
        found: What the search has found; its smallest distance is certified.
        known: Contacts, grazes and what may be either: such an approach is no near miss.
        threshold: Nearer than this is a near miss [m].
    """
    closest = found.closest
    if closest.distance - SLACK >= threshold:
        return []
    sure = found.near + [
        t for t in found.open if np.isnan(t.distance) and look.pairs.counts[t.pair]
    ]
    sure += _resting(look, threshold - HARDLY)
    if -np.inf < closest.distance < threshold - HARDLY:
        at = closest.time_s
        sure.append(Touch(closest.pair, at, at, at, closest.distance))
    kept = leaves(found.leaves)
    group = look.pairs.group[kept.pair]
    missed: list[Sought] = []
    for episode in apart_from(episodes(sure, look.pairs), [one.episode for one in known]):
        at = (group == episode.group) & (kept.start_s <= episode.end_s)
        own = kept.at(np.flatnonzero(at & (episode.start_s <= kept.end_s)))
        one = near_miss(episode, look.pairs, threshold)
        missed.append(rested(look, one.within((), own)))
    return missed


def _resting(look: Within, threshold: float) -> list[Touch]:
    """Return pairs that do not move one against the other and are nearer than a threshold."""
    moving, rigid = len(look.todo.pairs.first), look.todo.rigid
    rows = np.flatnonzero(rigid.counts)
    distances = look.prober.distances(rigid.first[rows], rigid.second[rows], rigid.start_s[rows])
    return [
        Touch(moving + row, start_s, end_s, start_s, distance)
        for row, start_s, end_s, distance in zip(
            *(c.tolist() for c in (rows, rigid.start_s[rows], rigid.end_s[rows], distances)),
            strict=True,
        )
        if distance < threshold
    ]
