"""What a search knows of events already, and so what can add nothing to them.

Between the first and the last touch of a contact shorter intervals need no look. Of near misses,
and of events whose smallest distance is wanted, only what may be nearer than the smallest known
matters: of contacts, each with what its pair is allowed added.
"""

from typing import NamedTuple, TypeAlias

import numpy as np
import numpy.typing as npt

from vrts.check.collision.pairs.findings import HARDLY, REPORTED, Spans, Touch, spans
from vrts.check.collision.pairs.table import Pairs

Array: TypeAlias = npt.NDArray[np.float64]
Flags: TypeAlias = npt.NDArray[np.bool_]
Indices: TypeAlias = npt.NDArray[np.int64]

NEARBY = 0.008  # [s] what is so near to an event belongs to it, where its times are not wanted


class Times(NamedTuple):
    """Rows of pairs, each in an interval; all of shape (r,)."""

    row: Indices
    start_s: Array
    end_s: Array

    def at(self, which: Indices) -> "Times":
        """Return some of the rows."""
        return Times(self.row[which], self.start_s[which], self.end_s[which])


class KnownEvents:
    """The events of a search under way."""

    def __init__(
        self, pairs: Pairs, floor: Array, *, nearest: bool, begins: Array | None = None
    ) -> None:
        """Know none.

        Args:
            pairs: The pairs.
            floor: What a pair must reach to be no touch, shape (p,), in m.
            nearest: Whether the smallest distance of each event is wanted.
            begins: Times at which something else begins: no event lasts beyond one of them [s].
        """
        self.group = pairs.group
        self.begins = np.empty(0) if begins is None else begins
        self.tolerance = pairs.tolerance
        self.floor = floor
        self.nearest = nearest
        self.margin = NEARBY if nearest else REPORTED
        self.near_floor = np.full(len(floor), -np.inf)
        self.as_it_is = np.zeros(len(floor))
        self.contacts = self.near = spans([], self.group[:0], self.as_it_is)

    def look_near(self, counts: Flags, threshold: float) -> None:
        """Want near misses of some pairs too, nearer than a threshold [m]."""
        self.near_floor = np.where(counts, threshold - 2.0 * HARDLY, -np.inf)

    def touched(self, contacts: list[Touch]) -> None:
        """Take over all contacts found so far."""
        self.contacts = self._spans(contacts, self.tolerance)

    def neared(self, near: list[Touch]) -> None:
        """Take over all near misses found so far."""
        self.near = self._spans(near, self.as_it_is)

    def _spans(self, touches: list[Touch], above: Array) -> Spans:
        pair = np.array([touch.pair for touch in touches], dtype=np.int64)
        times = np.array([touch.time_s for touch in touches])
        return spans(touches, self._group_of(pair, times), above)

    def _group_of(self, row: Indices, time_s: Array) -> Indices:
        """Return whose events rows are part of at times; both (r,)."""
        group = self.group[row]
        if not len(self.begins):
            return group
        since = np.searchsorted(self.begins, time_s, side="right")
        return group * (len(self.begins) + 1) + since

    def floors(self, of: Times, slack: Array) -> tuple[Array, Flags]:
        """Return what rows must reach to be settled, and which lie in events like those.

        Args:
            of: The rows.
            slack: From this above the smallest distance on, nothing matters to an event, (r,) [m].
        """
        floor = self.floor[of.row]
        if self.nearest:
            matters = self.matters(of, slack)
            return np.minimum(floor, matters), matters < np.inf
        near = self.nears(of, slack)
        known = (-np.inf < near) & (near < self.near_floor[of.row])
        return np.maximum(floor, near), known

    def nears(self, of: Times, slack: Array) -> Array:
        """Return what rows must reach to be no near miss, or none that matters to its event."""
        floor, group = self.near_floor[of.row], self._group_of(of.row, of.start_s)
        at = self.near.over(group, of.start_s + NEARBY, of.end_s - NEARBY)
        if (at >= 0).any():
            floor = np.where(at >= 0, np.minimum(floor, self.near.least[at] + slack), floor)
        # in a contact there are none
        touching = self.contacts.over(group, of.start_s + REPORTED, of.end_s - REPORTED) >= 0
        return np.where(touching, -np.inf, floor)

    def matters(self, of: Times, slack: Array) -> Array:
        """Return how near rows must come to matter between two contacts of one event, (r,) [m].

        Inf is for rows that lie in none. Where the smallest distance of an event is wanted, what
        may be nearer than the smallest known matters; else nothing does. Of parts that may press
        differently deep, what is compared is how far they go beyond what they may.
        """
        start_s, end_s = of.start_s + self.margin, of.end_s - self.margin
        at = self.contacts.over(self._group_of(of.row, of.start_s), start_s, end_s)
        if not (at >= 0).any():
            return np.full(len(of.row), np.inf)
        beyond = self.contacts.least[at] + slack
        wanted = beyond - self.tolerance[of.row] if self.nearest else -np.inf
        return np.where(at >= 0, wanted, np.inf)
