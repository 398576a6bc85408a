"""Histories of variables as columns: what each held at many instants, looked up at once."""

from typing import NamedTuple, TypeAlias, cast

import numpy as np
from numpy.typing import NDArray

from vrts.base.pose import Pose
from vrts.engine.memory.cells import Array, Cell, Content, Undefined

Reals: TypeAlias = NDArray[np.float64]
Wholes: TypeAlias = NDArray[np.int64]
Bools: TypeAlias = NDArray[np.bool_]

NUMBERS_OF_A_POSE = 12


class Told(NamedTuple):
    """All values of a cell in order, the first one for the time before it had any."""

    since: Wholes  # statements finished, one less than there are values
    kinds: tuple[type, ...]
    codes: NDArray[np.uint8]  # of each value, which of the kinds it is
    reals: Reals  # not a number where it is no real
    contents: "list[Content] | None"  # None: all are reals

    def places(self, finished: Wholes) -> Wholes:
        """Return which of the values holds after each number of statements."""
        return np.searchsorted(self.since, finished, side="right")


def told(cell: Cell) -> Told:
    """Return the history of a cell as arrays of its own."""
    since = np.array(cell.since, np.int64)
    if not isinstance(cell.values, list):
        codes = np.ones(len(since) + 1, np.uint8)
        codes[0] = 0
        reals = np.concatenate(([np.nan], np.array(cell.values, np.float64)))
        return Told(since, (Undefined, float), codes, reals, None)
    contents = cell.values
    classes = [content.__class__ for content in contents]
    kinds = tuple(dict.fromkeys((Undefined, *classes)))
    number = {kind: k for k, kind in enumerate(kinds)}
    codes = np.array([0, *(number[kind] for kind in classes)], np.uint8)
    values = [content if content.__class__ is float else np.nan for content in contents]
    return Told(since, kinds, codes, np.array([np.nan, *values], np.float64), contents)


def poses(told_: Told) -> tuple[Reals, ...]:
    """Return the twelve numbers of each value that is a pose, as columns; else not a number."""
    rows = np.full((len(told_.reals), NUMBERS_OF_A_POSE), np.nan)
    for k, content in enumerate(told_.contents or (), 1):
        if isinstance(content, Pose):
            rows[k] = (*content.rotation, *content.translation)
    return tuple(rows.T)


def pose_of(columns: "tuple[Reals, ...]") -> Pose:
    """Return twelve columns as a pose whose numbers are columns: its arithmetic is the same."""
    return Pose(cast("tuple[float, ...]", columns[:9]), cast("tuple[float, ...]", columns[9:]))  # type: ignore[arg-type]


class Regimes(NamedTuple):
    """Which classes the elements of an array of reals have: some none yet, some a value."""

    first: float  # statements finished, from which on an element has a value; inf: never
    last: float  # ... and from which on all have one
    some: bool  # there are elements

    def codes(self, finished: Wholes) -> NDArray[np.uint8]:
        """Return for each number of statements 1 where one is undefined, plus 2 where one is."""
        if not self.some:
            return np.zeros(len(finished), np.uint8)
        return ((finished < self.last) + 2 * (finished >= self.first)).astype(np.uint8)

    @staticmethod
    def kind(code: int) -> "frozenset[type]":
        """Return what a code stands for."""
        return frozenset(kind for bit, kind in ((1, Undefined), (2, float)) if code & bit)


def regimes(array: Array) -> Regimes | None:
    """Return that of an array; None where elements were something else than reals."""
    starts: list[float] = []
    for cell in array.elements.values():
        if isinstance(cell.values, list):
            return None
        starts.append(cell.since[0] if cell.since else np.inf)
    return Regimes(min(starts, default=np.inf), max(starts, default=np.inf), bool(starts))
