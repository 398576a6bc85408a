"""Stretches of motion that have nothing to do with each other, laid end to end for one search.

Rows of pairs are those of a run: a part of a situation is a body, or two, that are there for the
stretches in which they matter.
"""

from collections.abc import Iterator, Sequence
from typing import NamedTuple, TypeAlias

import numpy as np
import numpy.typing as npt

from vrts.check.collision.pairs.arm_state import Prober
from vrts.check.collision.pairs.cast import Cast, RobotSolids, Stay, robot_solids, stays_of
from vrts.check.collision.pairs.findings import BAND, REPORTED, Touch
from vrts.check.collision.pairs.pair_rows import joined
from vrts.check.collision.pairs.pairs import (
    PADS,
    ROBOT,
    STRICT,
    add_meeting,
    links_against,
    self_pairs,
)
from vrts.check.collision.pairs.table import Pairs, Table
from vrts.check.collision.search.search import BUDGET, search
from vrts.check.curves.timeline_arrays import Curves, curves
from vrts.engine.memory.records import Lie, Placement, Segment
from vrts.engine.motion.polynomials import shifted
from vrts.geometry.proposing.proposer import Proposer
from vrts.geometry.proving.prover import Prover
from vrts.geometry.solids import Solids, solids
from vrts.prove.certify.situation import Lying, Part, What
from vrts.prove.certify.stretches import Stretch
from vrts.prove.certify.touching import Hope
from vrts.robots.model import flange_in_hand
from vrts.scene.model import Mobility, Scene

Array: TypeAlias = npt.NDArray[np.float64]

MOTION_S = 100.0  # for so long a motion there is the budget of a run


class Entry(NamedTuple):
    """A stretch of motion that is new, for some parts of its situation."""

    stretch: Stretch
    parts: tuple[Part, ...]
    future: int


class Hit(NamedTuple):
    """Something touches in an entry."""

    entry: int
    part: Part | None  # of the entry, if it may be excused later
    s: float  # first seen touching, in `s` of its stretch
    from_s: float  # it touches between these two, in `s`, but for their last millisecond
    to_s: float
    group: tuple[str, ...]  # the two names; and the hope, whose it is, and the number of the part
    parts: tuple[str, str]
    distance: float  # signed [m]
    certain: bool


class _Laid(NamedTuple):
    """Entries end to end."""

    entries: Sequence[Entry]
    order: list[int]  # of the entries
    starts: Array  # [s] of each, in that order
    segments: list[Segment]
    runs: dict[Part, list[tuple[float, float]]]  # when each part matters


def touches(
    scene: Scene, entries: Sequence[Entry], proposer: Proposer, pads: float
) -> tuple[list[Hit], Curves, list[int]]:
    """Return what touches in entries.

    Args:
        scene: What stands where.
        entries: Stretches; something falls in all of them, or in none.
        proposer: Helps to prove distances.
        pads: How far a pad may press into what it grasps [m].

    Returns:
        Hits in no order; the motion laid end to end, and which entry each piece is.
    """
    laid = _laid(entries)
    motion = curves(laid.segments)
    cast = Cast(-np.inf, np.inf, flange_in_hand(scene.robot.arm))
    table = Table()
    rows = _Rows(scene, cast, table, pads)
    rows.add(laid)
    arrays = solids(cast.members)
    moving, rigid = _unconcerned(table.pairs(rigid=False)), _unconcerned(table.pairs(rigid=True))
    interval = (motion.start_s, motion.end_s)
    found = search(
        *(scene.robot.arm, motion, arrays, moving, interval, proposer),
        clearance=False,
        begins=laid.starts[1:],
        budget=int(BUDGET * max(1.0, (interval[1] - interval[0]) / MOTION_S)),
    )
    contacts, doubts = list(found.contacts), list(found.open)
    prober = Prober(scene.robot.arm, motion, arrays, Prover(arrays, proposer))
    _look_once(prober, rigid, len(moving.first), contacts, doubts)
    told = _Told(laid, joined(moving, rigid), tuple(table.groups), rows.hoping, arrays)
    hits = [*told.hits(contacts, certain=True), *told.hits(doubts, certain=False)]
    return hits, motion, laid.order


