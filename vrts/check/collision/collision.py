"""Does the robot, or what it carries or drops, hit anything? Certified for every instant of a run.

The answer covers the polynomials of the timeline, not samples of them. Every verdict is proven by
the shapes' own support functions, up to the rounding of double precision, for which every bound is
padded; a distance library only proposes where to look. It says nothing about what is not modelled:
contacts push nothing and stop nothing.
"""

from collections.abc import Collection, Sequence
from types import MappingProxyType
from typing import TypeAlias

import numpy as np
import numpy.typing as npt

from vrts.check.collision.closer_look import Within, closer_look
from vrts.check.collision.near_misses import CERTAIN, near_misses
from vrts.check.collision.of_run import motion_of, plan_of
from vrts.check.collision.pairs.arm_state import Prober, RunRecord
from vrts.check.collision.pairs.findings import (
    BAND,
    GRAZE,
    Closest,
    Findings,
    Leaves,
    Touch,
    leaves,
)
from vrts.check.collision.pairs.grips import NEAR_MISS
from vrts.check.collision.pairs.pair_rows import joined, some, ungrazed
from vrts.check.collision.pairs.pairs import PAD_DEPTH, Plan
from vrts.check.collision.search.search import search
from vrts.check.collision.second_opinion import disagreements
from vrts.check.collision.telling.episodes import apart_from, episodes
from vrts.check.collision.telling.sought import contact, doubtful, graze
from vrts.check.collision.telling.teller import Teller, Told
from vrts.check.verdict import CollisionReport, ContactEvent, NearMiss
from vrts.engine.run import Run
from vrts.geometry.proposing.choose import here
from vrts.geometry.proposing.proposer import Proposer
from vrts.geometry.proving.prover import Prover
from vrts.scene.model import Scene

Array: TypeAlias = npt.NDArray[np.float64]


def check_collisions(
    scene: Scene,
    run: RunRecord,
    *,
    clearance: bool = True,
    proposer: Proposer | None = None,
    second: Proposer | None = None,
    near_miss: float | None = None,
    pads: float = PAD_DEPTH,
) -> CollisionReport:
    """Return every contact event, graze and near miss of a run, and its smallest clearance.

    Args:
        scene: What stands where; its robot moves.
        run: The record of an execution in that scene.
        clearance: Whether to find the smallest distance and near misses too, at some cost.
        proposer: Helps to prove distances; no answer depends on it. None: the best there is here.
        second: Who is asked for a second opinion; None: nobody. Decides nothing.
        near_miss: Nearer than this is a near miss [m]; None: nobody says, so `NEAR_MISS`.
        pads: How far a pad may press into what it grasps before that is a contact [m].
    """
    if all(segment.end_s <= segment.start_s for segment in run.timeline.segments):
        return CollisionReport((), (), (), None, certified=True, statistics=MappingProxyType({}))
    motion = motion_of(run)
    by = here() if proposer is None else proposer
    threshold = NEAR_MISS if near_miss is None else near_miss
    todo = plan_of(scene, run, by, threshold, clearance=clearance, pads=pads)
    interval = (motion.start_s, max(motion.end_s, float(todo.pairs.end_s.max(initial=0.0))))
    prober = Prober(scene.robot.arm, motion, todo.solids, Prover(todo.solids, by))
    pairs = joined(todo.pairs, todo.rigid)
    found = search(
        *(scene.robot.arm, motion, todo.solids, todo.pairs, interval, by),
        clearance=clearance,
        near=threshold if clearance else None,
    )
    look_once(todo, prober, found)
    contacts = episodes(found.contacts, pairs)
    open_ = apart_from(episodes(found.open, pairs), contacts)
    grazes = apart_from(episodes(found.grazes, pairs), [*contacts, *open_])
    known = [contact(one, pairs) for one in contacts]
    known += [doubtful(one, pairs) for one in open_]
    known += [graze(one, pairs) for one in grazes]
    look = Within(todo, pairs, prober, interval)
    teller = Teller(run, prober, pairs, todo.groups)
    told = teller.touches(closer_look(look, known))
    hits = told[: len(contacts)]
    doubts = told[len(contacts) : len(contacts) + len(open_)]
    touched = told[len(contacts) + len(open_) :]
    misses: list[Told[NearMiss]] = []
    if clearance:
        misses, more = teller.near_misses(near_misses(look, found, known, threshold))
        # what the search gave up is among them, and need not be that near
        misses = [miss for miss in misses if miss.event.distance_m < threshold]
        touched = sorted([*touched, *more], key=lambda one: one.event.start_s)
    witnesses = [one.witness for one in (*hits, *misses)]
    closest = (
        None
        if contacts
        else teller.closest(
            found.closest,
            leaves(found.leaves),
            # all that is so near is a near miss, unless it touches
            misses if not touched + doubts and found.closest.distance < threshold - CERTAIN else (),
        )
    )
    if closest is not None:
        witnesses.append(closest.witness)
    return CollisionReport(
        contacts=_events(hits),
        grazes=_events(touched),
        undetermined=_events(doubts),
        clearance=None if closest is None else closest.event,
        certified=not doubts,
        statistics=MappingProxyType(
            {
                "levels": found.levels,
                "intervals": found.nodes,
                "pairs of intervals": found.rows,
                "exact distances": found.asked + found.searched,
            }
        ),
        engine=by.name,
        disagreements=() if second is None else disagreements(prober, second, witnesses),
        near_misses=tuple(miss.event for miss in misses),
        near_miss_m=threshold if clearance else None,
        near_miss_assumed=near_miss is None,
    )


