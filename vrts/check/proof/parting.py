"""When fingers have let go of what they held, and when what is carried is near on purpose.

By the rules of `check.collision.pairs.grips`, with distances of our own.
"""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np

from vrts.check.proof.given import Covered, LetGo, Parted, Span, Stay, common, steps
from vrts.check.proof.look import Look
from vrts.engine.memory.records import Lie

APART = 2e-4  # [m] a finger farther than this has let go
FINE = 14e-3  # [s] between instants at which that is looked at
COARSE = 56e-3  # [s] between those at which the way apart is followed
AWAY = 50e-3  # [m] so far apart a pair has parted
SHRUNK = 1e-6  # [m] what is nearer by less than at the look before is no nearer
BATCH = 16  # instants looked at together, at first
STILL = (Lie.RESTING, Lie.TOPPLED)


class _Sides(NamedTuple):
    """Two unions whose distance is followed."""

    look: Look
    rows: Sequence[tuple[Sequence[int], Sequence[int], Span]]
    mirrored_s: float | None = None  # to look backward in time: the sum of both ends

    def __call__(self, time_s: Sequence[float]) -> list[float]:
        """Return distances at times [m]; inf while nothing is there."""
        times = np.array(time_s)
        seen = self.look.nearest(
            times if self.mirrored_s is None else self.mirrored_s - times, self.rows
        )
        return [np.inf if one is None else one.distance for one in seen]


def let_go(look: Look, todo: Covered, near_miss: float | None) -> tuple[LetGo, ...]:
    """Return when each finger has let go of each body.

    Args:
        look: At the run.
        todo: What is to be covered, with grips that end when the hand opens.
        near_miss: Nearer than this is a near miss [m]; None: distances are not wanted.
    """
    found: list[LetGo] = []
    for finger, stays, window, number in todo.releases:
        if window.grip < 0 or window.open_s >= window.until_s:
            continue
        sides = _Sides(look, [(finger, stay.solids, stay.span) for stay in stays])
        apart_s = away_s = _apart(sides, window.open_s, window.until_s)
        if near_miss is not None:
            away_s = max(apart_s, _away(sides, window.open_s, window.until_s, near_miss))
        found.append(LetGo(stays[0].body, number, window.grip, apart_s, away_s))
    return tuple(found)


def near_on_purpose(look: Look, stays: Sequence[Stay], near_miss: float) -> tuple[Parted, ...]:
    """Return when the distance of what is carried from what it leaves or goes to counts."""
    found: list[Parted] = []
    for stay in (s for s in stays if s.lie is Lie.HELD):
        for other in (s for s in stays if s.lie in STILL and s.body != stay.body):
            start_s, end_s = common(stay.span, other.span)
            if end_s <= start_s or other.body not in stay.partners:
                continue
            sides = _Sides(look, [(stay.solids, other.solids, (-np.inf, np.inf))])
            from_s, to_s = start_s, end_s
            if other.body == stay.before:
                from_s = _away(sides, start_s, end_s, near_miss)
            if other.body == stay.after:
                back = sides._replace(mirrored_s=start_s + end_s)
                to_s = start_s + end_s - _away(back, start_s, end_s, near_miss)
            found.append(Parted(stay.body, stay.number, other.body, from_s, max(to_s, from_s)))
    return tuple(found)


def _apart(ask: _Sides, start_s: float, end_s: float) -> float:
    """Return when a gap is first seen to exceed `APART`; the end if never."""
    for times in _batches(steps(start_s, end_s, FINE)):
        for t, distance in zip(times, ask(times), strict=True):
            if distance > APART:
                return t
    return end_s


def _away(ask: _Sides, start_s: float, end_s: float, near_miss: float) -> float:
    """Return when a gap is no longer that of parting: at the end if it always is."""
    before, far = -np.inf, max(near_miss, APART)
    for times in _batches(steps(start_s, end_s, COARSE)):
        for t, distance in zip(times, ask(times), strict=True):
            if (before > far and distance < before - SHRUNK) or distance > AWAY:
                return t
            before = distance
    return end_s


def _batches(times: list[float]) -> Iterator[list[float]]:
    """Yield times, more and more at once."""
    first, count = 0, BATCH
    while first < len(times):
        yield times[first : first + count]
        first, count = first + count, 2 * count