def _laid(entries: Sequence[Entry]) -> _Laid:
    """Lay entries end to end, those with the same parts side by side."""
    kinds: dict[tuple[Part, ...], list[int]] = {}
    for k, entry in enumerate(entries):
        kinds.setdefault(entry.parts, []).append(k)
    order = [k for own in kinds.values() for k in own]
    starts: list[float] = []
    segments: list[Segment] = []
    runs: dict[Part, list[tuple[float, float]]] = {}
    at = 0.0
    for place, k in enumerate(order):
        stretch, parts, _ = entries[k]
        end = at + (stretch.to_s - stretch.from_s)
        rows = tuple([shifted(row, stretch.from_s) for row in (*stretch.rows, stretch.opening)])
        segments.append(Segment(at, end, rows, place))
        starts.append(at)
        for part in parts:
            own = runs.setdefault(part if not part.falls else _falling(part, at, stretch), [])
            if own and own[-1][1] == at:
                own[-1] = (own[-1][0], end)
            else:
                own.append((at, end))
        at = end
    return _Laid(entries, order, np.array(starts), segments, runs)


def _falling(part: Part, at: float, stretch: Stretch) -> Part:
    """Return a part whose fall begins when it does in the time of what is laid end to end."""

    def then(one: Lying | None) -> Lying | None:
        if one is None or one.lie is not Lie.FALLING:
            return one
        return one._replace(falls_from_s=at + (one.falls_from_s - stretch.from_s))

    return part._replace(body=then(part.body), other=then(part.other))


def _unconcerned(pairs: Pairs) -> Pairs:
    """Return pairs of which only contacts are wanted."""
    no = np.zeros(len(pairs.first), dtype=np.bool_)
    return pairs._replace(grazes=no, counts=no)


class _Rows:
    """Makes the rows of parts."""

    def __init__(self, scene: Scene, cast: Cast, table: Table, pads: float) -> None:
        self.scene, self.cast, self.table = scene, cast, table
        self.arm: RobotSolids = robot_solids(cast, scene.robot)
        self.pressing = PADS._replace(tolerance=pads)
        self.none = (False,) * len(self.arm.fingers)
        self.hoping: list[Part] = []  # parts of which touches may be excused later
        self.stays: dict[tuple[Lying, bool], Stay] = {}
        self.fixed = [
            Lying(body.name, Lie.RESTING, body.X_WO)
            for body in scene.bodies
            if body.mobility is not Mobility.MOVABLE
        ]

    def add(self, laid: _Laid) -> None:
        """Add the rows of all parts."""
        for part, runs in laid.runs.items():
            if part.hopes:
                self.hoping.append(part)
            for run in runs:
                self._add(part, run)

    def _add(self, part: Part, run: tuple[float, float]) -> None:
        body, other = part.body, part.other
        if part.what is What.ITSELF:
            self_pairs(self.table, self.scene.robot, self.arm, run)
            for one in self.fixed:
                self._touched(one, self.none, run, closing=False)
            return
        assert body is not None
        if part.what is What.TOUCHED:
            self._touched(body, part.pads, run, closing=part.closing)
        elif part.what is What.IN_HAND:
            self._pressed(self._stay(body, run), body, part.pads, closing=False)
        elif part.what is What.FIXED:
            for one in self.fixed:
                self._meeting(body, one, run)
        elif other is not None:
            self._meeting(body, other, run)

    def _touched(
        self, body: Lying, pads: Sequence[bool], run: tuple[float, float], *, closing: bool
    ) -> None:
        stay = self._stay(body, run)
        links_against(self.table, self.arm, stay)
        if pads:
            self._pressed(stay, body, pads, closing=closing)

    def _pressed(self, stay: Stay, body: Lying, pads: Sequence[bool], *, closing: bool) -> None:
        """Add the fingers, which may press into a body or not."""
        names, run = (ROBOT, body.body), (stay.start_s, stay.end_s)
        for finger, allowed in zip(self.arm.fingers, pads, strict=True):
            if allowed or closing:
                self.table.add(names, finger, stay.members, run, self.pressing)
            if not allowed:
                own = self._hoped(names, Hope.GRASPED, body) if closing else names
                self.table.add(own, finger, stay.members, run, STRICT)

    def _meeting(self, body: Lying, other: Lying, run: tuple[float, float]) -> None:
        parts = other.body in (body.before, body.after)
        stay, its = self._stay(body, run), self._stay(other, run, lowered=parts)
        held = body.lie is Lie.HELD and not parts
        own = self._hoped((ROBOT, other.body), Hope.SET_DOWN, body) if held else ()
        add_meeting(self.table, stay, its, run, (run[1], run[1]), own)

    def _hoped(self, names: tuple[str, str], hope: Hope, whose: Lying) -> tuple[str, ...]:
        """Return the group of touches that may be excused later."""
        return (*names, hope.value, whose.body, str(len(self.hoping) - 1))

    def _stay(self, one: Lying, run: tuple[float, float], *, lowered: bool = False) -> Stay:
        """Return a body for some time, each with solids of its own."""
        known = self.stays.get((one, lowered))
        if known is None:
            name = one.body
            placement = Placement(name, one.falls_from_s, np.inf, one.lie, one.X, None)
            supports = frozenset((name,)) if lowered else frozenset[str]()
            (known,) = stays_of(self.cast, self.scene.body(name), (placement,), supports)
            known = known._replace(before=one.before, after=one.after)
            self.stays[one, lowered] = known
        return known._replace(start_s=run[0], end_s=run[1])


