"""When an event begins and ends: the first and the last instant of a fixed grid that lie in it.

An instant lies in an event while any pair of its names is nearer than a limit. From a touch that
the search has found one goes outward until that is over, and then halves what is between.
"""

from collections.abc import Generator, Mapping, Sequence
from typing import NamedTuple, TypeAlias

import numpy as np
import numpy.typing as npt

from vrts.check.collision.pairs.arm_state import Prober
from vrts.check.collision.pairs.asking import all_told
from vrts.check.collision.pairs.table import Pairs
from vrts.check.collision.telling.moments import ERROR
from vrts.geometry.proving.rows import gaps

Array: TypeAlias = npt.NDArray[np.float64]
Flags: TypeAlias = npt.NDArray[np.bool_]
Indices: TypeAlias = npt.NDArray[np.int64]

TICKS = 8192  # instants of the grid in a second
FIRST_STEP = 16  # instants outward at first, then each time four times as far
NEARBY = 0.03  # [m] pairs whose boxes are farther apart at a touch do not end or begin an event

_Asking: TypeAlias = Generator[float, bool, float]  # yields a time, is sent whether it lies within


class Edge(NamedTuple):
    """Where to look for a beginning or an end."""

    rows: Indices  # of the pairs
    limit: Array  # nearer than this lies within, of each row [m]
    inner_s: float  # a time that lies within, or very nearly
    other_s: float  # another, where it does not
    outward: int  # -1: the beginning is sought; 1: the end


def edges_of(prober: Prober, pairs: Pairs, wanted: Sequence[Edge]) -> list[float]:
    """Return when events begin or end [s]."""
    near = _nearby(prober, pairs, wanted)
    ways = [np.full((len(edge.rows), 3), np.nan) for edge in near]

    def answer(asked: Mapping[int, float]) -> Mapping[int, bool]:
        numbers = [*asked]
        inside = _inside(
            prober,
            pairs,
            [near[k] for k in numbers],
            [ways[k] for k in numbers],
            np.array([asked[k] for k in numbers]),
        )
        return dict(zip(numbers, inside.tolist(), strict=True))

    return all_told([_edge(edge, pairs) for edge in near], answer)


def _nearby(prober: Prober, pairs: Pairs, wanted: Sequence[Edge]) -> list[Edge]:
    """Return the same with the rows only that may matter."""
    if not wanted:
        return []
    rows = np.concatenate([edge.rows for edge in wanted])
    limit = np.concatenate([edge.limit for edge in wanted])
    sizes = [len(edge.rows) for edge in wanted]
    times = np.repeat([edge.inner_s for edge in wanted], sizes)
    _, _, least = prober.placed(pairs.first[rows], pairs.second[rows], times)
    ends = np.cumsum(sizes)[:-1]
    return [
        edge._replace(rows=edge.rows[keep], limit=edge.limit[keep])
        for edge, keep in zip(wanted, np.split(least < limit + NEARBY, ends), strict=True)
    ]


def _edge(edge: Edge, pairs: Pairs) -> _Asking:
    """Return when an event begins or ends."""
    sign = edge.outward
    starts, ends = pairs.start_s[edge.rows], pairs.end_s[edge.rows]
    bound = float(starts.min()) if sign < 0 else float(ends.max())
    changes = starts if sign < 0 else ends
    inner = _tick(edge.inner_s, sign)
    if (yield inner / TICKS):
        step = FIRST_STEP
        while True:
            out = inner + sign * step
            if sign * (out / TICKS - bound) > 0.0:
                if (yield bound):
                    return bound
                out = _tick(bound, sign) + sign
                break
            if not (yield out / TICKS):
                break
            inner, step = out, 4 * step
    else:
        out, inner = inner, _tick(edge.other_s, sign)
        if inner == out or not (yield inner / TICKS):
            return out / TICKS  # shorter than the grid shows
    while abs(out - inner) > 1:
        middle = (out + inner) // 2
        if (yield middle / TICKS):
            inner = middle
        else:
            out = middle
    low, high = sorted((inner / TICKS, out / TICKS))
    between = changes[(low < changes) & (changes < high)]
    for change in sorted(between.tolist(), key=lambda time: -sign * time):
        if (yield change):
            return change
    return inner / TICKS


def _tick(time_s: float, sign: int) -> int:
    """Return the number of the first instant after a time (sign < 0), or of the last before."""
    return int(np.ceil(time_s * TICKS)) if sign < 0 else int(np.floor(time_s * TICKS))


def _inside(
    prober: Prober, pairs: Pairs, edges: Sequence[Edge], ways: Sequence[Array], times: Array
) -> Flags:
    """Return whether any pair of each edge is nearer than its limit at a time."""
    sizes = [len(edge.rows) for edge in edges]
    of = np.repeat(np.arange(len(edges)), sizes)
    row, limit = (np.concatenate(c) for c in zip(*((e.rows, e.limit) for e in edges), strict=True))
    place = np.arange(len(of)) - np.repeat(np.cumsum(sizes) - sizes, sizes)
    time, way = times[of], np.concatenate(ways)
    live = np.flatnonzero((pairs.start_s[row] <= time) & (time <= pairs.end_s[row]))
    a, b, boxes = prober.placed(pairs.first[row[live]], pairs.second[row[live]], time[live])
    lower = boxes - limit[live]
    known = np.flatnonzero((lower < ERROR) & np.isfinite(way[live, 0]))
    along = gaps(prober.solids, a.at(known), b.at(known), way[live[known]])
    lower[known] = np.maximum(lower[known], along - limit[live[known]])
    found = np.zeros(len(edges), dtype=np.bool_)
    todo = np.flatnonzero(lower < ERROR)
    while len(todo):
        order = todo[np.lexsort((lower[todo], of[live[todo]]))]
        asked = order[np.unique(of[live[order]], return_index=True)[1]]
        bounds = prober.prover.exact(a.at(asked), b.at(asked))
        upper = bounds.upper - limit[live[asked]]
        nearer = upper < -ERROR
        unclear = np.flatnonzero(~nearer & (bounds.lower - limit[live[asked]] < ERROR))
        if len(unclear):
            some = asked[unclear]
            told = prober.prover.told(a.at(some), b.at(some)).distance
            nearer[unclear] = told < limit[live[some]]
        for k, normal in zip(live[asked].tolist(), bounds.normal, strict=True):
            own: Array = ways[int(of[k])]
            own[int(place[k])] = normal
        found[of[live[asked[nearer]]]] = True
        todo = np.setdiff1d(todo, asked)
        todo = todo[~found[of[live[todo]]]]
    return found
