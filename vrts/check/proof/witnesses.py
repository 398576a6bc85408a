"""Points that show contacts, and that something comes as near as the smallest distance."""

import numpy as np

from vrts.check.proof.checker import EVENT_GAP, ROUNDING, Moments
from vrts.check.proof.given import NEAREST, WITNESS, Array, Covered, Demand, Meeting, Points, Wrong
from vrts.check.proof.look import Look, points_of
from vrts.check.proof.meeting_points import Met, meet
from vrts.check.proof.tables import depth
from vrts.check.verdict import Clearance

EVERY = 0.05  # [s] between instants at which a contact is looked at
WITHIN = 0.9 * EVENT_GAP  # [s] from one witness to the next
DEEPEST = 4  # pairs of solids tried at an instant
FLAT = (3.2, 6.0, 12.0, 30.0)  # how wide a tetrahedron is, as shares of its height
HIGH = (0.98, 0.7, 0.5, 0.2)  # of what is deeper than the tolerance, how much is used


def nearest_points(look: Look, todo: Covered, clearance: Clearance | None) -> Points:
    """Return the two points between which the smallest distance is measured."""
    if clearance is None:
        return points_of(NEAREST, [])
    sides = [(d.first, d.second, (d.start_s, d.end_s)) for d in todo.demands if d.counts]
    seen = look.nearest(np.array([clearance.time_s]), sides)[0]
    if seen is None:
        raise Wrong("nothing is there at the time of the smallest distance", clearance.time_s)
    return points_of(NEAREST, [(clearance.time_s, seen.first, seen.second, seen.met)])


def witnesses(look: Look, todo: Covered, meeting: Meeting, deepest_s: float) -> Points:
    """Return points that show a contact at times less than 0.5 s apart.

    Raises:
        Wrong: It cannot be shown.
    """
    demands = [d for d in todo.demands if d.sides == meeting[:2] and np.isfinite(d.tolerance)]
    start_s, end_s = meeting.from_s, meeting.to_s
    count = int(np.ceil((end_s - start_s) / EVERY)) + 2
    times = np.unique([*np.linspace(start_s, end_s, count), deepest_s])
    shown: dict[float, list[tuple[float, int, int, Met]] | None] = {}

    def at(k: int) -> bool:
        time_s = float(times[k])
        if time_s not in shown:
            shown[time_s] = _witness(look, demands, time_s)
        return shown[time_s] is not None

    chosen: list[int] = []
    last_s, k = start_s, -1
    while last_s + WITHIN < end_s or not chosen:
        reach = [j for j in range(k + 1, len(times)) if times[j] <= last_s + WITHIN]
        k = next((j for j in reversed(reach) if at(j)), -1)
        if k < 0:
            raise Wrong("nothing shows the contact", last_s, meeting[:2])
        chosen.append(k)
        last_s = float(times[k])
    for ends in (range(chosen[0]), range(len(times) - 1, chosen[-1], -1)):  # as early as can be
        more = next((j for j in ends if at(j)), None)
        if more is not None:
            chosen.append(more)
    rows = [row for j in sorted(chosen) for row in shown[float(times[j])] or ()]
    return points_of(WITNESS, rows)


def _witness(
    look: Look, demands: list[Demand], time_s: float
) -> list[tuple[float, int, int, Met]] | None:
    """Return four pairs of points that show a contact at an instant; None where there are none."""
    rows = [
        (i, j, d.tolerance)
        for d in demands
        if d.start_s <= time_s <= d.end_s
        for i in d.first
        for j in d.second
    ]
    if not rows:
        return None
    a, b = (np.array([row[k] for row in rows]) for k in (0, 1))
    tolerance = np.array([row[2] for row in rows])
    met = look.met(a, b, np.full(len(a), time_s))
    beyond = -met.gap - tolerance
    for k in np.argsort(-beyond, kind="stable")[:DEEPEST].tolist():
        if beyond[k] <= ROUNDING:
            return None
        i, j = int(a[k]), int(b[k])
        deep, enough = -float(met.gap[k]), float(tolerance[k])
        found = _four(look, (i, j), time_s, met.normal[k], deep, enough)
        if found is not None:
            return [(time_s, i, j, one) for one in found]
    return None


def _four(
    look: Look, pair: tuple[int, int], time_s: float, n: Array, deep: float, tolerance: float
) -> list[Met] | None:
    """Return four pairs of points whose differences hold a ball of the tolerance."""
    u = np.cross(n, np.eye(3)[np.abs(n).argmin()])
    u /= np.linalg.norm(u)
    v = np.cross(n, u)
    at = Moments(look.arm, look.move, np.full(4, time_s), np.full(4, time_s))
    pairs, _ = look.pairs(at, np.full(4, pair[0]), np.full(4, pair[1]), np.arange(4))
    for high in HIGH:
        for flat in FLAT:
            height = tolerance + high * (deep - tolerance)
            turn = 2 * np.pi / 3 * np.arange(3)
            ring: Array = np.outer(np.cos(turn), u) + np.outer(np.sin(turn), v)
            shift: Array = height * np.concatenate([n + flat * ring, -3.2 * n[None]])
            met = meet(look.all_of, pairs._replace(origin_b=pairs.origin_b + shift), -shift)
            inside = np.einsum("pk,pski->psi", met.weights, met.corners)
            across = pairs.origin_a + (pairs.rotation_a @ inside[:, 0, :, None])[:, :, 0]
            across -= pairs.origin_b + (pairs.rotation_b @ inside[:, 1, :, None])[:, :, 0]
            if depth(across) > tolerance + ROUNDING:
                return [Met(*(column[k] for column in met)) for k in range(4)]
    return None
