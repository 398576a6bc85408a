"""What the certified search notes down, and the numbers that decide what it is."""

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import NamedTuple, TypeAlias

import numpy as np
import numpy.typing as npt

from vrts.geometry.proving.rows import ROUNDING

Array: TypeAlias = npt.NDArray[np.float64]
Indices: TypeAlias = npt.NDArray[np.int64]

GRAZE = 1e-5  # [m] shapes that overlap less than this do not even graze
BAND = 1e-5  # [m] this near to the tolerance a depth is undetermined
REPORTED = 1e-3  # [s] times of contact
COVERED = 0.016  # [s] inside a contact event shorter intervals are not looked into
EVENT_GAP = 0.5  # [s] contacts of one pair of names less than this apart are one event
SLACK = 1e-4  # [m] how exactly the smallest distance is certified
PAD = ROUNDING  # [m] added to every bound on an approach


class Touch(NamedTuple):
    """A pair of solids found nearer than it should be."""

    pair: int  # row of the pairs
    start_s: float
    end_s: float
    time_s: float  # between the two
    distance: float  # signed, then: not exceeded; NaN: not known [m]
    least: float = -np.inf  # nor is it less than this [m]


class Closest(NamedTuple):
    """The smallest distance found."""

    distance: float  # not exceeded [m]
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
    asked: int = 0
    searched: int = 0
    levels: int = 0


class Spans(NamedTuple):
    """The events of one pair of names, in order of time; arrays of shape (e,)."""

    starts: Array  # [s]
    ends: Array
    least: Array  # smallest distance known of each [m]


def spans(contacts: Sequence[Touch], group: Indices) -> dict[int, Spans]:
    """Return, for each group, the intervals that one event covers."""
    by_group: dict[int, list[Touch]] = {}
    for touch in contacts:
        by_group.setdefault(int(group[touch.pair]), []).append(touch)
    covered: dict[int, Spans] = {}
    for number, touches in by_group.items():
        merged = merge([(touch.start_s, touch.end_s) for touch in touches])
        starts = np.array([a for a, _ in merged])
        least = np.full(len(merged), np.inf)
        event = np.searchsorted(starts, [touch.start_s for touch in touches], side="right") - 1
        np.minimum.at(least, event, [touch.distance for touch in touches])
        covered[number] = Spans(starts, np.array([b for _, b in merged]), least)
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
