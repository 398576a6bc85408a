"""Many instants of a run that are looked at together, and what variables held at each."""

from collections.abc import Sequence
from typing import NamedTuple, TypeAlias, cast

import numpy as np
from numpy.typing import NDArray

from vrts.base.numbers import round_half_away
from vrts.base.pose import Pose
from vrts.debug.conditions.columns import (
    Bools,
    Reals,
    Regimes,
    Told,
    Wholes,
    pose_of,
    poses,
    regimes,
    told,
)
from vrts.debug.conditions.hearing import Hear
from vrts.engine.memory.cells import Array, Bound, Cell
from vrts.ir.ranges import HIGHEST_SUBSCRIPT

FEW = 8  # elements of an array that are looked up one after the other, each at all instants

Source: TypeAlias = "Bound | list[Bound] | None"
"""What a name stands for: at all instants the same, or at each another."""


Lanes: TypeAlias = NDArray[np.intp]
"""Which of some instants."""


class Moments(NamedTuple):
    """Instants, as columns."""

    times: Reals  # [s]
    finished: Wholes  # statements of both programs
    process: Bools  # whether the process control program asks

    def some(self, lanes: Lanes) -> "Moments":
        """Return some of them."""
        return Moments(self.times[lanes], self.finished[lanes], self.process[lanes])


class Histories:
    """Histories of the variables of one run as arrays, each made when it is first asked for."""

    def __init__(self) -> None:
        """Know nothing yet."""
        self._told: dict[int, tuple[Cell, Told]] = {}
        self._poses: dict[int, tuple[Reals, ...]] = {}
        self._regimes: dict[int, tuple[Array, Regimes | None]] = {}

    def of(self, cell: Cell) -> Told:
        """Return the history of a cell."""
        known = self._told.get(id(cell))
        if known is None:
            known = self._told[id(cell)] = cell, told(cell)
        return known[1]

    def poses_of(self, cell: Cell) -> tuple[Reals, ...]:
        """Return the poses that a cell held, as columns."""
        found = self._poses.get(id(cell))
        if found is None:
            found = self._poses[id(cell)] = poses(self.of(cell))
        return found

    def regimes_of(self, array: Array) -> Regimes | None:
        """Return which classes the elements of an array have; None where that is not so simple."""
        known = self._regimes.get(id(array))
        if known is None:
            known = self._regimes[id(array)] = array, regimes(array)
        return known[1]


class Block:
    """Instants that are looked at together, and at which of them nothing is sure any more.

    Where something is unusual - no value, a division by zero - the instant is marked, and asked
    alone afterwards: so it fails in the same way as if it had been asked alone at once.
    """

    def __init__(
        self, moments: Moments, sources: Sequence[Source], histories: Histories, hear: Hear
    ) -> None:
        """Take instants, what the names stand for then, and who is heard meanwhile."""
        self.times, self.finished, self.process = moments
        self.hear = hear
        self.chance: Wholes | None = None  # after the numbers that an expression has drawn so far
        self.count = len(self.times)
        self.unsure: Bools = np.zeros(self.count, bool)
        self.sources = sources
        self.histories = histories
        self._distinct: tuple[Reals, Wholes] | None = None

    def some(self, lanes: Lanes) -> "Block":
        """Return some of the instants, all of which are sure."""
        which: list[int] = lanes.tolist()
        sources: list[Source] = [
            [source[k] for k in which] if isinstance(source, list) else source
            for source in self.sources
        ]
        moments = Moments(self.times, self.finished, self.process).some(lanes)
        return Block(moments, sources, self.histories, self.hear)

    @property
    def distinct(self) -> tuple[Reals, Wholes]:
        """Every time once, and beside each instant which of them is its own."""
        if self._distinct is None:
            times, which = np.unique(self.times, return_inverse=True)
            self._distinct = times, which
        return self._distinct

    def spread(self, values: Reals) -> Reals:
        """Return what is known of every distinct time, for all instants."""
        return values[self.distinct[1]]

    def mark(self, unusual: "Bools | np.bool_") -> None:
        """Note that some instants are to be asked alone."""
        self.unsure |= unusual

    def reals(self, k: int) -> Reals:
        """Return the reals that a name stood for."""
        self.hear()
        source = self.sources[k]
        if isinstance(source, list):
            after: list[int] = self.finished.tolist()
            found = np.array(
                [
                    _real(bound if isinstance(bound, Cell) else None, finished)
                    for bound, finished in zip(source, after, strict=True)
                ],
                np.float64,
            )
        elif isinstance(source, Cell):
            known = self.histories.of(source)
            found = known.reals[known.places(self.finished)]
        else:
            found = np.full(self.count, np.nan)
        self.mark(np.isnan(found))
        return found

    def pose(self, k: int) -> Pose:
        """Return the poses that a name stood for."""
        self.hear()
        source = self.sources[k]
        if not isinstance(source, Cell):
            self.mark(np.ones(self.count, bool))
            return pose_of((np.full(self.count, np.nan),) * 12)
        at = self.histories.of(source).places(self.finished)
        columns = tuple([column[at] for column in self.histories.poses_of(source)])
        self.mark(np.isnan(columns[0]))
        return pose_of(columns)

    def elements(self, k: int, subscripts: Sequence[Reals]) -> Reals:
        """Return the reals that elements of an array held."""
        self.hear()
        source = self.sources[k]
        found = np.full(self.count, np.nan)
        if isinstance(source, Array):
            columns = [np.broadcast_to(s, self.count) for s in subscripts]
            whole = np.stack([np.where(np.isfinite(s), s, -1.0) for s in columns])
            inside = np.where(whole >= 0.0, np.floor(whole + 0.5), -1.0)
            self.mark(((inside < 0.0) | (inside > HIGHEST_SUBSCRIPT)).any(axis=0))
            keys, which = np.unique(inside, axis=1, return_inverse=True)
            which = which.reshape(-1)
            if keys.shape[1] <= FEW:
                for n, key in enumerate(keys.T.tolist()):
                    here = which == n
                    found[here] = self._element(source, key, self.finished[here])
            else:
                found = self._each_element(source, keys.T.tolist(), which)
        self.mark(np.isnan(found))
        return found

    def _element(self, array: Array, key: "list[float]", finished: Wholes) -> "Reals | float":
        cell = array.elements.get(tuple(map(round_half_away, key)))
        if cell is None:
            return np.nan
        known = self.histories.of(cell)
        return known.reals[known.places(finished)]

    def _each_element(self, array: Array, keys: "list[list[float]]", which: Wholes) -> Reals:
        cells = [array.elements.get(tuple(map(round_half_away, key))) for key in keys]
        after: list[int] = self.finished.tolist()
        places: list[int] = which.tolist()
        held = [_real(cells[n], finished) for n, finished in zip(places, after, strict=True)]
        return np.array(held, np.float64)


def _real(cell: Cell | None, finished: int) -> float:
    """Return the real in a cell after so many statements; not a number where there is none."""
    content = None if cell is None else cell.at(finished)
    return content if isinstance(content, float) else np.nan


def reals_of(values: object, count: int) -> Reals:
    """Return a column, or one number for all instants, as a column."""
    return np.broadcast_to(cast("Reals", values), count)
