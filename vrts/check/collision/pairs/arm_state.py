"""Where the arm is in a run, for many instants at once, and distances asked at chosen instants."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import NamedTuple, Protocol, TypeAlias

import numpy as np
import numpy.typing as npt

from vrts.check.collision.pairs.outside import outside
from vrts.check.curves.timeline_arrays import Curves
from vrts.engine.memory.events import Event
from vrts.engine.memory.records import GRAVITY, Motion, Placement, Segment
from vrts.geometry.proposing.proposer import Questions
from vrts.geometry.proving.prover import Bounds, Prover
from vrts.geometry.proving.rows import Placed, placed
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


class Gaps(NamedTuple):
    """What is known of the distance at each of those times; the same twice where it is exact."""

    lower: Array  # [m]
    upper: Array  # [m]


@dataclass(frozen=True, slots=True)
class Prober:
    """Distances between solids at chosen instants, proven."""

    arm: Arm
    curves: Curves
    solids: Solids
    prover: Prover

    def distances(self, first: Indices, second: Indices, time_s: Array) -> Array:
        """Return signed distances [m]; all arguments have shape (m,)."""
        if len(time_s) == 0:
            return np.empty(0)
        return self.prover.exact(*self._sides(first, second, time_s)).distance

    def told(self, first: Indices, second: Indices, time_s: Array) -> Bounds:
        """Return bounds, and points to tell people; the same bits whoever proposes."""
        return self.prover.told(*self._sides(first, second, time_s))

    def placed(
        self, first: Indices, second: Indices, time_s: Array
    ) -> tuple[Placed, Placed, Array]:
        """Return where solids are, and how far apart at least, by their boxes [m]; all (m,)."""
        places, a, b = self._placed(first, second, time_s)
        return placed(places, first, a), placed(places, second, b), outside(places, a, b)

    def questions(self, first: Indices, second: Indices, time_s: Array) -> Questions:
        """Return what a proposer is asked about solids at times; all arguments are (m,)."""
        return self.prover.questions(*self._sides(first, second, time_s))

    def _sides(self, first: Indices, second: Indices, time_s: Array) -> tuple[Placed, Placed]:
        places, a, b = self._placed(first, second, time_s)
        return placed(places, first, a), placed(places, second, b)

    def _placed(
        self, first: Indices, second: Indices, time_s: Array
    ) -> tuple[Places, Indices, Indices]:
        """Return places, and which of them those of each question are."""
        times, at = np.unique(time_s, return_inverse=True)
        state = instants(self.arm, self.curves, times)
        still = (self.solids.frame == 0) & ~self.solids.falls
        keys = [s * len(times) + np.where(still[s], 0, at) for s in (first, second)]
        known, place = np.unique(np.concatenate(keys), return_inverse=True)
        places = self.solids.places(state, *np.divmod(known, len(times)), GRAVITY)
        return places, place[: len(first)], place[len(first) :]

    def gaps(self, asked: Sequence[Asked], far: float, *, exact: bool = True) -> list[Gaps]:
        """Return the distances between unions of solids; inf while nothing is there.

        Args:
            asked: The questions; what they have in common is done once.
            far: Larger distances may be told too small, down to this [m].
            exact: Whether one number is wanted for each, not just what is proven at once.
        """
        sizes = [len(one.times) for one in asked]
        lower, upper = (np.full(sum(sizes), np.inf) for _ in range(2))
        begins = np.cumsum([0, *sizes])
        rows = [own for k, one in enumerate(asked) for own in _rows(int(begins[k]), one)]
        if rows:
            first, second, instant, times = (np.concatenate(c) for c in zip(*rows, strict=True))
            places, a, b = self._placed(first, second, times)
            least = outside(places, a, b)
            # the nearest by their boxes first; most of the others need not be asked then
            order = np.lexsort((least, instant))
            nearest = order[np.unique(instant[order], return_index=True)[1]]
            rest = np.ones(len(order), dtype=np.bool_)
            rest[nearest] = False
            for some in (nearest, order[rest[order]]):
                near = some[least[some] < np.minimum(upper[instant[some]], far)]
                sides = placed(places, first[near], a[near]), placed(places, second[near], b[near])
                found = self.prover.exact(*sides, far) if exact else self.prover.at_once(*sides)
                low, high = (found.distance,) * 2 if exact else (found.lower, found.upper)
                # what is only known to be farther than that is that far
                is_far = found.lower >= far
                np.minimum.at(lower, instant[near], np.where(is_far, found.lower, low))
                np.minimum.at(upper, instant[near], np.where(is_far, found.lower, high))
                away = some[least[some] >= far]
                np.minimum.at(lower, instant[away], least[away])
                np.minimum.at(upper, instant[away], least[away])
        cuts = begins[1:-1]
        return [
            Gaps(*own) for own in zip(np.split(lower, cuts), np.split(upper, cuts), strict=True)
        ]


def _rows(begin: int, asked: Asked) -> Iterator[tuple[Indices, Indices, Indices, Array]]:
    """Yield solids, number of the instant, and time of pairs to measure.

    Args:
        begin: Number of the first instant of this question.
        asked: The question.
    """
    for members, start_s, end_s in asked.stays:
        now = np.nonzero((asked.times >= start_s) & (asked.times <= end_s))[0]
        if not len(now):
            continue
        ones = np.ones_like(now)
        for i in asked.first:
            for j in members:
                yield i * ones, j * ones, begin + now, asked.times[now]
