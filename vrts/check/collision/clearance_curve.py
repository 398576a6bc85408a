"""The smallest distance of robot and surroundings over time, for charts.

Sampled, and so no verdict: what is certified stands in `CollisionReport`. The pairs and their rules
are those of the certified check, so the curve leaves out what is near on purpose.
"""

from typing import NamedTuple, TypeAlias

import numpy as np
import numpy.typing as npt

from vrts.check.collision.of_run import motion_of, plan_of
from vrts.check.collision.pairs.arm_state import Instants, RunRecord, instants
from vrts.check.collision.pairs.grips import NEAR_MISS
from vrts.check.collision.pairs.pairs import Plan
from vrts.engine.memory.records import GRAVITY
from vrts.geometry.proposing.choose import here
from vrts.geometry.proposing.proposer import Proposer
from vrts.geometry.proving.prover import EXACT, Prover
from vrts.geometry.proving.rows import Placed
from vrts.scene.model import Scene

Array: TypeAlias = npt.NDArray[np.float64]
Indices: TypeAlias = npt.NDArray[np.int64]

AT_ONCE = 100  # times, so that what is computed stays near the processor
NEAREST = 24  # pairs that are measured first: what they find rules out most of the others
FEW = 5  # times for which a pair is ruled out together
FAR = 0.5  # [m] larger distances are all the same to a reader


class _Boxes(NamedTuple):
    """Where solids are at some times, and boxes round them; of what stands still only one."""

    rotations: Array  # (m, 3, 3) of the solids' frames in W
    origins: Array  # (m, 3) [m]
    low: Array  # (m, 3) lower corners in W [m]
    high: Array  # (m, 3) upper corners
    at: Indices  # (solids, times) which of the m


def clearance_curve(
    scene: Scene,
    run: RunRecord,
    time_s: Array,
    near_miss: float | None = None,
    proposer: Proposer | None = None,
) -> Array:
    """Return the smallest distance of any tested pair at times of shape (n,) [m].

    It is at most `FAR`. Nearer than `near_miss` [m] is a near miss; None: as usual. The proposer
    helps to find distances and changes none; None: the best there is here.
    """
    motion = motion_of(run)
    threshold = NEAR_MISS if near_miss is None else near_miss
    by = here() if proposer is None else proposer
    todo = plan_of(scene, run, by, threshold, clearance=True)
    prover = Prover(todo.solids, by)
    rows = np.flatnonzero(todo.pairs.counts)
    found = np.full(len(time_s), FAR)
    if not len(rows):
        return found
    starts, ends = todo.pairs.start_s[rows], todo.pairs.end_s[rows]
    for start in range(0, len(time_s), AT_ONCE):
        part = slice(start, start + AT_ONCE)
        now = time_s[part]
        at_work = rows[(starts <= now.max()) & (now.min() <= ends)]
        state = instants(scene.robot.arm, motion, now)
        _measure(todo, prover, at_work, state, found[part])
    return found


def _measure(todo: Plan, prover: Prover, rows: Indices, state: Instants, found: Array) -> None:
    """Lower what was found, shape (times,) [m], to the smallest distance of rows of pairs.

    Most pairs are ruled out for many times at once, by the boxes in which their solids stay.
    """
    boxes, count = _boxes(todo, state), len(found)
    least = _apart(todo, rows, boxes, count)[:, 0]
    order = np.argsort(least, kind="stable")
    begin = rows[order[:NEAREST]]
    every = np.tile(np.arange(count), len(begin))
    _lower(todo, prover, np.repeat(begin, count), every, state, boxes, found)
    rest = order[NEAREST:]
    rest = rows[rest[least[rest] < found.max()]]
    far = np.maximum.reduceat(found, np.arange(0, count, FEW))
    row, group = np.nonzero(_apart(todo, rest, boxes, FEW) < far)
    instant = group[:, None] * FEW + np.arange(FEW)
    there = instant < count
    _lower(todo, prover, rest[row[np.nonzero(there)[0]]], instant[there], state, boxes, found)


