"""What the certified search notes down, and the numbers that decide what it is."""

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import NamedTuple, TypeAlias

import numpy as np
import numpy.typing as npt

from vrts.geometry.nearest import Engine

Array: TypeAlias = npt.NDArray[np.float64]
Indices: TypeAlias = npt.NDArray[np.int64]

GRAZE = 1e-5  # [m] shapes that overlap less than this do not even graze
BAND = 1e-5  # [m] this near to the tolerance a depth is undetermined
REPORTED = 1e-3  # [s] times of contact
COVERED = 0.016  # [s] inside a contact event shorter intervals are not looked into
EVENT_GAP = 0.5  # [s] contacts of one pair of names less than this apart are one event
CLEARANCE_TOLERANCE = 1e-4  # [m] of an engine that is exact enough
ROUNDING = 2e-6  # [m] of double precision in bounds


def pad_of(engine: Engine) -> float:
    """Return what is added to every bound: rounding and the error of the exact distance [m]."""
    return ROUNDING + engine.error


def slack_of(engine: Engine) -> float:
    """Return how exactly the smallest distance is certified [m]."""
    return max(CLEARANCE_TOLERANCE, 2.0 * pad_of(engine))


def margin_of(engine: Engine) -> float:
    """Return how near to a tolerance a measured depth is undetermined [m]."""
    return max(BAND, engine.error)


class Touch(NamedTuple):
    """A pair of solids found nearer than it should be."""

    pair: int  # row of the pairs
    start_s: float
    end_s: float
    time_s: float  # between the two
    distance: float  # signed, then [m]


class Closest(NamedTuple):
    """The smallest distance found."""

    distance: float  # [m]
    pair: int
    time_s: float


@dataclass(slots=True)
class Findings:
    """What a search finds."""

    contacts: list[Touch] = field(default_factory=list[Touch])
    grazes: list[Touch] = field(default_factory=list[Touch])
    open: list[Touch] = field(default_factory=list[Touch])
    closest: Closest = field(default_factory=lambda: Closest(np.inf, -1, 0.0))
    nodes: int = 0
    rows: int = 0
    exact: int = 0
    levels: int = 0


def spans(contacts: Sequence[Touch], group: Indices) -> dict[int, tuple[Array, Array]]:
    """Return, for each group, the intervals that one event covers."""
    by_group: dict[int, list[tuple[float, float]]] = {}
    for touch in contacts:
        by_group.setdefault(int(group[touch.pair]), []).append((touch.start_s, touch.end_s))
    covered: dict[int, tuple[Array, Array]] = {}
    for number, intervals in by_group.items():
        merged = merge(intervals)
        covered[number] = (np.array([a for a, _ in merged]), np.array([b for _, b in merged]))
    return covered


def merge(intervals: list[tuple[float, float]]) -> list[tuple[float, float]]:
    """Return intervals in order, those less than `EVENT_GAP` apart joined."""
    merged: list[tuple[float, float]] = []
    for start, end in sorted(intervals):
        if merged and start - merged[-1][1] < EVENT_GAP:
            merged[-1] = (merged[-1][0], max(merged[-1][1], end))
        else:
            merged.append((start, end))
    return merged
