"""Which rows of the first intervals need a closer look, by the boxes of whole bodies.

Nearly all pairs of solids are far apart nearly always. For every solid of the arm, its box at the
middle of an interval, widened by how far the solid can get before the ends, is compared with the
boxes of whole bodies that stand still. What is left is a small share of all rows, and the search
looks at it row by row. A box per body and the largest gap along one axis are less than the
distance, so nothing is dropped that the search would have kept.
"""

from typing import NamedTuple, TypeAlias

import numpy as np
import numpy.typing as npt

from vrts.check.collision.pairs.table import Pairs
from vrts.geometry.boxes import Boxes, boxes, travels
from vrts.geometry.solids import Instants, Motion, Solids

Array: TypeAlias = npt.NDArray[np.float64]
Flags: TypeAlias = npt.NDArray[np.bool_]
Indices: TypeAlias = npt.NDArray[np.int64]


class Sides(NamedTuple):
    """Of each pair: the solid that hangs further out, the other, and the frame of the other."""

    outer: Indices  # (p,)
    inner: Indices  # (p,)
    inner_frame: Indices  # (p,)


def sides_of(solids: Solids, pairs: Pairs) -> Sides:
    """Return which solid of each pair moves against the other."""
    frame_a, frame_b = solids.frame[pairs.first], solids.frame[pairs.second]
    swap = (frame_b > frame_a) | ((frame_a == frame_b) & solids.falls[pairs.second])
    outer = np.where(swap, pairs.second, pairs.first)
    inner = np.where(swap, pairs.first, pairs.second)
    return Sides(outer, inner, np.minimum(frame_a, frame_b))


class Gaps(NamedTuple):
    """Blocks of rows in nodes, with a lower bound on their distances there."""

    first_row: Indices  # (b,) a block is the rows from here
    end_row: Indices  # (b,) to here
    node: Indices  # (b,)
    least: Array  # (b,) at least this far apart throughout the node [m]
    middle: Array  # (b,) the gap of the boxes at the middle [m]

    def rows(self, which: Indices) -> tuple[Indices, Indices]:
        """Return the nodes and the rows of some blocks."""
        first, count = self.first_row[which], (self.end_row - self.first_row)[which]
        node = np.repeat(self.node[which], count)
        number = np.arange(len(node)) - np.repeat(np.cumsum(count) - count, count)
        return node, np.repeat(first, count) + number


_NOWHERE = np.empty(0, dtype=np.int64)
_NOTHING = Gaps(_NOWHERE, _NOWHERE, _NOWHERE, np.empty(0), np.empty(0))


class _Blocks(NamedTuple):
    """Consecutive rows of one outer solid, one body on the inner side, and one rule."""

    first_row: Indices  # (k,)
    end_row: Indices  # (k,)
    outer: Indices  # (k,) solid
    inner: Indices  # (k,) group of solids
    start_s: Array  # (k,)
    end_s: Array  # (k,)


def gaps(
    solids: Solids,
    pairs: Pairs,
    sides: Sides,
    state: Instants,
    motion: Motion,
    nodes: tuple[Array, Array],
    near: float,
) -> Gaps:
    """Return all blocks in all nodes whose gap may be below a distance.

    Args:
        solids: The convex pieces.
        pairs: Which are tested when.
        sides: Of the pairs.
        state: The middles of the nodes.
        motion: What happens round them.
        nodes: Starts and ends of the nodes, in time order, [s].
        near: Blocks that stay farther apart than this are left out [m].
    """
    group = _groups(solids)
    found: list[Gaps] = []
    still = (solids.frame == 0) & ~solids.falls
    falls = solids.falls[sides.outer] | solids.falls[sides.inner]
    on_still = still[sides.inner] & ~falls
    blocks = _blocks(pairs, sides, group)
    resting = on_still[blocks.first_row]
    moving = np.nonzero(~still & ~solids.falls)[0]
    place = np.full(len(still), -1, dtype=np.int64)
    place[moving] = np.arange(len(moving))
    at = boxes(solids, moving, state)
    reach = travels(solids, moving, state, motion, at)
    low, high = _bodies(solids, group, still, state)
    start, end = nodes
    outer = blocks.outer[resting]
    kinds = np.nonzero(resting)[0]
    arm: list[int] = np.unique(outer).tolist()
    for solid in arm:
        mine = kinds[outer == solid]
        box, far = at.of(int(place[solid])), reach[0, place[solid]]
        found.append(_against_still(blocks, mine, low, high, box, far, nodes, near))
    one = np.nonzero(~on_still & ~falls)[0]
    found.append(_against_moving(pairs, sides, one, place, at, reach, nodes, near))
    # of what falls nothing is left out
    row = np.nonzero(falls)[0]
    k, node = np.nonzero(
        (pairs.start_s[row, None] <= start[None, :]) & (end[None, :] <= pairs.end_s[row, None])
    )
    far = np.full(len(k), -np.inf)
    found.append(Gaps(row[k], row[k] + 1, node, far, far))
    return Gaps(*(np.concatenate(column) for column in zip(*found, strict=True)))


