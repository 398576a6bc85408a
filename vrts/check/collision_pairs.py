"""What is tested against what, when, and by which rule.

Time is cut where an object is grasped, released or lands, and where a pair changes its rule. Two
convex pieces with an interval of time and a rule are one row of `Pairs`; the search takes all rows
at once, whatever their intervals.
"""

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, field
from typing import NamedTuple, TypeAlias

import numpy as np
import numpy.typing as npt

from vrts.base.pose import Pose, Vector, rotate, translation
from vrts.check.collision_grips import (
    NEAR_MISS,
    counted_from,
    counted_until,
    finger_windows,
    grips,
)
from vrts.check.collision_state import Prober, RunRecord
from vrts.check.curves import Curves
from vrts.engine.records import Lie, Placement
from vrts.geometry.narrow import engine
from vrts.geometry.nearest import Engine
from vrts.geometry.shapes import Piece
from vrts.geometry.solids import Solid, Solids, solids
from vrts.robots.model import Robot
from vrts.scene.model import Body, Mobility, Scene

Array: TypeAlias = npt.NDArray[np.float64]
Flags: TypeAlias = npt.NDArray[np.bool_]
Indices: TypeAlias = npt.NDArray[np.int64]

ROBOT = "robot"  # with gripper and held object, as one
TOLERANCE = 2e-4  # [m] deeper than this is a contact, less is a graze
PALM = "palm"  # the gripper without its fingers
PAD_DEPTH = 1e-3  # [m] a pad may press this far into a grasped object
SUPPORT_LOWERED = 1e-3  # [m] a support is tested this much lower against what stands on it
HAND = 6  # frame of flange and gripper
LOWERED = translation(0.0, 0.0, -SUPPORT_LOWERED)


class Rule(NamedTuple):
    """How a pair is judged."""

    tolerance: float  # a contact is deeper than this [m]; inf: no contact is looked for
    grazes: bool  # shallower touches are listed
    counts: bool  # enters minimum clearance


_Row: TypeAlias = tuple[int, int, float, float, float, bool, bool, int]

STRICT = Rule(TOLERANCE, grazes=True, counts=True)
ITSELF = Rule(TOLERANCE, grazes=True, counts=False)  # the arm's own shape is no near miss
NEAR = Rule(TOLERANCE, grazes=True, counts=False)
PADS = Rule(PAD_DEPTH, grazes=False, counts=False)
DISTANCE = Rule(np.inf, grazes=False, counts=True)


class Pairs(NamedTuple):
    """Rows of (solid, solid, interval, rule); arrays of shape (p,)."""

    first: Indices  # of the solids
    second: Indices
    start_s: Array
    end_s: Array
    tolerance: Array  # [m]
    grazes: Flags
    counts: Flags
    group: Indices  # of `Plan.groups`


class Plan(NamedTuple):
    """All that a search needs to know."""

    solids: Solids
    pairs: Pairs
    rigid: Pairs  # rows that do not move one against the other: looked at once
    groups: tuple[tuple[str, str], ...]  # names of the two sides of a contact event


class Stay(NamedTuple):
    """A body where one placement has it."""

    body: str
    start_s: float
    end_s: float
    lie: Lie
    before: str | None  # what it stood on before
    after: str | None  # what it will stand on after
    members: tuple[int, ...]  # solids
    lowered: tuple[int, ...]  # the same, lowered by 1 mm; of what can be a support

    @property
    def still(self) -> bool:
        """Whether it does not move."""
        return self.lie in (Lie.RESTING, Lie.TOPPLED)


def plan(
    scene: Scene,
    run: RunRecord,
    curves: Curves,
    by: Engine | None = None,
    near_miss: float = NEAR_MISS,
) -> Plan:
    """Return every pair of pieces that can touch while the run lasts, with its rules.

    `by` measures the distances that rules depend on; None: the most exact engine there is. Nearer
    than `near_miss` [m] is a near miss.
    """
    placements = {body.name: _placements(body, run) for body in scene.bodies}
    ends = [p.end_s for own in placements.values() for p in own if np.isfinite(p.end_s)]
    interval = (curves.start_s, max([curves.end_s, *ends]))
    supports = frozenset(
        name
        for body in scene.bodies
        for name in (body.rests_on, *(p.support for p in placements[body.name]))
        if name is not None
    )
    cast = _Cast(*interval, scene.robot.arm.X_LF)
    arm = _arm(cast, scene.robot)
    stays = [
        stay
        for body in scene.bodies
        for stay in _stays(cast, body, placements[body.name], supports)
    ]
    arrays = solids(cast.members)
    prober = Prober(scene.robot.arm, curves, arrays, engine() if by is None else by)
    table = _Table()
    _self_pairs(table, scene.robot, arm, interval)
    _arm_pairs(table, arm, stays, run, prober, near_miss)
    _body_pairs(table, stays, prober, near_miss)
    return Plan(arrays, table.pairs(rigid=False), table.pairs(rigid=True), tuple(table.groups))