def _lower(
    todo: Plan,
    prover: Prover,
    rows: Indices,
    instant: Indices,
    state: Instants,
    boxes: _Boxes,
    found: Array,
) -> None:
    """Do the same with rows at instants; both index arrays have shape (n,)."""
    pairs = todo.pairs
    first, second = pairs.first[rows], pairs.second[rows]
    a, b = boxes.at[first, instant], boxes.at[second, instant]
    least = _gaps(boxes.low, boxes.high, a, b)
    now = state.time_s[instant]
    near = least < found[instant]
    near &= (pairs.start_s[rows] <= now) & (now <= pairs.end_s[rows])
    order = np.flatnonzero(near)
    order = order[np.lexsort((least[order], instant[order]))]
    # of each instant the nearest by its boxes, then the next two, four, ... as long as any may be
    rank = np.arange(len(order)) - np.searchsorted(instant[order], instant[order])
    wave = 1
    while len(order):
        now = order[rank < wave]
        rows_a = Placed(first[now], boxes.rotations[a[now]], boxes.origins[a[now]])
        rows_b = Placed(second[now], boxes.rotations[b[now]], boxes.origins[b[now]])
        _smallest(prover, rows_a, rows_b, instant[now], found)
        left = (rank >= wave) & (least[order] < found[instant[order]])
        order, rank = order[left], rank[left]
        wave = 2 * wave + 1


def _smallest(prover: Prover, a: Placed, b: Placed, instant: Indices, found: Array) -> None:
    """Lower what was found to the distances of pairs at instants, both of shape (n,).

    Our own search is asked, of what proposals leave open, only about what may be nearer still.
    """
    bounds = prover.at_once(a, b)
    tight = bounds.upper - bounds.lower <= EXACT
    np.minimum.at(found, instant[tight], bounds.distance[tight])
    loose = np.flatnonzero(~tight)
    loose = loose[np.lexsort((bounds.lower[loose], instant[loose]))]
    while len(loose := loose[bounds.lower[loose] < found[instant[loose]]]):
        best = np.append(True, instant[loose[1:]] != instant[loose[:-1]])
        now, loose = loose[best], loose[~best]
        far = found[instant[now]]
        own = prover.searched_for(a.at(now), b.at(now), bounds.normal[now], apart=far)
        bounds.put(now, own)
        np.minimum.at(found, instant[now], bounds.distance[now])


def _boxes(todo: Plan, state: Instants) -> _Boxes:
    count, solids = len(state.time_s), len(todo.solids.shapes)
    still = (todo.solids.frame == 0) & ~todo.solids.falls
    each = np.where(still, 1, count)
    ends = np.cumsum(each)
    at = (ends - each)[:, None] + np.where(still[:, None], 0, np.arange(count))
    number = np.repeat(np.arange(solids), each)
    instant = np.arange(len(number)) - np.repeat(ends - each, each)
    placed = todo.solids.places(state, number, instant, GRAVITY)
    low, high = placed.centres - placed.halves, placed.centres + placed.halves
    return _Boxes(placed.rotations, placed.origins, low, high, at)


def _apart(todo: Plan, rows: Indices, boxes: _Boxes, few: int) -> Array:
    """Return what pairs keep apart at least over a few times each, shape (rows, groups) [m]."""
    count: int = boxes.at.shape[1]
    groups: Indices = np.arange(0, count, few)
    low = np.minimum.reduceat(boxes.low[boxes.at], groups, axis=1).reshape(-1, 3)
    high = np.maximum.reduceat(boxes.high[boxes.at], groups, axis=1).reshape(-1, 3)
    own = np.arange(len(groups))
    first, second = (
        s[rows, None] * len(groups) + own for s in (todo.pairs.first, todo.pairs.second)
    )
    return _gaps(low, high, first, second)


def _gaps(low: Array, high: Array, a: Indices, b: Indices) -> Array:
    """Return the distances of boxes given by their corners, shape (m, 3), as `a` is shaped [m]."""
    squares = np.zeros(a.shape)
    for axis in range(3):
        lower, upper = low[:, axis].copy(), high[:, axis].copy()
        apart = np.maximum(lower.take(a) - upper.take(b), lower.take(b) - upper.take(a))
        np.maximum(apart, 0.0, out=apart)
        squares += np.square(apart, out=apart)
    return np.sqrt(squares, out=squares)