def _groups(solids: Solids) -> Indices:
    """Return the number of the body of each solid; neighbours of one name and frame are one."""
    parts = solids.parts
    new = np.array([a != b for a, b in zip(parts[1:], parts[:-1], strict=True)], dtype=np.bool_)
    new |= (np.diff(solids.frame) != 0) | (np.diff(solids.falls.astype(np.int64)) != 0)
    return np.concatenate([[0], np.cumsum(new)]).astype(np.int64)


def _blocks(pairs: Pairs, sides: Sides, group: Indices) -> _Blocks:
    inner = group[sides.inner]
    when = (pairs.start_s, pairs.end_s)
    rule = (pairs.tolerance, pairs.grazes, pairs.counts)
    new = np.zeros(len(inner), dtype=np.bool_)
    new[:1] = True
    for column in (sides.outer, inner, *when, *rule):
        new[1:] |= column[1:] != column[:-1]
    first = np.nonzero(new)[0]
    return _Blocks(
        first,
        np.append(first[1:], len(inner)),
        sides.outer[first],
        inner[first],
        pairs.start_s[first],
        pairs.end_s[first],
    )


def _bodies(solids: Solids, group: Indices, still: Flags, state: Instants) -> tuple[Array, Array]:
    """Return the corners of the boxes round bodies that stand still, both (bodies, 3)."""
    count = int(group[-1]) + 1
    low, high = np.full((count, 3), np.inf), np.full((count, 3), -np.inf)
    which = np.nonzero(still)[0]
    rotation, half = solids.rotation[which], solids.half[which]
    centre = solids.origin[which] + (rotation @ solids.middle[which][:, :, None])[:, :, 0]
    halves = (np.abs(rotation) @ half[:, :, None])[:, :, 0]
    across = np.sqrt(np.maximum(0.0, 1.0 - rotation[:, :, 2] ** 2))
    halves += solids.radius[which, None] * across
    np.minimum.at(low, group[which], centre - halves)
    np.maximum.at(high, group[which], centre + halves)
    return low, high


def _against_still(
    blocks: _Blocks,
    mine: Indices,
    low: Array,
    high: Array,
    box: tuple[Array, Array],
    reach: Array,
    nodes: tuple[Array, Array],
    near: float,
) -> Gaps:
    """Compare one solid of the arm with the bodies that stand still.

    Args:
        blocks: All blocks.
        mine: Those of this solid.
        low: Lower corners of bodies, shape (bodies, 3), [m].
        high: Upper corners.
        box: Centre and half extents of the solid in every node, both (3, n), [m].
        reach: How far it can get, shape (n,), [m].
        nodes: Starts and ends, [s].
        near: See `gaps`.
    """
    start, end = nodes
    # most bodies are far from all of the way of a link
    out = box[1] + reach + near
    lowest, highest = (box[0] - out).min(axis=1), (box[0] + out).max(axis=1)
    other = blocks.inner[mine]
    meets = (low[other] <= highest) & (lowest <= high[other])
    mine = mine[meets.all(axis=1)]
    if not len(mine):
        return _NOTHING
    from_s, to_s = float(blocks.start_s[mine].min()), float(blocks.end_s[mine].max())
    first = int(np.searchsorted(start, from_s))
    last = int(np.searchsorted(end, to_s, side="right"))
    centre, half = box[0][:, first:last], box[1][:, first:last]
    other, size = blocks.inner[mine], last - first
    widest = np.full((len(mine), size), -np.inf)
    gap = np.empty_like(widest)
    for axis in range(3):
        middle = 0.5 * (low[other, axis] + high[other, axis])
        length = 0.5 * (high[other, axis] - low[other, axis])
        np.subtract(centre[axis][None, :], middle[:, None], out=gap)
        np.abs(gap, out=gap)
        gap -= half[axis]
        gap -= length[:, None]
        np.maximum(widest, gap, out=widest)
    k, node = np.nonzero(widest < reach[first:last] + near)
    middle = widest[k, node]
    node += first
    block = mine[k]
    keep = (blocks.start_s[block] <= start[node]) & (end[node] <= blocks.end_s[block])
    block, node, middle = block[keep], node[keep], middle[keep]
    least = middle - reach[node]
    return Gaps(blocks.first_row[block], blocks.end_row[block], node, least, middle)


def _against_moving(
    pairs: Pairs,
    sides: Sides,
    row: Indices,
    place: Indices,
    at: Boxes,
    reach: Array,
    nodes: tuple[Array, Array],
    near: float,
) -> Gaps:
    """Compare solids of the arm with each other, row by row."""
    start, end = nodes
    a, b = place[sides.outer[row]], place[sides.inner[row]]
    widest = np.full((len(row), len(start)), -np.inf)
    for axis in range(3):
        gap = at.centre[axis][a]
        gap -= at.centre[axis][b]
        np.abs(gap, out=gap)
        gap -= at.half[axis][a]
        gap -= at.half[axis][b]
        np.maximum(widest, gap, out=widest)
    far = reach[sides.inner_frame[row], a]
    k, node = np.nonzero(widest < far + near)
    keep = (pairs.start_s[row[k]] <= start[node]) & (end[node] <= pairs.end_s[row[k]])
    k, node = k[keep], node[keep]
    middle = widest[k, node]
    return Gaps(row[k], row[k] + 1, node, middle - far[k, node], middle)