class _Arm(NamedTuple):
    """Solids of the robot."""

    links: tuple[tuple[str, int, tuple[int, ...]], ...]  # name, joint, solids
    palm: tuple[int, ...]
    fingers: tuple[tuple[int, ...], ...]


@dataclass(slots=True)
class _Cast:
    """Collects solids."""

    start_s: float
    end_s: float
    X_LF: Pose  # the flange in L_6
    members: list[Solid] = field(default_factory=list[Solid])

    def add(
        self,
        pieces: Iterable[Piece],
        frame: int,
        X_LO: Pose,
        part: str,
        slide: Vector = (0.0, 0.0, 0.0),
        falls_from_s: float | None = None,
    ) -> tuple[int, ...]:
        """Add the pieces of a body and return their indices."""
        first = len(self.members)
        self.members += [
            Solid(piece.shape, frame, X_LO @ piece.X_OP, part, slide, falls_from_s)
            for piece in pieces
        ]
        return tuple(range(first, len(self.members)))


@dataclass(slots=True)
class _Table:
    """Collects pairs."""

    groups: dict[tuple[str, str], int] = field(default_factory=dict[tuple[str, str], int])
    rows: list[_Row] = field(default_factory=list[_Row])
    rigid_rows: list[_Row] = field(default_factory=list[_Row])

    def add(
        self,
        group: tuple[str, str],
        first: Iterable[int],
        second: Sequence[int],
        interval: tuple[float, float],
        rule: Rule,
        *,
        rigid: bool = False,
    ) -> None:
        """Add every pair of two unions of solids."""
        start_s, end_s = interval
        if end_s <= start_s:
            return
        number = self.groups.setdefault(group, len(self.groups))
        rows = self.rigid_rows if rigid else self.rows
        rows += [(i, j, start_s, end_s, *rule, number) for i in first for j in second]

    def pairs(self, *, rigid: bool) -> Pairs:
        """Return the rows as arrays."""
        rows = self.rigid_rows if rigid else self.rows
        columns = list(zip(*rows, strict=True)) if rows else [()] * 8
        return Pairs(
            np.array(columns[0], dtype=np.int64),
            np.array(columns[1], dtype=np.int64),
            np.array(columns[2], dtype=np.float64),
            np.array(columns[3], dtype=np.float64),
            np.array(columns[4], dtype=np.float64),
            np.array(columns[5], dtype=np.bool_),
            np.array(columns[6], dtype=np.bool_),
            np.array(columns[7], dtype=np.int64),
        )


def _arm(cast: _Cast, robot: Robot) -> _Arm:
    links = tuple(
        (link.name, link.joint, cast.add(link.pieces, link.joint, translation(0, 0, 0), link.name))
        for link in robot.arm.links
    )
    palm = cast.add(robot.gripper.body, HAND, cast.X_LF, PALM)
    fingers = tuple(
        cast.add(
            finger.pieces,
            HAND,
            cast.X_LF,
            finger.name,
            rotate(cast.X_LF.rotation, (0.0, 0.5 * finger.side, 0.0)),
        )
        for finger in robot.gripper.fingers
    )
    return _Arm(links, palm, fingers)


def _stays(
    cast: _Cast, body: Body, placements: Sequence[Placement], supports: frozenset[str]
) -> list[Stay]:
    """Return where a body is over time, each time with solids of its own."""
    found: list[Stay] = []
    for number, placement in enumerate(placements):
        start_s = max(placement.start_s, cast.start_s)
        end_s = min(placement.end_s, cast.end_s)
        if end_s <= start_s:
            continue
        held = placement.lie is Lie.HELD
        falling = placement.lie is Lie.FALLING
        X_LO = cast.X_LF @ placement.X if held else placement.X
        members = cast.add(
            body.pieces,
            HAND if held else 0,
            X_LO,
            body.name,
            falls_from_s=placement.start_s if falling else None,
        )
        lowered: tuple[int, ...] = ()
        if body.name in supports and not held and not falling:
            lowered = cast.add(body.pieces, 0, LOWERED @ X_LO, body.name)
        before = body.rests_on if number == 0 else placements[number - 1].support
        after = next(
            (p.support for p in placements[number + 1 :] if p.lie is not Lie.FALLING), None
        )
        found.append(
            Stay(body.name, start_s, end_s, placement.lie, before, after, members, lowered)
        )
    return found


def _placements(body: Body, run: RunRecord) -> Sequence[Placement]:
    known = run.placements.get(body.name, ()) if body.mobility is Mobility.MOVABLE else ()
    return known or (Placement(body.name, -np.inf, np.inf, Lie.RESTING, body.X_WO, None),)


