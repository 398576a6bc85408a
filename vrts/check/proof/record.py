"""The certificate of a run: what was found in it, and what shows that it is so.

Nothing here has to be believed: what comes out is given to the checker before anybody sees it.
Intervals of time are halved until the checker's own bound settles them.
"""

from typing import NamedTuple

import numpy as np

from vrts.check.curves.timeline_arrays import Curves, curves
from vrts.check.proof.certificate import STEPS, rounded
from vrts.check.proof.checker import Check, Moments, check, least
from vrts.check.proof.covered import covered
from vrts.check.proof.given import (
    BOXES,
    DEEPEST,
    DIRECTION,
    EXCUSED,
    Array,
    Claims,
    Evidence,
    Flags,
    Indices,
    Leaves,
    Meeting,
    Points,
    Proven,
    Records,
    Rows,
    Wrong,
)
from vrts.check.proof.look import Look, points_of
from vrts.check.proof.meeting_points import parted
from vrts.check.proof.nearby import near_points
from vrts.check.proof.parting import let_go, near_on_purpose
from vrts.check.proof.tables import rows_of, spans_of, within
from vrts.check.proof.witnesses import nearest_points, witnesses
from vrts.check.verdict import CollisionReport
from vrts.geometry.solids import solids
from vrts.scene.model import Scene

FIRST = 0.3  # [s] length of root intervals
FINEST = 1e-5  # [s] to which they are halved
HOPELESS = 0.03  # [m] solids that can travel farther are not looked at more closely
FRINGE = 1e-3  # [s] round a contact, in which it may begin and end
MOST_OPEN = 50_000  # intervals of rows under way at a time; beyond that nothing is written
BESIDE = 0.1  # [s] so far a contact may reach beyond


class Certified(NamedTuple):
    """A certificate that the checker has accepted."""

    claims: Claims
    evidence: Evidence
    proven: Proven


def certified(scene: Scene, run: Records, report: CollisionReport) -> Certified:
    """Return the certificate of what was found in a run.

    Raises:
        Wrong: It cannot be shown.
    """
    if report.undetermined:
        open_ = report.undetermined[0]
        raise Wrong("the check itself cannot tell", open_.start_s, (open_.first, open_.second))
    if not any(s.end_s > s.start_s for s in run.timeline.segments):
        raise Wrong("the run lasts for no time, so there is nothing to prove")
    move = curves(run.timeline.segments)
    claims = _claims(scene, run, move, report)
    todo = covered(scene, run, (move.start_s, move.end_s), claims)
    edges = _edges(
        move, rows_of(todo, claims), falls=any(s.falls_from_s is not None for s in todo.solids)
    )
    it = Check(scene, run, claims, Evidence(edges, _NO_LEAVES, points_of(0, [])))
    leaves, meetings = _halved(it)
    claims = claims._replace(meetings=meetings)
    look = Look(scene.robot.arm, move, solids(todo.solids))
    shown = [*near_points(look, it), nearest_points(look, todo, report.clearance)]
    shown += [
        witnesses(look, todo, meeting, event.deepest_s)
        for meeting in meetings
        for event in report.contacts
        if (event.first, event.second) == meeting[:2]
        and meeting.from_s <= event.deepest_s <= meeting.to_s
    ]
    points = Points(*(np.concatenate(column) for column in zip(*shown, strict=True)))
    evidence = Evidence(edges, leaves, points)
    return Certified(claims, evidence, check(scene, run, claims, evidence))


def _claims(scene: Scene, run: Records, move: Curves, report: CollisionReport) -> Claims:
    """Return what is claimed."""
    clearance = report.clearance
    floor = None if clearance is None else clearance.distance_m - clearance.tolerance_m
    meetings = tuple(
        Meeting(c.first, c.second, c.start_s - FRINGE, c.end_s + FRINGE) for c in report.contacts
    )
    near_miss = None if floor is None else report.near_miss_m
    claims = Claims(meetings, floor, near_miss, (), ())
    todo = covered(scene, run, (move.start_s, move.end_s), claims)
    look = Look(scene.robot.arm, move, solids(todo.solids))
    go = let_go(look, todo, near_miss)
    near = () if near_miss is None else near_on_purpose(look, todo.stays, near_miss)
    return claims._replace(let_go=go, parted=near)


def _edges(move: Curves, rows: Rows, *, falls: bool) -> Array:
    """Return root intervals: within one rule and one motion each."""
    new_motion = move.starts[1:][np.diff(move.motions) != 0]
    cuts = np.unique(np.concatenate([rows.start_s, rows.end_s, move.jumps(), new_motion]))
    low, high = rows.start_s.min(), rows.end_s.max()
    cuts = cuts[(cuts >= low) & (cuts <= high)]
    start, end = cuts[:-1], cuts[1:]
    still = (move.spread(start, end).speed == 0.0).all(axis=1) & (not falls)
    parts = np.where(still, 1, np.maximum(1, np.ceil((end - start) / FIRST))).astype(np.int64)
    first, which = within(np.zeros_like(parts), parts)
    inner = start[which] + first * ((end - start) / parts)[which]
    return np.append(inner, cuts[-1:])


class _Open(NamedTuple):
    """Intervals of rows that nothing settles yet."""

    row: Indices
    root: Indices
    depth: Indices
    part: Indices

    def only(self, which: Indices | Flags) -> "_Open":
        return _Open(self.row[which], self.root[which], self.depth[which], self.part[which])