def _events(told: Sequence[Told[ContactEvent]]) -> tuple[ContactEvent, ...]:
    return tuple(one.event for one in told)


def touching(
    run: Run, wanted: Collection[tuple[str, str]], *, proposer: Proposer | None = None
) -> frozenset[tuple[str, str]]:
    """Return those of some pairs of names that touch in a run: have a contact, whenever and how.

    The same as `check_collisions` without a clearance says, where nobody asks what else touches.
    """
    by = here() if proposer is None else proposer
    motion = motion_of(run)
    if motion.end_s <= motion.start_s:
        return frozenset()
    whole = plan_of(run.scene, run, by, NEAR_MISS, clearance=False)
    of = np.array([group in wanted for group in whole.groups], dtype=np.bool_)
    todo = whole._replace(
        pairs=ungrazed(some(whole.pairs, np.flatnonzero(of[whole.pairs.group]))),
        rigid=some(whole.rigid, np.flatnonzero(of[whole.rigid.group])),
    )
    arm = run.scene.robot.arm
    interval = (motion.start_s, max(motion.end_s, float(whole.pairs.end_s.max(initial=0.0))))
    found = search(arm, motion, todo.solids, todo.pairs, interval, by, clearance=False)
    look_once(todo, Prober(arm, motion, todo.solids, Prover(todo.solids, by)), found)
    group = joined(todo.pairs, todo.rigid).group
    return frozenset(whole.groups[int(group[touch.pair])] for touch in found.contacts)


def look_once(todo: Plan, prober: Prober, found: Findings) -> None:
    """Add what pairs that do not move one against the other have to say."""
    rigid = todo.rigid
    if not len(rigid.first):
        return
    offset = len(todo.pairs.first)
    bounds = prober.told(rigid.first, rigid.second, rigid.start_s)
    rows = zip(bounds.lower.tolist(), bounds.upper.tolist(), strict=True)
    for k, (lower, upper) in enumerate(rows):
        start_s, end_s = float(rigid.start_s[k]), float(rigid.end_s[k])
        touch = Touch(offset + k, start_s, end_s, start_s, upper, lower)
        tolerance = float(rigid.tolerance[k])
        if upper < -tolerance - BAND:
            found.contacts.append(touch)
        elif lower < BAND - tolerance:
            found.open.append(touch)
        elif rigid.grazes[k] and upper < -GRAZE:
            found.grazes.append(touch)
        if rigid.counts[k]:
            one = np.array([lower])
            at = np.array([start_s])
            found.leaves.append(Leaves(np.array([offset + k]), at, at, one))
            if upper < found.closest.distance:
                found.closest = Closest(upper, offset + k, start_s)