def _self_pairs(table: _Table, robot: Robot, arm: _Arm, interval: tuple[float, float]) -> None:
    """The arm against itself: all but neighbours and what cannot meet by construction."""
    group = (ROBOT, ROBOT)
    for name, joint, members in arm.links:
        for other, beyond, others in arm.links:
            if beyond <= joint + 1 or frozenset((name, other)) in robot.arm.skipped_pairs:
                continue
            table.add(group, others, members, interval, ITSELF)
        if joint < HAND - 1:
            table.add(group, arm.palm, members, interval, ITSELF)
            for finger in arm.fingers:
                table.add(group, finger, members, interval, ITSELF)


def _arm_pairs(
    table: _Table,
    arm: _Arm,
    stays: Sequence[Stay],
    run: RunRecord,
    prober: Prober,
    near_miss: float,
) -> None:
    """The arm against every body, wherever the body is."""
    moving = [i for _, joint, members in arm.links if 0 < joint < HAND for i in members]
    flange = [i for _, joint, members in arm.links if joint == HAND for i in members]
    base = [i for _, joint, members in arm.links if joint == 0 for i in members]
    by_body: dict[str, list[Stay]] = {}
    for stay in stays:
        by_body.setdefault(stay.body, []).append(stay)
    held = grips(run.events)
    for body, own in by_body.items():
        group = (ROBOT, body)
        for stay in own:
            interval = (stay.start_s, stay.end_s)
            with_hand = stay.lie is Lie.HELD
            table.add(group, moving, stay.members, interval, STRICT)
            table.add(group, [*flange, *arm.palm], stay.members, interval, STRICT, rigid=with_hand)
            if not stay.still:
                table.add(group, base, stay.members, interval, STRICT)
        on_this = [grip for grip in held if grip.body == body]
        for finger in arm.fingers:
            gap = _gap(prober, finger, own)
            span = own[0].start_s, own[-1].end_s
            for window in finger_windows(on_this, gap, *span, near_miss):
                rule = PADS if window.allowed else STRICT if window.counts else NEAR
                for stay in own:
                    interval = _common((window.start_s, window.end_s), (stay.start_s, stay.end_s))
                    table.add(group, finger, stay.members, interval, rule)


def _body_pairs(table: _Table, stays: Sequence[Stay], prober: Prober, near_miss: float) -> None:
    """Held and falling bodies against all others."""
    for stay in stays:
        if stay.still:
            continue
        for other in stays:
            interval = _common((stay.start_s, stay.end_s), (other.start_s, other.end_s))
            if other.body == stay.body or interval[1] <= interval[0]:
                continue
            if other.still:
                _moving_against_still(table, stay, other, interval, prober, near_miss)
            elif stay.lie is Lie.FALLING and other.lie is Lie.HELD:
                # from the hand, or met by what the hand carries
                rule = NEAR if stay.before == other.body else STRICT
                table.add((ROBOT, stay.body), other.members, stay.members, interval, rule)


def _moving_against_still(
    table: _Table,
    stay: Stay,
    other: Stay,
    interval: tuple[float, float],
    prober: Prober,
    near_miss: float,
) -> None:
    group = (ROBOT if stay.lie is Lie.HELD else stay.body, other.body)
    if other.body not in (stay.before, stay.after):
        table.add(group, stay.members, other.members, interval, STRICT)
        return
    start_s, end_s = interval
    counts_s, ceases_s = start_s, end_s
    if stay.lie is Lie.HELD:

        def gap(times: Array) -> Array:
            return prober.gap(stay.members, other.members, times)

        if other.body == stay.before:
            counts_s = counted_from(gap, start_s, end_s, near_miss)
        if other.body == stay.after:
            ceases_s = counted_until(gap, start_s, end_s, near_miss)
    else:
        counts_s = end_s
    counts_s = min(counts_s, end_s)
    ceases_s = max(ceases_s, counts_s)
    table.add(group, stay.members, other.lowered, interval, NEAR)
    table.add(group, stay.members, other.members, (counts_s, ceases_s), DISTANCE)


def _gap(prober: Prober, finger: Sequence[int], stays: Sequence[Stay]) -> Callable[[Array], Array]:
    """Return the distance of a finger from a body at times, wherever the body is."""

    def gap(times: Array) -> Array:
        found = np.full(len(times), np.inf)
        for stay in stays:
            now = (times >= stay.start_s) & (times <= stay.end_s)
            if now.any():
                distances = prober.gap(finger, stay.members, times[now])
                found[now] = np.minimum(found[now], distances)
        return found

    return gap


def _common(a: tuple[float, float], b: tuple[float, float]) -> tuple[float, float]:
    return max(a[0], b[0]), min(a[1], b[1])
