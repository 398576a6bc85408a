"""Whether anything touches at all: the search of the collision check, and nothing told of it."""

from typing import NamedTuple

from vrts.check.collision.collision import look_once
from vrts.check.collision.of_run import motion_of, plan_of
from vrts.check.collision.pairs.arm_state import Prober, RunRecord
from vrts.check.collision.pairs.grips import NEAR_MISS
from vrts.check.collision.pairs.pair_rows import joined
from vrts.check.collision.search.search import search
from vrts.check.collision.telling.episodes import apart_from, episodes
from vrts.geometry.proposing.choose import here
from vrts.geometry.proving.prover import Prover
from vrts.scene.model import Scene


class Touching(NamedTuple):
    """How much touches in a run."""

    events: int  # contacts, and what cannot be told
    seconds: float  # that contacts last, all together


def touching(scene: Scene, run: RunRecord) -> Touching:
    """Return how much touches in a run: as `check_collisions` finds it, at less than half the cost.

    Args:
        scene: What stands where; its robot moves.
        run: The record of an execution in that scene.
    """
    if all(segment.end_s <= segment.start_s for segment in run.timeline.segments):
        return Touching(0, 0.0)
    motion, by = motion_of(run), here()
    todo = plan_of(scene, run, by, NEAR_MISS, clearance=False)
    interval = (motion.start_s, max(motion.end_s, float(todo.pairs.end_s.max(initial=0.0))))
    arm = scene.robot.arm
    found = search(arm, motion, todo.solids, todo.pairs, interval, by, clearance=False, near=None)
    look_once(todo, Prober(arm, motion, todo.solids, Prover(todo.solids, by)), found)
    pairs = joined(todo.pairs, todo.rigid)
    contacts = episodes(found.contacts, pairs)
    open_ = apart_from(episodes(found.open, pairs), contacts)
    seconds = sum(each.end_s - each.start_s for each in contacts)
    return Touching(len(contacts) + len(open_), seconds)
