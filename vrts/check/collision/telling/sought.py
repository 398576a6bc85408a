"""What an event is, before its times are known: which pairs take part, and what counts for them."""

from collections.abc import Sequence
from typing import NamedTuple, TypeAlias

import numpy as np
import numpy.typing as npt

from vrts.check.collision.pairs.findings import BAND, GRAZE, SLACK, Leaves, Touch, leaves
from vrts.check.collision.pairs.table import Pairs
from vrts.check.collision.telling.episodes import Episode

Array: TypeAlias = npt.NDArray[np.float64]
Flags: TypeAlias = npt.NDArray[np.bool_]
Indices: TypeAlias = npt.NDArray[np.int64]


class Sought(NamedTuple):
    """An event whose deepest moment is sought."""

    episode: Episode
    rows: Indices  # (r,) of the pairs that take part, in order
    above: Array  # (r,) added to a distance before it is compared: what is allowed [m]
    limit: Array  # (r,) nearer than this lies within the event [m]
    leaves: Leaves  # intervals in which it may be deepest
    nearer: tuple[Touch, ...] = ()  # found since, and no part of what it lasts

    @property
    def best(self) -> float:
        """What the search knows to be reached, with what is allowed [m]; inf: nothing."""
        return min((d for d, _ in self._measured), default=np.inf)

    @property
    def known(self) -> Touch:
        """The deepest touch that the search has found, the earliest of several."""
        touches = self.episode.touches
        return min(self._measured, default=(np.inf, touches[0]), key=lambda own: own[0])[1]

    @property
    def likely(self) -> Leaves:
        """Those of its leaves that are not ruled out by what is known."""
        least = self.leaves.least + self.above_of(self.leaves.pair)
        return self.leaves.at(np.flatnonzero(least < self.best + SLACK))

    @property
    def _measured(self) -> list[tuple[float, Touch]]:
        every = (*self.episode.touches, *self.nearer)
        touches = [touch for touch in every if not np.isnan(touch.distance)]
        above = self.above_of(np.array([touch.pair for touch in touches], dtype=np.int64))
        return [(t.distance + own, t) for t, own in zip(touches, above.tolist(), strict=True)]

    def above_of(self, pair: Indices) -> Array:
        """Return what is allowed of some of its pairs [m]."""
        return self.above[np.searchsorted(self.rows, pair)]

    def within(self, found: Sequence[Touch], more: Leaves) -> "Sought":
        """Return the same, with what a closer look has found of its pairs."""
        return self._replace(leaves=leaves([self.leaves, more]), nearer=(*self.nearer, *found))


def contact(episode: Episode, pairs: Pairs) -> Sought:
    """Return an event deeper than is allowed."""
    return _sought(episode, pairs, np.isfinite(pairs.tolerance), 0.0)


def doubtful(episode: Episode, pairs: Pairs) -> Sought:
    """Return an event that may be deeper than is allowed."""
    return _sought(episode, pairs, np.isfinite(pairs.tolerance), BAND)


def graze(episode: Episode, pairs: Pairs) -> Sought:
    """Return an event that is less deep."""
    return _sought(episode, pairs, pairs.grazes, -GRAZE, np.zeros(len(pairs.first)))


def near_miss(episode: Episode, pairs: Pairs, threshold: float) -> Sought:
    """Return an event nearer than a threshold [m]."""
    return _sought(episode, pairs, pairs.counts, threshold, np.zeros(len(pairs.first)))


def _sought(
    episode: Episode, pairs: Pairs, part: Flags, limit: float, above: Array | None = None
) -> Sought:
    rows = np.flatnonzero(part & (pairs.group == episode.group))
    allowed = (pairs.tolerance if above is None else above)[rows]
    return Sought(episode, rows, allowed, limit - allowed, leaves([]))
