"""A timeline at many times at once."""

from collections.abc import Sequence
from weakref import WeakKeyDictionary

import numpy as np
import numpy.typing as npt

from vrts.engine.memory.records import COORDINATES, Segment
from vrts.engine.timeline import Timeline

Array = npt.NDArray[np.float64]

_batches: "WeakKeyDictionary[Timeline, Batch]" = WeakKeyDictionary()


def batch_of(timeline: Timeline) -> "Batch":
    """Return a timeline as arrays; timelines do not change, so once is enough."""
    found = _batches.get(timeline)
    if found is None:
        found = _batches[timeline] = Batch(timeline.segments_or_start)
    return found


class Batch:
    """The segments of a timeline as arrays."""

    def __init__(self, segments: Sequence[Segment]) -> None:
        """Take the segments in time order, at least one, which may take no time."""
        self._starts = np.array([segment.start_s for segment in segments])
        self._ends = np.array([segment.end_s for segment in segments])
        powers = max(len(row) for segment in segments for row in segment.coefficients)
        self._powers = np.zeros((powers, len(segments), COORDINATES))
        for k, segment in enumerate(segments):
            for joint, row in enumerate(segment.coefficients):
                self._powers[: len(row), k, joint] = row

    def values(self, times: Array) -> Array:
        """Return six joints [rad] and the hand opening [m], shape (m, 7), at times of shape (m,).

        Before the first segment and after the last the arm stands still.
        """
        at, t = self._places(times)
        result = self._powers[-1, at]
        for c in self._powers[-2::-1]:
            result = result * t + c[at]
        return result

    def rates(self, times: Array) -> Array:
        """Return the derivatives of `values` [rad/s, m/s], shape (m, 7)."""
        at, t = self._places(times)
        result = np.zeros((len(times), COORDINATES))
        for k in range(len(self._powers) - 1, 0, -1):
            result = result * t + k * self._powers[k, at]
        result[(times < self._starts[0]) | (times >= self._ends[-1])] = 0.0
        return result

    def _places(self, times: Array) -> tuple[npt.NDArray[np.intp], Array]:
        """Return the segment of every time, and how far into it the time is [s], as a column."""
        at = np.maximum(np.searchsorted(self._starts, times, side="right") - 1, 0)
        return at, np.clip(times - self._starts[at], 0.0, (self._ends - self._starts)[at])[:, None]
