"""Tables of pairs made of others."""

from typing import TypeAlias

import numpy as np
import numpy.typing as npt

from vrts.check.collision.pairs.table import Pairs

Array: TypeAlias = npt.NDArray[np.float64]
Indices: TypeAlias = npt.NDArray[np.int64]


def joined(a: Pairs, b: Pairs) -> Pairs:
    """Return the rows of both, those of `a` first."""
    return Pairs(
        np.concatenate([a.first, b.first]),
        np.concatenate([a.second, b.second]),
        np.concatenate([a.start_s, b.start_s]),
        np.concatenate([a.end_s, b.end_s]),
        np.concatenate([a.tolerance, b.tolerance]),
        np.concatenate([a.grazes, b.grazes]),
        np.concatenate([a.counts, b.counts]),
        np.concatenate([a.group, b.group]),
    )


def some(pairs: Pairs, rows: Indices) -> Pairs:
    """Return some of the rows."""
    return Pairs(
        pairs.first[rows],
        pairs.second[rows],
        pairs.start_s[rows],
        pairs.end_s[rows],
        pairs.tolerance[rows],
        pairs.grazes[rows],
        pairs.counts[rows],
        pairs.group[rows],
    )


def ungrazed(pairs: Pairs) -> Pairs:
    """Return pairs of which only contacts are wanted."""
    return pairs._replace(grazes=np.zeros(len(pairs.first), dtype=np.bool_))


def narrowed(
    pairs: Pairs, rows: Indices, interval: tuple[float, float], tolerance: Array, group: int
) -> tuple[Pairs, Indices]:
    """Return some pairs within an interval [s], with other tolerances, and which pairs they are.

    Args:
        pairs: All pairs.
        rows: Which are wanted.
        interval: From when to when.
        tolerance: Their tolerances, of the same shape [m].
        group: Their group.
    """
    start_s = np.maximum(pairs.start_s[rows], interval[0])
    end_s = np.minimum(pairs.end_s[rows], interval[1])
    lasts = np.flatnonzero(start_s < end_s)
    rows, no = rows[lasts], np.zeros(len(lasts), dtype=np.bool_)
    own = np.full(len(rows), group)
    times = start_s[lasts], end_s[lasts]
    return Pairs(pairs.first[rows], pairs.second[rows], *times, tolerance[lasts], no, no, own), rows
