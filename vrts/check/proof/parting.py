"""When fingers have let go of what they held, and when what is carried is near on purpose.

By the rules of `check.collision.pairs.grips`, with distances of our own.
"""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from vrts.check.proof.given import (
    NEAR,
    Array,
    Covered,
    LetGo,
    Parted,
    Points,
    Span,
    Stay,
    common,
)
from vrts.check.proof.look import Look, points_of
from vrts.check.proof.meeting_points import Met
from vrts.check.proof.plainer import plainer
from vrts.engine.memory.records import Lie

APART = 2e-4  # [m] a finger farther than this has let go
FINE = 14e-3  # [s] between instants at which that is looked at
COARSE = 56e-3  # [s] between those at which the way apart is followed
AWAY = 50e-3  # [m] so far apart a pair has parted
BATCH = 16  # instants looked at together
STILL = (Lie.RESTING, Lie.TOPPLED)


class _Sides(NamedTuple):
    """Two unions whose distance is followed."""

    look: Look
    rows: Sequence[tuple[Sequence[int], Sequence[int], Span]]
    mirrored_s: float | None = None  # to look backward in time: the sum of both ends

    def __call__(self, time_s: Array) -> list[float]:
        """Return distances at times [m]; inf while nothing is there."""
        times = time_s if self.mirrored_s is None else self.mirrored_s - time_s
        seen = self.look.nearest(times, self.rows)
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
        apart_s, away_s = _parting(sides, window.open_s, window.until_s, APART, near_miss)
        found.append(LetGo(stays[0].body, number, window.grip, apart_s, away_s))
    return tuple(found)


def near_points(look: Look, todo: Covered) -> Points:
    """Return points that show what is to be shown of things that are near each other."""
    shown: list[tuple[float, int, int, Met]] = []
    shapes = look.all_of.shapes
    for first, stays, times, most_m in todo.near:
        sides = [(first, stay.solids, stay.span) for stay in stays]
        for t, seen in zip(times, look.nearest(np.array(times), sides), strict=True):
            if seen is not None:
                both = shapes[seen.first], shapes[seen.second]
                shown.append((t, seen.first, seen.second, plainer(seen.met, both, most_m)))
    return points_of(NEAR, shown)


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
                from_s = min(_parting(sides, start_s, end_s, near_miss, near_miss)[1], end_s)
            if other.body == stay.after:
                back = sides._replace(mirrored_s=start_s + end_s)
                to_s = start_s + end_s - _parting(back, start_s, end_s, near_miss, near_miss)[1]
            found.append(Parted(stay.body, stay.number, other.body, from_s, max(to_s, from_s)))
    return tuple(found)


def _parting(
    ask: _Sides, start_s: float, end_s: float, apart: float, near_miss: float | None
) -> tuple[float, float]:
    """Return when a gap first exceeds `apart`, and when it is no longer that of parting."""
    separated: float | None = None
    before, first, count = -np.inf, start_s, BATCH
    while first < end_s:
        step_s = FINE if separated is None else COARSE
        times = np.minimum(first + step_s * np.arange(count), end_s)
        for t, distance in zip(times.tolist(), ask(times), strict=True):
            if separated is None and distance > apart:
                separated = t
                if near_miss is None:
                    return t, t
            shrinks = near_miss is not None and before > near_miss and distance < before - 1e-6
            if shrinks or distance > AWAY:
                return (t if separated is None else separated), t
            before = distance
        first = float(times[-1]) + step_s
        count *= 1 if separated is None else 2
    return (end_s if separated is None else separated), end_s