_NOTHING = np.empty(0, dtype=np.int64)
_NO_LEAVES = Leaves(_NOTHING, _NOTHING, _NOTHING, _NOTHING, _NOTHING, np.empty((0, 3)))


def _halved(it: Check) -> tuple[Leaves, tuple[Meeting, ...]]:
    """Return leaves for all that boxes do not settle, and contacts with the times they need."""
    edges, rows = it.by.edges, it.rows
    found = list(it.unsettled())
    row, root = (np.concatenate([pair[k] for pair in found] or [_NOTHING]) for k in (0, 1))
    todo = _Open(row, root, np.zeros_like(row), np.zeros_like(row))
    leaves: list[Leaves] = []
    meetings = list(it.claims.meetings)
    while len(todo.row):
        if len(todo.row) > MOST_OPEN:
            raise Wrong("it takes more intervals than a certificate may list")
        blank = np.zeros((len(todo.row), 3))
        x = Leaves(*todo, np.zeros_like(todo.row), blank)
        start_s, end_s = spans_of(x, edges)
        spans, k = np.unique(np.stack([start_s, end_s], axis=1), axis=0, return_inverse=True)
        at, k = Moments(it.arm, it.move, *spans.T), k.ravel()
        kind, normal = _settled(it, at, todo.row, k)
        rigid = it.rigid[todo.row]
        low = np.where(rigid, rows.start_s[todo.row], start_s)
        high = np.where(rigid, rows.end_s[todo.row], end_s)
        over = _excused(it, meetings, todo.row, low, high)
        kind[over & (kind < 0)] = EXCUSED
        stuck = (kind < 0) & ((end_s - start_s <= FINEST) | rigid | (todo.depth >= DEEPEST))
        for r, s, e in zip(todo.row[stuck], low[stuck], high[stuck], strict=True):
            _widen(it, meetings, int(r), float(s), float(e))
        kind[stuck] = EXCUSED
        done = kind >= 0
        if (todo.depth[done] > 0).any() or done.any():
            own = todo.only(done)
            keep = (own.depth > 0) | (kind[done] != BOXES)
            own = own.only(keep)
            leaves.append(Leaves(*own, kind[done][keep], normal[done][keep]))
        rest = todo.only(~done)
        halves = [rest._replace(depth=rest.depth + 1, part=2 * rest.part + h) for h in (0, 1)]
        row, root, depth, part = (np.concatenate(c) for c in zip(*halves, strict=True))
        todo = _Open(row, root, depth, part)
    x = _joined([_NO_LEAVES, *leaves])
    return _picked(x, np.lexsort((x.part << (DEEPEST - x.depth), x.root, x.row))), tuple(meetings)


def _joined(parts: list[Leaves]) -> Leaves:
    return Leaves(
        np.concatenate([leaves.row for leaves in parts]),
        np.concatenate([leaves.root for leaves in parts]),
        np.concatenate([leaves.depth for leaves in parts]),
        np.concatenate([leaves.part for leaves in parts]),
        np.concatenate([leaves.kind for leaves in parts]),
        np.concatenate([leaves.normal for leaves in parts]),
    )


def _picked(x: Leaves, which: Indices) -> Leaves:
    places = x.root[which], x.depth[which], x.part[which]
    return Leaves(x.row[which], *places, x.kind[which], x.normal[which])


def _settled(it: Check, at: Moments, row: Indices, k: Indices) -> tuple[Indices, Array]:
    """Return what settles rows in intervals, -1 for nothing, and the directions that do."""
    a, b, least_m = it.a[row], it.b[row], it.rows.least[row]
    kind, normal = np.full(len(row), -1), np.zeros((len(row), 3))
    kind[least(it.all_of, at, a, b, k, normal) > least_m] = BOXES
    rest = np.flatnonzero(kind < 0)
    if len(rest):
        look = Look(it.arm, it.move, it.all_of)
        pairs, way = look.pairs(at, a[rest], b[rest], k[rest])
        best = parted(it.all_of, pairs, way).normal
        for step in STEPS:
            n = rounded(best, step)
            good = least(it.all_of, at, a[rest], b[rest], k[rest], n) > least_m[rest]
            kind[rest[good]], normal[rest[good]] = DIRECTION, n[good]
            rest, best = rest[~good], best[~good]
    return kind, normal


def _excused(
    it: Check, meetings: list[Meeting], row: Indices, start_s: Array, end_s: Array
) -> Flags:
    """Return which rows lie within a contact of their sides."""
    found = np.zeros(len(row), dtype=np.bool_)
    for m in meetings:
        sides = np.array([d.sides == m[:2] for d in it.todo.demands])
        found |= sides[it.rows.demand[row]] & (start_s >= m.from_s) & (end_s <= m.to_s)
    return found


def _widen(it: Check, meetings: list[Meeting], row: int, start_s: float, end_s: float) -> None:
    """Make the contact longer that a row belongs to.

    Raises:
        Wrong: There is none near.
    """
    sides = it.todo.demands[int(it.rows.demand[row])].sides
    for k, m in enumerate(meetings):
        if m[:2] == sides and m.from_s - BESIDE <= start_s and end_s <= m.to_s + BESIDE:
            meetings[k] = m._replace(from_s=min(m.from_s, start_s), to_s=max(m.to_s, end_s))
            return
    parts = [it.all_of.parts[int(side[row])] for side in (it.a, it.b)]
    raise Wrong("nothing shows that they keep apart", start_s, parts)