def _look_once(
    prober: Prober, rigid: Pairs, offset: int, contacts: list[Touch], doubts: list[Touch]
) -> None:
    """Add what pairs that do not move one against the other have to say."""
    if not len(rigid.first):
        return
    bounds = prober.told(rigid.first, rigid.second, rigid.start_s)
    rows = zip(bounds.lower.tolist(), bounds.upper.tolist(), strict=True)
    for k, (lower, upper) in enumerate(rows):
        start_s, tolerance = float(rigid.start_s[k]), float(rigid.tolerance[k])
        touch = Touch(offset + k, start_s, start_s, start_s, upper, lower)
        if upper < -tolerance - BAND:
            contacts.append(touch)
        elif lower < BAND - tolerance:
            doubts.append(touch)


class _Told(NamedTuple):
    """Tells what touches by entry and group."""

    laid: _Laid
    pairs: Pairs
    groups: Sequence[tuple[str, ...]]
    hoping: Sequence[Part]
    arrays: Solids

    def hits(self, touches: Sequence[Touch], *, certain: bool) -> Iterator[Hit]:
        """Yield one hit for all touches of a group in an entry."""
        found: dict[tuple[int, int], list[Touch]] = {}
        for touch in touches:
            place = int(np.searchsorted(self.laid.starts, touch.time_s, side="right")) - 1
            key = max(place, 0), int(self.pairs.group[touch.pair])
            found.setdefault(key, []).append(touch)
        for (place, number), own in found.items():
            entry, group = self.laid.order[place], self.groups[number]
            first = min(own, key=_begins)
            by = self.laid.entries[entry].stretch.from_s - float(self.laid.starts[place])
            low = min(touch.start_s for touch in own) - REPORTED
            high = max(touch.end_s for touch in own) + REPORTED
            solids = int(self.pairs.first[first.pair]), int(self.pairs.second[first.pair])
            parts = self.arrays.parts[solids[0]], self.arrays.parts[solids[1]]
            part = self.hoping[int(group[-1])] if len(group) > len(parts) else None
            times = first.time_s + by, low + by, high + by
            yield Hit(entry, part, *times, group, parts, first.distance, certain)


def _begins(touch: Touch) -> tuple[float, int]:
    return touch.time_s, touch.pair
