"""What several checks need of one run, computed once and forgotten with it."""

from typing import NamedTuple
from weakref import WeakKeyDictionary

from vrts.check.collision.pairs.arm_state import RunRecord
from vrts.check.collision.pairs.pairs import PAD_DEPTH, Plan, plan
from vrts.check.curves.timeline_arrays import Curves, curves
from vrts.engine.run import Run
from vrts.geometry.proposing.proposer import Proposer
from vrts.scene.model import Scene


class _Planned(NamedTuple):
    scene: Scene
    asked: tuple[str, float, bool, float]  # proposer, threshold, with clearance, depth of pads
    plan: Plan


_motions: "WeakKeyDictionary[Run, Curves]" = WeakKeyDictionary()
_plans: "WeakKeyDictionary[Run, list[_Planned]]" = WeakKeyDictionary()


def motion_of(run: RunRecord) -> Curves:
    """Return how the robot moves in a run; runs are immutable, so once is enough."""
    if not isinstance(run, Run):
        return curves(run.timeline.segments)
    found = _motions.get(run)
    if found is None:
        found = _motions[run] = curves(run.timeline.segments_or_start)
    return found


def plan_of(
    scene: Scene,
    run: RunRecord,
    proposer: Proposer,
    near_miss: float,
    *,
    clearance: bool,
    pads: float = PAD_DEPTH,
) -> Plan:
    """Return every pair that can touch in a run; see `collision_pairs.plan`."""
    motion = motion_of(run)
    if not isinstance(run, Run):
        return plan(scene, run, motion, proposer, near_miss, clearance=clearance, pads=pads)
    kept = _plans.setdefault(run, [])
    asked = (proposer.name, near_miss, clearance, pads)
    for planned in kept:
        if planned.scene is scene and planned.asked == asked:
            return planned.plan
    found = plan(scene, run, motion, proposer, near_miss, clearance=clearance, pads=pads)
    kept.append(_Planned(scene, asked, found))
    return found
