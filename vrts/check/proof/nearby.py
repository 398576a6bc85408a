"""Points that show that things are near each other on purpose: proposals for a certificate.

Of two unions the points of their nearest pair show how near they are at an instant. Where they were
farther apart than a near miss at the look before, points of other pairs show by their directions
that they have not come nearer since.
"""

from typing import TypeAlias

import numpy as np

from vrts.check.proof.checker import SHRUNK, Check, Moments, least
from vrts.check.proof.given import KEEPS, NEAR, Array, Near, Points
from vrts.check.proof.look import Look, points_of
from vrts.check.proof.meeting_points import Met
from vrts.check.proof.plainer import plainer, variants
from vrts.check.proof.tables import beyond_m

KEPT = 0.4 * SHRUNK  # [m] so much of what may be lost goes to plainer numbers

Shown: TypeAlias = list[tuple[float, int, int, Met]]


def near_points(look: Look, it: Check) -> tuple[Points, Points]:
    """Return points that show how near things are, and points that show that they keep apart."""
    far_m = beyond_m(it.claims)
    near, keeps = Shown(), Shown()
    for one in it.todo.near:
        sides = [(one.first, stay.solids, stay.span) for stay in one.stays]
        seen = look.nearest(np.array(one.times), sides)
        apart = [np.inf if own is None else own.distance for own in seen]
        before_m, later_m = 0.0, [*apart, np.inf][1:]
        for t, own, later in zip(one.times, seen, later_m, strict=True):
            if own is None:
                break  # the checker will say so
            if before_m > far_m:
                keeps += _keeping(look, it, one, t, before_m - SHRUNK)
            wanted = far_m if own.distance < far_m else _between(own.distance, later) + KEPT
            before_m = min(one.most_m, wanted)
            both = look.all_of.shapes[own.first], look.all_of.shapes[own.second]
            near.append((t, own.first, own.second, plainer(own.met, both, before_m)))
    keeps.sort(key=lambda row: (row[1], row[2], row[0]))  # what is alike packs better together
    return points_of(NEAR, near), points_of(KEEPS, keeps)


def _keeping(look: Look, it: Check, one: Near, t: float, least_m: float) -> Shown:
    """Return points of the pairs at an instant whose boxes are not so far apart."""
    there = [s for stay in one.stays if stay.span[0] <= t <= stay.span[1] for s in stay.solids]
    a, b = np.repeat(np.array(one.first), len(there)), np.tile(np.array(there), len(one.first))
    at = Moments(it.arm, it.move, np.array([t]), np.array([t]))
    boxed = least(it.all_of, at, a, b, np.zeros_like(a), np.zeros((len(a), 3)))
    close = np.flatnonzero(boxed < least_m)
    every = look.met(a[close], b[close], np.full(len(close), t))
    rows = zip(a[close].tolist(), b[close].tolist(), zip(*every, strict=True), strict=True)
    return [(t, i, j, _plainest(it, at, (i, j), Met(*row), least_m)) for i, j, row in rows]


def _plainest(it: Check, at: Moments, pair: tuple[int, int], met: Met, least_m: float) -> Met:
    """Return points of a pair in fewer bytes, by whose direction it is still so far apart."""
    (i, j), one = pair, np.zeros(1, dtype=np.int64)
    for other, _ in variants(met, (it.all_of.shapes[i], it.all_of.shapes[j])):
        spots: list[Array] = []
        for side, solid in enumerate(pair):
            rotation, origin, _ = at.place(it.all_of, one + solid, one)
            spots.append(origin + rotation[0] @ (other.weights @ other.corners[side]))
        if least(it.all_of, at, one + i, one + j, one, spots[1] - spots[0])[0] > least_m:
            return other
    return met


def _between(now: float, later: float) -> float:
    """Return half of the way from one distance to the next, if that is larger."""
    return now + 0.5 * max(later - now, 0.0)
