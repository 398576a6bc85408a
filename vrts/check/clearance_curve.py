"""The smallest distance of robot and surroundings over time, for charts.

Sampled, and so no verdict: what is certified stands in `CollisionReport`. The pairs and their rules
are those of the certified check, so the curve leaves out what is near on purpose.
"""

from typing import TypeAlias

import numpy as np
import numpy.typing as npt

from vrts.check.collision_grips import NEAR_MISS
from vrts.check.collision_pairs import Pairs, Plan
from vrts.check.collision_state import Instants, RunRecord, instants
from vrts.check.of_run import motion_of, plan_of
from vrts.engine.records import GRAVITY
from vrts.geometry.narrow import engine as engine_by_name
from vrts.geometry.narrow import pair, transform
from vrts.geometry.solids import Places
from vrts.scene.model import Scene

Array: TypeAlias = npt.NDArray[np.float64]
Indices: TypeAlias = npt.NDArray[np.int64]

AT_ONCE = 25  # times, so that what is computed stays near the processor
FAR = 0.5  # [m] larger distances are all the same to a reader


def clearance_curve(
    scene: Scene, run: RunRecord, time_s: Array, near_miss: float | None = None
) -> Array:
    """Return the smallest distance of any tested pair at times of shape (n,) [m].

    It is at most `FAR`. Nearer than `near_miss` [m] is a near miss; None: as usual.
    """
    motion = motion_of(run)
    threshold = NEAR_MISS if near_miss is None else near_miss
    todo = plan_of(scene, run, engine_by_name(None), threshold, clearance=True)
    rows = np.flatnonzero(todo.pairs.counts)
    found = np.full(len(time_s), FAR)
    if not len(rows):
        return found
    for start in range(0, len(time_s), AT_ONCE):
        part = slice(start, start + AT_ONCE)
        now = time_s[part]
        starts, ends = todo.pairs.start_s[rows], todo.pairs.end_s[rows]
        at_work = rows[(starts <= now.max()) & (now.min() <= ends)]
        found[part] = _nearest(todo, at_work, instants(scene.robot.arm, motion, now), now)
    return found


def _nearest(todo: Plan, rows: Indices, state: Instants, time_s: Array) -> Array:
    """Return the smallest distance at some times, shape (n,) [m]."""
    count, solids = len(time_s), len(todo.solids.shapes)
    found = np.full(count, FAR)
    each = np.repeat(np.arange(solids), count)
    places = todo.solids.places(state, each, np.tile(np.arange(count), solids), GRAVITY)
    gaps = _gaps(todo.pairs, rows, places, count)
    starts, ends = todo.pairs.start_s[rows], todo.pairs.end_s[rows]
    for k, now in enumerate(time_s.tolist()):
        gap = gaps[k]
        near = np.flatnonzero((gap < FAR) & (starts <= now) & (now <= ends))
        for row in near[np.argsort(gap[near])].tolist():
            if gap[row] >= found[k]:
                break
            i, j = int(todo.pairs.first[rows[row]]), int(todo.pairs.second[rows[row]])
            a, b = i * count + k, j * count + k
            distance = pair(todo.solids.shapes[i], todo.solids.shapes[j]).distance(
                transform(places.rotations[a], places.origins[a]),
                transform(places.rotations[b], places.origins[b]),
            )
            found[k] = min(found[k], distance)
    return found


def _gaps(pairs: Pairs, rows: Indices, places: Places, count: int) -> Array:
    """Return the distance of the boxes round two solids, shape (times, rows) [m]."""
    centres = places.centres.reshape(-1, count, 3)
    halves = places.halves.reshape(-1, count, 3)
    i, j = pairs.first[rows], pairs.second[rows]
    squares = np.zeros((count, len(rows)))
    for axis in range(3):
        centre, half = centres[:, :, axis].T.copy(), halves[:, :, axis].T.copy()
        apart = np.take(centre, i, axis=1)
        apart -= np.take(centre, j, axis=1)
        np.abs(apart, out=apart)
        apart -= np.take(half, i, axis=1)
        apart -= np.take(half, j, axis=1)
        np.maximum(apart, 0.0, out=apart)
        squares += np.square(apart, out=apart)
    return np.sqrt(squares, out=squares)
