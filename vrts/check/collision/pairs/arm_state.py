"""Where the arm is in a run, for many instants at once, and distances asked at chosen instants."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple, Protocol, TypeAlias

import numpy as np
import numpy.typing as npt

from vrts.check.collision.pairs.exact import outside
from vrts.check.curves.timeline_arrays import Curves
from vrts.engine.memory.events import Event
from vrts.engine.memory.records import GRAVITY, Motion, Placement, Segment
from vrts.geometry.nearest import Engine, Nearest, Pair, Transform
from vrts.geometry.solids import Frames, Instants, Places, Solids
from vrts.robots.kinematics.batch import link_frames
from vrts.robots.model import Arm

Array: TypeAlias = npt.NDArray[np.float64]
Indices: TypeAlias = npt.NDArray[np.int64]


class TimelineRecord(Protocol):
    """What the check reads of a timeline."""

    @property
    def segments(self) -> Sequence[Segment]:
        """All segments in time order."""
        ...


class RunRecord(Protocol):
    """What the check reads of a run: records only, no machine state."""

    @property
    def timeline(self) -> TimelineRecord:
        """The motion."""
        ...

    @property
    def motions(self) -> Sequence[Motion]:
        """The motion instructions, as segments number them."""
        ...

    @property
    def events(self) -> Sequence[Event]:
        """What happened, in time order."""
        ...

    @property
    def placements(self) -> Mapping[str, Sequence[Placement]]:
        """Where every movable body is."""
        ...


def instants(arm: Arm, curves: Curves, time_s: Array) -> Instants:
    """Return the state of the arm at times of shape (n,)."""
    return instants_of(arm, curves.values(time_s), time_s)


def instants_of(arm: Arm, values: Array, time_s: Array) -> Instants:
    """Return the state of the arm for coordinates of shape (n, 7)."""
    rotations, origins = link_frames(arm, values[:, :6])
    return Instants(time_s, values[:, 6], Frames(rotations, origins))


class Asked(NamedTuple):
    """The distance between two unions of solids, at some times; the second comes and goes."""

    first: Sequence[int]
    stays: Sequence[tuple[Sequence[int], float, float]]  # solids of the second, from when to when
    times: Array  # [s]


class _Placed:
    """Where solids are at instants, in numpy's form and, when asked for, in the engine's."""

    __slots__ = ("_engine", "_known", "first", "places", "second")

    def __init__(self, engine: Engine, places: Places, first: Indices, second: Indices) -> None:
        self.places = places
        self.first = first  # index of the place of each query's first solid
        self.second = second
        self._engine = engine
        self._known: list[Transform | None] = [None] * len(places.origins)

    def transform(self, at: int) -> Transform:
        """Return a place in the engine's form."""
        known = self._known[at]
        if known is None:
            known = self._engine.transform(self.places.rotations[at], self.places.origins[at])
            self._known[at] = known
        return known


@dataclass(frozen=True, slots=True)
class Prober:
    """Exact distances between solids at chosen instants."""

    arm: Arm
    curves: Curves
    solids: Solids
    engine: Engine

    def distances(self, first: Indices, second: Indices, time_s: Array) -> Array:
        """Return signed distances [m]; all arguments have shape (m,)."""
        queries = self._queries(first, second, time_s)
        return np.array([function.distance(a, b) for function, a, b in queries])

    def nearest(self, first: Indices, second: Indices, time_s: Array) -> list[Nearest]:
        """Return signed distances with their points; all arguments have shape (m,)."""
        return [function.nearest(a, b) for function, a, b in self._queries(first, second, time_s)]

    def _queries(
        self, first: Indices, second: Indices, time_s: Array
    ) -> Iterator[tuple[Pair, Transform, Transform]]:
        if len(time_s) == 0:
            return
        placed = self._placed(first, second, time_s)
        columns = (first, second, placed.first, placed.second)
        for i, j, a, b in zip(*(column.tolist() for column in columns), strict=True):
            yield self._pair(i, j), placed.transform(a), placed.transform(b)

    def _pair(self, first: int, second: int) -> Pair:
        return self.engine.pair(self.solids.shapes[first], self.solids.shapes[second])

    def _placed(self, first: Indices, second: Indices, time_s: Array) -> _Placed:
        times, at = np.unique(time_s, return_inverse=True)
        state = instants(self.arm, self.curves, times)
        still = (self.solids.frame == 0) & ~self.solids.falls
        keys = [s * len(times) + np.where(still[s], 0, at) for s in (first, second)]
        known, place = np.unique(np.concatenate(keys), return_inverse=True)
        places = self.solids.places(state, *np.divmod(known, len(times)), GRAVITY)
        return _Placed(self.engine, places, place[: len(first)], place[len(first) :])

    def gaps(self, asked: Sequence[Asked]) -> list[Iterator[float]]:
        """Return the distances [m] between unions of solids; inf while nothing is there.

        The solids are placed for all questions together; a distance is measured when it is taken.
        """
        rows = [own for number, one in enumerate(asked) for own in _rows(number, one)]
        if not rows:
            return [iter([np.inf] * len(one.times)) for one in asked]
        first, second, number, instant, times = (np.concatenate(c) for c in zip(*rows, strict=True))
        placed = self._placed(first, second, times)
        # the nearest by their boxes first; most of the others need not be asked then
        least = outside(placed.places, placed.first, placed.second)
        order = np.lexsort((least, instant, number))
        ends = np.searchsorted(number[order], np.arange(len(asked) + 1))
        columns = (instant, least, first, second, placed.first, placed.second)
        in_order: list[npt.NDArray[Any]] = [column[order] for column in columns]
        return [
            self._taken(len(one.times), placed, [c[ends[k] : ends[k + 1]] for c in in_order])
            for k, one in enumerate(asked)
        ]

    def _taken(
        self, count: int, placed: _Placed, columns: Sequence[npt.NDArray[Any]]
    ) -> Iterator[float]:
        """Yield the distance at each instant, from rows in the order of instants and gaps."""
        rows = list(zip(*(column.tolist() for column in columns), strict=True))
        at, whole = 0, len(rows)
        pairs: dict[tuple[int, int], Pair] = {}
        for instant in range(count):
            found = np.inf
            while at < whole and rows[at][0] == instant:
                _, low, i, j, a, b = rows[at]
                at += 1
                if low >= found:
                    continue
                if (i, j) not in pairs:
                    pairs[i, j] = self._pair(i, j)
                distance = pairs[i, j].distance(placed.transform(a), placed.transform(b))
                found = min(found, distance)
            yield found


def _rows(number: int, asked: Asked) -> Iterator[tuple[Indices, Indices, Indices, Indices, Array]]:
    """Yield solids, number of the question, number of the time, and time of pairs to measure."""
    for members, start_s, end_s in asked.stays:
        now = np.nonzero((asked.times >= start_s) & (asked.times <= end_s))[0]
        if not len(now):
            continue
        ones = np.ones_like(now)
        for i in asked.first:
            for j in members:
                yield i * ones, j * ones, number * ones, now, asked.times[now]
