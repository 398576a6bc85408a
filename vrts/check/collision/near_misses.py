"""Who comes nearer than a threshold without touching? Certified like contacts.

A pair that is nearer than 5 mm is a pair of shapes grown by 5 mm that touch: the certified search
answers with another tolerance. It need not look where the smallest clearance of all is larger.
Whatever comes nearer than the threshold less 0.1 mm is found, for every instant of the run.
"""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from vrts.check.collision.events import Episode, Teller, Told, apart_from, episodes
from vrts.check.collision.pairs.arm_state import Prober, RunRecord
from vrts.check.collision.pairs.findings import BAND, SLACK, Closest, Findings, Touch
from vrts.check.collision.pairs.pair_rows import grown, joined
from vrts.check.collision.pairs.pairs import Plan
from vrts.check.collision.search.search import search
from vrts.check.verdict import ContactEvent, NearMiss


class Within(NamedTuple):
    """What is looked at."""

    run: RunRecord
    todo: Plan
    prober: Prober
    interval: tuple[float, float]  # [s]


def near_misses(
    look: Within, found: Findings, touching: Sequence[Episode], threshold: float
) -> tuple[list[Told[NearMiss]], list[ContactEvent]]:
    """Return the near misses of a run, in order of time, and grazes found on the way.

    Args:
        look: The run and its pairs.
        found: What the search for contacts has found; its smallest distance is certified.
        touching: Contacts, grazes and what may be either: such an approach is no near miss.
        threshold: Nearer than this is a near miss [m].
    """
    todo, prober = look.todo, look.prober
    if found.closest.distance - SLACK >= threshold:
        return [], []
    moving, rigid = grown(todo.pairs, threshold), grown(todo.rigid, threshold)
    near = search(
        prober.arm,
        prober.curves,
        todo.solids,
        moving,
        look.interval,
        prober.prover.proposer,
        clearance=False,
        band=-SLACK - BAND,
        nearest=True,
    )
    touches = near.contacts + near.open + _certified(todo, found.closest, threshold)
    distances = prober.distances(rigid.first, rigid.second, rigid.start_s)
    for k in np.flatnonzero(distances < threshold).tolist():
        start_s, end_s = float(rigid.start_s[k]), float(rigid.end_s[k])
        touches.append(Touch(len(moving.first) + k, start_s, end_s, start_s, float(distances[k])))
    pairs = joined(moving, rigid)
    teller = Teller(look.run, prober.curves, prober, pairs, todo.groups)
    alone = apart_from(episodes(touches, pairs), touching)
    told, grazes = teller.near_misses(alone)
    # what the search gave up is among them, and need not be that near
    return [miss for miss in told if miss.event.distance_m < threshold], grazes


def _certified(todo: Plan, closest: Closest, threshold: float) -> list[Touch]:
    """Return the smallest distance of all as a touch, where it is known and near enough."""
    if not -np.inf < closest.distance < threshold:
        return []
    counts = np.concatenate([todo.pairs.counts, todo.rigid.counts])
    row = int(np.count_nonzero(counts[: closest.pair]))
    at = closest.time_s
    return [Touch(row, at, at, at, closest.distance)]
