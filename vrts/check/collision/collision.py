"""Does the robot, or what it carries or drops, hit anything? Certified for every instant of a run.

The answer covers the polynomials of the timeline, not samples of them. It holds up to the rounding
of double precision and the error of the exact distance, for which every bound is padded. It says
nothing about what is not modelled: contacts push nothing and stop nothing.
"""

from collections.abc import Sequence
from dataclasses import replace
from types import MappingProxyType
from typing import TypeAlias

import numpy as np
import numpy.typing as npt

from vrts.check.collision.events import Teller, Told, apart_from, episodes
from vrts.check.collision.near_misses import Within, near_misses
from vrts.check.collision.of_run import motion_of, plan_of
from vrts.check.collision.pairs.arm_state import Prober, RunRecord
from vrts.check.collision.pairs.findings import (
    GRAZE,
    Closest,
    Findings,
    Touch,
    margin_of,
    slack_of,
)
from vrts.check.collision.pairs.grips import NEAR_MISS
from vrts.check.collision.pairs.pair_rows import joined
from vrts.check.collision.pairs.pairs import PAD_DEPTH, Pairs, Plan
from vrts.check.collision.search.search import search
from vrts.check.collision.second_opinion import Witness, disagreements
from vrts.check.verdict import Clearance, CollisionReport, NearMiss
from vrts.geometry.narrow import FCL
from vrts.geometry.narrow import engine as engine_by_name
from vrts.scene.model import Scene

Array: TypeAlias = npt.NDArray[np.float64]


def check_collisions(
    scene: Scene,
    run: RunRecord,
    *,
    clearance: bool = True,
    engine: str | None = None,
    near_miss: float | None = None,
    pads: float = PAD_DEPTH,
) -> CollisionReport:
    """Return every contact event, graze and near miss of a run, and its smallest clearance.

    Args:
        scene: What stands where; its robot moves.
        run: The record of an execution in that scene.
        clearance: Whether to find the smallest distance and near misses too, at some cost.
        engine: Name of what measures distances; None: the most exact there is.
        near_miss: Nearer than this is a near miss [m]; None: nobody says, so `NEAR_MISS`.
        pads: How far a pad may press into what it grasps before that is a contact [m].
    """
    if all(segment.end_s <= segment.start_s for segment in run.timeline.segments):
        return CollisionReport((), (), (), None, certified=True, statistics=MappingProxyType({}))
    motion = motion_of(run)
    by = engine_by_name(engine)
    threshold = NEAR_MISS if near_miss is None else near_miss
    todo = plan_of(scene, run, by, threshold, clearance=clearance, pads=pads)
    interval = (motion.start_s, max(motion.end_s, float(todo.pairs.end_s.max(initial=0.0))))
    prober = Prober(scene.robot.arm, motion, todo.solids, by)
    pairs = joined(todo.pairs, todo.rigid)
    found = search(
        scene.robot.arm, motion, todo.solids, todo.pairs, interval, by, clearance=clearance
    )
    _look_once(todo, prober, found)
    teller = Teller(run, motion, prober, pairs, todo.groups)
    contacts = episodes(found.contacts, pairs)
    doubtful = apart_from(episodes(found.open, pairs), contacts)
    grazes = apart_from(episodes(found.grazes, pairs), [*contacts, *doubtful])
    hits = [teller.contact(episode) for episode in contacts]
    misses: list[Told[NearMiss]] = []
    if clearance:
        look = Within(run, todo, prober, interval)
        misses = near_misses(look, found, [*contacts, *doubtful, *grazes], threshold)
    witnesses = [told.witness for told in (*hits, *misses)]
    if not contacts and np.isfinite(found.closest.distance):
        row = found.closest.pair
        witnesses.append(
            Witness(int(pairs.first[row]), int(pairs.second[row]), found.closest.time_s)
        )
    return CollisionReport(
        contacts=tuple(told.event for told in hits),
        grazes=tuple(teller.touch(episode) for episode in grazes),
        undetermined=tuple(teller.touch(episode) for episode in doubtful),
        clearance=None if contacts else _clearance(found.closest, pairs, prober),
        certified=not doubtful,
        statistics=MappingProxyType(
            {
                "levels": found.levels,
                "intervals": found.nodes,
                "pairs of intervals": found.rows,
                "exact distances": found.exact,
            }
        ),
        engine=by.name,
        disagreements=_asked_again(prober, witnesses),
        near_misses=tuple(told.event for told in misses),
        near_miss_m=threshold if clearance else None,
        near_miss_assumed=near_miss is None,
    )


def _look_once(todo: Plan, prober: Prober, found: Findings) -> None:
    """Add what pairs that do not move one against the other have to say."""
    rigid = todo.rigid
    margin = margin_of(prober.engine)
    offset = len(todo.pairs.first)
    distances = prober.distances(rigid.first, rigid.second, rigid.start_s)
    for k, distance in enumerate(distances.tolist()):
        start_s, end_s = float(rigid.start_s[k]), float(rigid.end_s[k])
        touch = Touch(offset + k, start_s, end_s, start_s, distance)
        beyond = distance + float(rigid.tolerance[k])
        if beyond < -margin:
            found.contacts.append(touch)
        elif beyond < margin:
            found.open.append(touch)
        elif rigid.grazes[k] and distance < -GRAZE:
            found.grazes.append(touch)
        if rigid.counts[k] and distance < found.closest.distance:
            found.closest = Closest(distance, offset + k, start_s)


def _asked_again(prober: Prober, witnesses: Sequence[Witness]) -> tuple[str, ...]:
    """Ask python-fcl about two solids at the instants on which the report rests."""
    if prober.engine.name == FCL:
        return ()
    return disagreements(prober, replace(prober, engine=engine_by_name(FCL)), witnesses)


def _clearance(closest: Closest, pairs: Pairs, prober: Prober) -> Clearance | None:
    if not np.isfinite(closest.distance):
        return None
    i, j = pairs.first[[closest.pair]], pairs.second[[closest.pair]]
    nearest = prober.nearest(i, j, np.array([closest.time_s]))[0]
    parts = prober.solids.parts
    return Clearance(
        distance_m=nearest.distance,
        tolerance_m=slack_of(prober.engine),
        time_s=closest.time_s,
        bodies=(parts[int(i[0])], parts[int(j[0])]),
        witnesses=(nearest.first, nearest.second),
    )
