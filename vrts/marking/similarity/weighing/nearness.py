"""How near the details of two programs are, for each pair, by rank: no tolerance is set.

What counts is how few programs of the class are as near to a detail as the other program. Where
details crowd, a small distance tells nothing; where there are few, a larger one tells something.
"""

from bisect import bisect_left
from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from vrts.marking.similarity.weighing.shares import BACKGROUND

Floats = NDArray[np.float64]
Key = tuple[str, str]  # kind of detail, and the thing
Vectors = Sequence[tuple[float, ...]]

COMMON = 0.5  # share of a class from which on nearness tells nothing
BLOCK = 2_000_000  # distances between rows that are held at a time
TINY = 1e-6  # of nats: rounding
SAME = 0.05  # distances that differ by less are the same
LEAST_PROGRAMS = 5  # with a detail, before its ranks tell anything


class Near(NamedTuple):
    """A detail of two programs that few others have as near."""

    key: Key
    first: int  # number of the detail of the first program, among those of the key
    second: int
    weight: float  # nats
    others: int  # further programs that are as near


class _Table(NamedTuple):
    """Details of one key, of all programs that have some, those of the class first."""

    ids: list[int]  # numbers of programs
    inside: int  # how many of them are of the class
    starts: NDArray[np.int64]  # the first row of each
    lengths: NDArray[np.int64]  # rows of each
    rows: NDArray[np.float32]

    @property
    def own(self) -> int:
        """How many rows are of the class."""
        return int(self.lengths[: self.inside].sum())


class Nearness(NamedTuple):
    """How near programs of a class are to each of the class and of others."""

    total: Floats  # nats, shape (class, class + others)
    tables: Mapping[Key, _Table]

    def of(self, i: int, j: int) -> Iterator[Near]:
        """Yield what two programs have nearly alike; the first is of the class."""
        for key, table in self.tables.items():
            k, other = bisect_left(table.ids, i), bisect_left(table.ids, j)
            if i not in table.ids[k : k + 1] or j not in table.ids[other : other + 1]:
                continue
            start, end = int(table.starts[k]), int(table.starts[k] + table.lengths[k])
            begin = int(table.starts[other])
            theirs = table.rows[begin : begin + int(table.lengths[other])]
            away = _away(table.rows[start:end], theirs)
            usual = np.minimum.reduceat(
                _away(table.rows[start:end], table.rows[: table.own]),
                table.starts[: table.inside],
                axis=1,
            )
            for first in range(end - start):
                second = int(np.argmin(away[first]))
                rank = max(1, int((usual[first] <= away[first, second] + SAME).sum()) - 1)
                weight = float(nats_of_rank(np.array([rank]), len(self.total))[0])
                yield Near(key, first, second, weight, rank - 1)


def nearness(
    details: Sequence[Mapping[Key, Vectors]], count: int, families: Mapping[str, str] | None = None
) -> Nearness:
    """Return how near programs are.

    Args:
        details: Of each program, those of the class first.
        count: How many are of the class.
        families: Of kinds of details that follow from one decision, what they are together. However
            many agree, they count by how few of the class are as near in all of them.
    """
    parts: dict[str, Floats] = {}
    tables: dict[Key, _Table] = {}
    kinds: dict[str, list[Key]] = {}
    for key in sorted({key for one in details[:count] for key in one}):
        table = _table(details, key, count)
        if table.inside >= LEAST_PROGRAMS:
            tables[key] = table
            kinds.setdefault(key[0], []).append(key)
    for kind, keys in kinds.items():
        family = (families or {}).get(kind, kind)
        found = parts.setdefault(family, np.zeros((count, len(details))))
        for key in keys:
            table = tables[key]
            # one subprogram for all things says one thing, several times
            part = _nats(table, count) / len(keys) ** 0.5
            found[np.ix_(table.ids[: table.inside], table.ids)] += part
    total = np.zeros((count, len(details)))
    for found in parts.values():
        total += _by_rank(found, count)
    return Nearness(total, tables)


def _by_rank(found: Floats, count: int) -> Floats:
    """Return the nats of a family; within the class those of both directions."""
    places = np.arange(count)
    usual = found[:, :count].copy()
    usual[places, places] = -np.inf
    usual = np.sort(-usual, axis=1)
    rank = np.empty(found.shape, dtype=np.int64)
    for k in places:
        rank[k] = np.searchsorted(usual[k], TINY - found[k], side="right")
    nats = nats_of_rank(np.maximum(rank, 1), count)
    nats[found <= TINY] = 0.0
    nats[:, :count] = (nats[:, :count] + nats[:, :count].T) / 2.0
    nats[places, places] = 0.0
    return nats


def _table(details: Sequence[Mapping[Key, Vectors]], key: Key, count: int) -> _Table:
    ids = [k for k, one in enumerate(details) if key in one]
    lengths = np.array([len(details[k][key]) for k in ids])
    starts = np.concatenate([[0], np.cumsum(lengths)[:-1]])
    rows = np.array([row for k in ids for row in details[k][key]], dtype=np.float32)
    return _Table(ids, sum(k < count for k in ids), starts, lengths, rows)


def _nats(table: _Table, count: int) -> Floats:
    """Return the nats of one key; within the class those of both directions."""
    inside = table.inside
    means = np.empty((inside, len(table.ids)))
    size = max(1, BLOCK // (len(table.rows) * int(table.lengths[:inside].max())))  # programs
    for first in range(0, inside, size):
        last = min(inside, first + size)
        lengths = table.lengths[first:last]
        start = int(table.starts[first])
        rows = table.rows[start : start + int(lengths.sum())]
        nats = _nats_of_rows(table, rows, np.repeat(np.arange(first, last), lengths), count)
        starts = table.starts[first:last] - start
        means[first:last] = np.add.reduceat(nats, starts, axis=0) / lengths[:, None]
    means[:, :inside] = (means[:, :inside] + means[:, :inside].T) / 2.0
    return means


def _nats_of_rows(
    table: _Table, rows: NDArray[np.float32], owner: NDArray[np.int64], count: int
) -> Floats:
    """Return the nats of some rows of the class with each program; `owner`: of each row."""
    away = np.minimum.reduceat(_away(rows, table.rows), table.starts, axis=1)
    places = np.arange(len(rows))
    away[places, owner] = np.inf
    usual = np.sort(away[:, : table.inside], axis=1)
    rank = np.empty(away.shape, dtype=np.int64)
    for k in places:
        rank[k] = np.searchsorted(usual[k], away[k] + SAME, side="right")
    nats = nats_of_rank(np.maximum(rank, 1), count)
    nats[places, owner] = 0.0
    return nats


def _away(one: NDArray[np.float32], other: NDArray[np.float32]) -> NDArray[np.float32]:
    found = np.zeros((len(one), len(other)), dtype=np.float32)
    for axis in range(one.shape[1]):
        found += (one[:, None, axis] - other[None, :, axis]) ** 2
    return np.sqrt(found)


def nats_of_rank(rank: NDArray[np.int64], count: int) -> Floats:
    """Return what it counts that so many of a class are as near, in nats."""
    usual = rank / (count + BACKGROUND)
    return np.maximum(0.0, np.log(COMMON) - np.log(usual))


def as_near(nats: float, count: int) -> int:
    """Return how many of a class are as near, from the nats that it counts."""
    return max(1, round(COMMON * (count + BACKGROUND) * float(np.exp(-nats))))
