"""The intervals of time that the certified search begins with, and what is known of them."""

from typing import NamedTuple, TypeAlias

import numpy as np
import numpy.typing as npt

from vrts.check.collision.pairs.table import Pairs
from vrts.check.curves.timeline_arrays import Curves, Spread
from vrts.geometry.solids import Instants, Motion

Array: TypeAlias = npt.NDArray[np.float64]
Indices: TypeAlias = npt.NDArray[np.int64]

FIRST_NODE = 0.3  # [s] length of the first intervals


class Level(NamedTuple):
    """Everything known at one level, for its nodes."""

    middle: Array  # (n,) [s]
    half: Array  # (n,) [s]
    spread: Spread
    state: Instants
    motion: Motion


def first_nodes(
    curves: Curves, pairs: Pairs, interval: tuple[float, float], *, falls: bool
) -> tuple[Array, Array]:
    """Return nodes that lie within one rule and one motion each, in time order."""
    new_motion = curves.starts[1:][np.diff(curves.motions) != 0]
    cuts = np.unique(
        np.concatenate([pairs.start_s, pairs.end_s, curves.jumps(), new_motion, interval])
    )
    cuts = cuts[(cuts >= interval[0]) & (cuts <= interval[1])]
    start, end = cuts[:-1], cuts[1:]
    still = (curves.spread(start, end).speed == 0.0).all(axis=1)
    if falls:
        still[:] = False
    parts = np.where(still, 1, np.maximum(1, np.ceil((end - start) / FIRST_NODE)))
    return _divided(start, end, parts.astype(np.int64))


def _divided(start: Array, end: Array, parts: Indices) -> tuple[Array, Array]:
    """Return intervals cut into equal parts."""
    of = np.repeat(np.arange(len(start)), parts)
    number = np.arange(len(of)) - np.repeat(np.cumsum(parts) - parts, parts)
    step = (end - start) / parts
    low = start[of] + number * step[of]
    high = np.where(number + 1 == parts[of], end[of], start[of] + (number + 1) * step[of])
    return low, high
