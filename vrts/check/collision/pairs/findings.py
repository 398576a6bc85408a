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
HARDLY = 5e-6  # [m] what is not nearer than a threshold by so much is no near miss
LEAF = 0.02  # [s] no longer than this are intervals that may hold a smallest distance
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


class Leaves(NamedTuple):
    """Intervals in which pairs may come within `SLACK` of a smallest distance; shape (m,)."""

    pair: Indices  # rows of the pairs
    start_s: Array
    end_s: Array
    least: Array  # they stay apart by so much throughout [m]

    def at(self, which: Indices) -> "Leaves":
        """Return some of them."""
        times = self.start_s[which], self.end_s[which]
        return Leaves(self.pair[which], *times, self.least[which])


def leaves(parts: Sequence[Leaves]) -> Leaves:
    """Return the leaves of several lists as one."""
    nowhere, nothing = np.empty(0, dtype=np.int64), np.empty(0)
    return Leaves(
        np.concatenate([nowhere, *(own.pair for own in parts)]),
        np.concatenate([nothing, *(own.start_s for own in parts)]),
        np.concatenate([nothing, *(own.end_s for own in parts)]),
        np.concatenate([nothing, *(own.least for own in parts)]),
    )


@dataclass(slots=True)
class Findings:
    """What a search finds.

    Of what enters the smallest distance, or of the events of which it is wanted, every pair and
    moment that comes within `SLACK` of the smallest distance known lies in one of the leaves.
    """

    contacts: list[Touch] = field(default_factory=list[Touch])
    grazes: list[Touch] = field(default_factory=list[Touch])
    open: list[Touch] = field(default_factory=list[Touch])
    near: list[Touch] = field(default_factory=list[Touch])
    closest: Closest = field(default_factory=lambda: Closest(np.inf, -1, 0.0))
    leaves: list[Leaves] = field(default_factory=list[Leaves])
    nodes: int = 0
    rows: int = 0
    asked: int = 0
    searched: int = 0
    levels: int = 0


class Spans(NamedTuple):
    """The events of pairs of names, by group and then in order of time; shape (e,)."""

    group: Indices
    starts: Array  # [s]
    ends: Array
    least: Array  # smallest distance known of each, with what is added [m]

    def over(self, group: Indices, start_s: Array, end_s: Array) -> Indices:
        """Return the event of a group in which an interval lies; -1: in none; all (m,)."""
        if not len(self.group):
            return np.full(len(group), -1)
        first = np.searchsorted(self.group, group)
        # by group and start at once: events of one group are in order
        low = min(float(self.starts.min()), float(start_s.min(initial=np.inf)))
        range_s = max(float(self.starts.max()), float(start_s.max(initial=-np.inf))) - low + 1.0
        keys = self.group * range_s + (self.starts - low)
        at = np.searchsorted(keys, group * range_s + (start_s - low), side="right") - 1
        inside = (at >= first) & (at >= 0)
        inside &= end_s <= self.ends[at]
        return np.where(inside, at, -1)


def spans(touches: Sequence[Touch], group: Indices, above: Array) -> Spans:
    """Return the intervals that one event covers, of each group.

    Args:
        touches: Of any pairs.
        group: The group of each touch.
        above: Added to distances before they are compared: what each pair is allowed, (p,) [m].
    """
    pair = np.array([touch.pair for touch in touches], dtype=np.int64)
    table = np.array([(t.start_s, t.end_s, t.distance) for t in touches]).reshape(-1, 3)
    table[:, 2] += above[pair]
    order = np.lexsort((table[:, 0], group))
    own, (starts, ends, distances) = group[order], table[order].T
    new = np.ones(len(order), dtype=np.bool_)
    new[1:] = own[1:] != own[:-1]
    # the latest end so far, of the same group
    range_s = float(np.ptp(table[:, :2])) + 1.0 if len(order) else 1.0
    turn = np.cumsum(new) * 2.0 * range_s
    until = np.maximum.accumulate(ends + turn) - turn
    new[1:] |= starts[1:] - until[:-1] >= EVENT_GAP
    first = np.flatnonzero(new)
    if not len(first):
        return Spans(own, starts, ends, distances)
    return Spans(
        own[first],
        starts[first],
        np.maximum.reduceat(ends, first),
        np.minimum.reduceat(distances, first),
    )


def merge(intervals: list[tuple[float, float]]) -> list[tuple[float, float]]:
    """Return intervals in order, those less than `EVENT_GAP` apart joined."""
    merged: list[tuple[float, float]] = []
    for start, end in sorted(intervals):
        if merged and start - merged[-1][1] < EVENT_GAP:
            merged[-1] = (merged[-1][0], max(merged[-1][1], end))
        else:
            merged.append((start, end))
    return merged
