"""Where the arm is in a run, for many instants at once, and distances asked at chosen instants."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Protocol, TypeAlias

import numpy as np
import numpy.typing as npt

from vrts.check.curves import Curves
from vrts.engine.events import Event
from vrts.engine.records import GRAVITY, Motion, Placement, Segment
from vrts.geometry.nearest import Engine, Nearest, Pair, Transform
from vrts.geometry.solids import Frames, Instants, Solids
from vrts.robots.batch import link_frames
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
        times, at = np.unique(time_s, return_inverse=True)
        state = instants(self.arm, self.curves, times)
        still = (self.solids.frame == 0) & ~self.solids.falls
        keys = [s * len(times) + np.where(still[s], 0, at) for s in (first, second)]
        known, place = np.unique(np.concatenate(keys), return_inverse=True)
        places = self.solids.places(state, *np.divmod(known, len(times)), GRAVITY)
        transforms = list(map(self.engine.transform, places.rotations, places.origins))
        shapes = self.solids.shapes
        count = len(first)
        i: list[int] = first.tolist()
        j: list[int] = second.tolist()
        a: list[int] = place[:count].tolist()
        b: list[int] = place[count:].tolist()
        for k in range(count):
            yield self.engine.pair(shapes[i[k]], shapes[j[k]]), transforms[a[k]], transforms[b[k]]

    def gap(self, first: Sequence[int], second: Sequence[int], time_s: Array) -> Array:
        """Return the distance [m] between two unions of solids at times of shape (m,)."""
        pairs = [(i, j) for i in first for j in second]
        count = len(time_s)
        a = np.repeat(np.array([i for i, _ in pairs], dtype=np.int64), count)
        b = np.repeat(np.array([j for _, j in pairs], dtype=np.int64), count)
        found = self.distances(a, b, np.tile(time_s, len(pairs)))
        return found.reshape(len(pairs), count).min(axis=0)
