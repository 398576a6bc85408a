"""The instants at which distances are told: fixed by the motion, whatever anybody found.

Time is cut into cells of 16 ms, and each cell into equal parts in which the hand gets no farther
than 0.8 mm, or what falls; where nothing moves the moment at which that begins stands for all. The
moments at which pieces of the timeline begin, and those at which the rule of a pair begins or
ends, are among them. Round the one that is chosen there are others, eight times as near.
"""

from typing import NamedTuple, TypeAlias

import numpy as np
import numpy.typing as npt

from vrts.check.collision.pairs.arm_state import Prober, instants
from vrts.check.collision.pairs.findings import Leaves
from vrts.check.collision.pairs.table import Pairs
from vrts.engine.memory.records import GRAVITY

Array: TypeAlias = npt.NDArray[np.float64]
Indices: TypeAlias = npt.NDArray[np.int64]

CELL = 0.016  # [s]
STEP = 8e-4  # [m] of the way between instants
MOST = 80  # parts of a cell
FEWEST = 2
FINER = 8  # parts of the time between instants, round the one that is chosen
POINTS = np.array([(0.0, 0.0, 0.0), (0.0, 0.0, 0.3), (0.1, 0.0, 0.2)])  # of the hand, in L_6 [m]


class Instants(NamedTuple):
    """Pairs at instants."""

    leaf: Indices  # (m,) in which it lies
    time_s: Array  # (m,)


def instants_in(prober: Prober, pairs: Pairs, leaves: Leaves) -> Instants:
    """Return every instant in some intervals, not in order; some may be there twice."""
    first = np.floor(leaves.start_s / CELL).astype(np.int64)
    last = np.floor(leaves.end_s / CELL).astype(np.int64)
    leaf, cell = _ranges(first, last - first + 1)
    parts = _parts_of(prober, pairs, leaves, leaf, cell)
    which, number = _ranges(np.zeros_like(parts), parts)
    leaf, time = leaf[which], (cell[which] + number / parts[which]) * CELL
    special = [_starts(prober, leaves), *_rules(pairs, leaves)]
    leaf = np.concatenate([leaf, *(own for own, _ in special)])
    time = np.concatenate([time, *(own for _, own in special)])
    inside = (leaves.start_s[leaf] <= time) & (time <= leaves.end_s[leaf])
    return Instants(leaf[inside], time[inside])


def finer_instants(prober: Prober, pairs: Pairs, leaves: Leaves, round_s: Array) -> Instants:
    """Return instants in intervals round one of each, shape (m,), eight times as near."""
    leaf = np.arange(len(round_s))
    parts = _parts_of(prober, pairs, leaves, leaf, np.floor(round_s / CELL).astype(np.int64))
    step = CELL / FINER / np.maximum(parts, 1)
    number = np.arange(1 - FINER, FINER)
    time = round_s[:, None] + step[:, None] * number
    inside = (leaves.start_s[:, None] <= time) & (time <= leaves.end_s[:, None])
    inside &= (parts > 0)[:, None] | (number == 0)
    leaf, which = np.nonzero(inside)
    return Instants(leaf, time[leaf, which])


def _ranges(first: Indices, count: Indices) -> tuple[Indices, Indices]:
    """Return, for several ranges of numbers, which range each number is of, and the numbers."""
    of = np.repeat(np.arange(len(count)), count)
    return of, np.arange(len(of)) - np.repeat(np.cumsum(count) - count - first, count)


def _parts_of(
    prober: Prober, pairs: Pairs, leaves: Leaves, leaf: Indices, cell: Indices
) -> Indices:
    """Return into how many parts cells are cut for the pairs of intervals, shape (m,)."""
    known, at = np.unique(cell, return_inverse=True)
    parts = _parts(prober, known)[at]
    if prober.solids.falls.any():
        for solid in (pairs.first, pairs.second):
            parts = np.maximum(parts, _falling(prober, solid, leaves, leaf, cell))
    return parts


def _parts(prober: Prober, cell: Indices) -> Indices:
    """Return into how many parts cells are cut; 0 where the arm stands still."""
    edges = np.concatenate([cell, cell + 1])
    known, at = np.unique(edges, return_inverse=True)
    times: Array = known.astype(np.float64) * CELL
    frames = instants(prober.arm, prober.curves, times).frames
    points = frames.origins[6][:, None] + POINTS @ np.swapaxes(frames.rotations[6], 1, 2)
    begin, end = points[at[: len(cell)]], points[at[len(cell) :]]
    way = np.sqrt(np.square(end - begin).sum(axis=2)).max(axis=1)
    starts: Array = cell.astype(np.float64) * CELL
    moves = prober.curves.spread(starts, starts + CELL).speed.any(axis=1)
    parts = np.clip(np.ceil(way / STEP), FEWEST, MOST).astype(np.int64)
    return np.where(moves, parts, 0)


def _falling(
    prober: Prober, solid: Indices, leaves: Leaves, leaf: Indices, cell: Indices
) -> Indices:
    """Return the same for what falls."""
    own = solid[leaves.pair[leaf]]
    since = np.maximum((cell + 1) * CELL - prober.solids.falls_from[own], 0.0)
    parts = np.clip(np.ceil(GRAVITY * since * CELL / STEP), FEWEST, MOST).astype(np.int64)
    return np.where(prober.solids.falls[own], parts, 0)


def _starts(prober: Prober, leaves: Leaves) -> tuple[Indices, Array]:
    """Return the moments at which pieces of the timeline begin."""
    starts = prober.curves.starts
    first = np.searchsorted(starts, leaves.start_s)
    leaf, number = _ranges(first, np.searchsorted(starts, leaves.end_s, side="right") - first)
    return leaf, starts[number]


def _rules(pairs: Pairs, leaves: Leaves) -> tuple[tuple[Indices, Array], tuple[Indices, Array]]:
    """Return the moments at which rules of pairs begin and end."""
    every = np.arange(len(leaves.pair))
    return (every, pairs.start_s[leaves.pair]), (every, pairs.end_s[leaves.pair])
