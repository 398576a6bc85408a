"""What is tested against what, when, and by which rule.

Time is cut where an object is grasped, released or lands, and where a pair changes its rule. Two
convex pieces with an interval of time and a rule are one row of `Pairs`; the search takes all rows
at once, whatever their intervals.
"""

from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Generic, NamedTuple, TypeAlias, TypeVar

import numpy as np
import numpy.typing as npt

from vrts.check.collision.pairs.arm_state import Asked, Prober, RunRecord
from vrts.check.collision.pairs.asking import both_told
from vrts.check.collision.pairs.cast import (
    HAND,
    Cast,
    RobotSolids,
    Stay,
    placements_of,
    robot_solids,
    stays_of,
)
from vrts.check.collision.pairs.grips import (
    AWAY,
    NEAR_MISS,
    Asking,
    Gap,
    Grip,
    Look,
    Window,
    counted_from,
    counted_until,
    finger_windows,
    grips,
)
from vrts.check.collision.pairs.table import Pairs, Rule, Table
from vrts.check.curves.timeline_arrays import Curves
from vrts.engine.memory.records import Lie
from vrts.geometry.proposing.choose import here
from vrts.geometry.proposing.proposer import Proposer
from vrts.geometry.proving.prover import Prover
from vrts.geometry.solids import Solids, solids
from vrts.robots.model import Robot, flange_in_hand
from vrts.scene.model import Scene

Array: TypeAlias = npt.NDArray[np.float64]
Flags: TypeAlias = npt.NDArray[np.bool_]
Indices: TypeAlias = npt.NDArray[np.int64]

ROBOT = "robot"  # with gripper and held object, as one
TOLERANCE = 2e-4  # [m] deeper than this is a contact, less is a graze
FAR = AWAY + 1e-3  # [m] beyond this no rule asks how far
PAD_DEPTH = 1e-3  # [m] a pad may press this far into a grasped object

STRICT = Rule(TOLERANCE, grazes=True, counts=True)
ITSELF = Rule(TOLERANCE, grazes=True, counts=False)  # the arm's own shape is no near miss
NEAR = Rule(TOLERANCE, grazes=True, counts=False)
PADS = Rule(PAD_DEPTH, grazes=False, counts=False)
DISTANCE = Rule(np.inf, grazes=False, counts=True)


class Plan(NamedTuple):
    """All that a search needs to know."""

    solids: Solids
    pairs: Pairs
    rigid: Pairs  # rows that do not move one against the other: looked at once
    groups: tuple[tuple[str, str], ...]  # names of the two sides of a contact event


_Meeting: TypeAlias = tuple[Stay, Stay, tuple[float, float]]  # of bodies, from when to when
_Stays: TypeAlias = Sequence[tuple[Sequence[int], float, float]]  # solids, from when to when
T = TypeVar("T")


class _Question(NamedTuple, Generic[T]):
    """A question that asks for distances, and between which solids."""

    asking: Asking[T]
    first: Sequence[int]
    stays: _Stays

    @property
    def sides(self) -> tuple[Sequence[int], _Stays]:
        return self.first, self.stays


def plan(
    scene: Scene,
    run: RunRecord,
    curves: Curves,
    proposer: Proposer | None = None,
    near_miss: float = NEAR_MISS,
    *,
    clearance: bool = True,
    pads: float = PAD_DEPTH,
) -> Plan:
    """Return every pair of pieces that can touch while the run lasts, with its rules.

    Args:
        scene: What stands where.
        run: What happens.
        curves: How the robot moves.
        proposer: Helps to measure distances that rules depend on; None: the best there is here.
        near_miss: Nearer than this is a near miss [m].
        clearance: Whether pairs that matter to the smallest distance only are wanted.
        pads: How far a pad may press into what it grasps [m].
    """
    placements = {body.name: placements_of(body, run) for body in scene.bodies}
    ends = [p.end_s for own in placements.values() for p in own if np.isfinite(p.end_s)]
    interval = (curves.start_s, max([curves.end_s, *ends]))
    supports = frozenset(
        name
        for body in scene.bodies
        for name in (body.rests_on, *(p.support for p in placements[body.name]))
        if name is not None
    )
    cast = Cast(*interval, flange_in_hand(scene.robot.arm))
    arm = robot_solids(cast, scene.robot)
    stays = [
        stay
        for body in scene.bodies
        for stay in stays_of(cast, body, placements[body.name], supports)
    ]
    arrays = solids(cast.members)
    prover = Prover(arrays, here() if proposer is None else proposer)
    prober = Prober(scene.robot.arm, curves, arrays, prover)
    table = Table()
    self_pairs(table, scene.robot, arm, interval)
    counted = near_miss if clearance else None
    by_body = _by_body(stays)
    fingers = _finger_questions(arm, by_body, grips(run.events), counted)
    meetings = _meetings(stays)
    bodies = _parted_questions(meetings, counted)
    windows, times = _told(prober, fingers, bodies)
    _arm_pairs(table, arm, by_body, iter(windows), PADS._replace(tolerance=pads))
    _body_pairs(table, meetings, iter(times), counted)
    groups = tuple((first, second) for first, second in table.groups)
    return Plan(arrays, table.pairs(rigid=False), table.pairs(rigid=True), groups)


def self_pairs(table: Table, robot: Robot, arm: RobotSolids, interval: tuple[float, float]) -> None:
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


def _by_body(stays: Sequence[Stay]) -> Mapping[str, Sequence[Stay]]:
    found: dict[str, list[Stay]] = {}
    for stay in stays:
        found.setdefault(stay.body, []).append(stay)
    return found


def _arm_pairs(
    table: Table,
    arm: RobotSolids,
    by_body: Mapping[str, Sequence[Stay]],
    windows: Iterator[tuple[Window, ...]],
    gripping: Rule,
) -> None:
    """The arm against every body, wherever the body is."""
    for body, own in by_body.items():
        for stay in own:
            links_against(table, arm, stay)
        for finger in arm.fingers:
            for window in next(windows):
                rule = gripping if window.allowed else STRICT if window.counts else NEAR
                for stay in own:
                    interval = _common((window.start_s, window.end_s), (stay.start_s, stay.end_s))
                    table.add((ROBOT, body), finger, stay.members, interval, rule)


def links_against(table: Table, arm: RobotSolids, stay: Stay) -> None:
    """The arm without its fingers against a body, where one placement has it."""
    moving = [i for _, joint, members in arm.links if 0 < joint < HAND for i in members]
    flange = [i for _, joint, members in arm.links if joint == HAND for i in members]
    base = [i for _, joint, members in arm.links if joint == 0 for i in members]
    group, interval = (ROBOT, stay.body), (stay.start_s, stay.end_s)
    with_hand = stay.lie is Lie.HELD
    table.add(group, moving, stay.members, interval, STRICT)
    table.add(group, [*flange, *arm.palm], stay.members, interval, STRICT, rigid=with_hand)
    if not stay.still:
        table.add(group, base, stay.members, interval, STRICT)


def _finger_questions(
    arm: RobotSolids,
    by_body: Mapping[str, Sequence[Stay]],
    held: Sequence[Grip],
    near_miss: float | None,
) -> list[_Question[tuple[Window, ...]]]:
    """Return what asks for the rules of every finger with every body, finger by finger for each."""
    found: list[_Question[tuple[Window, ...]]] = []
    for body, own in by_body.items():
        mine = [grip for grip in held if grip.body == body]
        stays = [(stay.members, stay.start_s, stay.end_s) for stay in own]
        for finger in arm.fingers:
            asking = finger_windows(mine, own[0].start_s, own[-1].end_s, near_miss)
            found.append(_Question(asking, finger, stays))
    return found


def _told(
    prober: Prober,
    fingers: Sequence[_Question[tuple[Window, ...]]],
    bodies: Sequence[_Question[float]],
) -> tuple[list[tuple[Window, ...]], list[float]]:
    """Return what questions of both kinds come to."""
    sides = [*(one.sides for one in fingers), *(one.sides for one in bodies)]

    def asked(number: int, times: Array) -> Asked:
        return Asked(*sides[number], times)

    return both_told(
        [one.asking for one in fingers],
        [one.asking for one in bodies],
        lambda looks: _seen(prober, looks, asked),
    )


def _seen(
    prober: Prober, looks: Mapping[int, Look], asked: Callable[[int, Array], Asked]
) -> Mapping[int, Sequence[Gap]]:
    """Return what is known of the distances that questions look at, by their numbers."""
    found: dict[int, Sequence[Gap]] = {}
    for exact in (False, True):
        numbers = [number for number, look in looks.items() if look.exact is exact]
        if numbers:
            questions = [asked(number, looks[number].times) for number in numbers]
            gaps = prober.gaps(questions, FAR, exact=exact)
            for number, own in zip(numbers, gaps, strict=True):
                found[number] = list(map(Gap, own.lower.tolist(), own.upper.tolist()))
    return found


def _meetings(stays: Sequence[Stay]) -> list[_Meeting]:
    """Return held and falling bodies with all others."""
    return [
        (stay, other, interval)
        for stay in stays
        if not stay.still
        for other in stays
        if other.body != stay.body
        and (interval := _common((stay.start_s, stay.end_s), (other.start_s, other.end_s)))
        and interval[1] > interval[0]
    ]


def _body_pairs(
    table: Table, meetings: Sequence[_Meeting], told: Iterator[float], near_miss: float | None
) -> None:
    """Held and falling bodies against all others; `near_miss` None: no matter how near."""
    counted = iter(_counted(meetings, told, near_miss))
    for stay, other, interval in meetings:
        parts = other.still and stay.parted_from(other)
        add_meeting(table, stay, other, interval, next(counted) if parts else interval)


def add_meeting(
    table: Table,
    stay: Stay,
    other: Stay,
    interval: tuple[float, float],
    counts: tuple[float, float],
    group: tuple[str, ...] = (),
) -> None:
    """A body that is held or falls against another one.

    Args:
        table: Where the pairs go.
        stay: The body that moves.
        other: The other one.
        interval: From when to when.
        counts: When their distance counts, if they come from each other or go there.
        group: Whose touches are one event; empty: those of the two names.
    """
    if other.still:
        own = group or (ROBOT if stay.lie is Lie.HELD else stay.body, other.body)
        _moving_against_still(table, stay, other, interval, counts, own)
    elif stay.lie is Lie.FALLING and other.lie is Lie.HELD:
        # from the hand, or met by what the hand carries
        rule = NEAR if stay.before == other.body else STRICT
        own = group or (ROBOT, stay.body)
        table.add(own, other.members, stay.members, interval, rule)


def _parted_questions(
    meetings: Sequence[_Meeting], near_miss: float | None
) -> list[_Question[float]]:
    """Return what asks from when and until when distances count, if any of them does."""
    found: list[_Question[float]] = []
    if near_miss is None:
        return found
    for stay, other, (start_s, end_s) in meetings:
        if stay.lie is not Lie.HELD or not stay.parted_from(other):
            continue
        always = [(other.members, -np.inf, np.inf)]  # times are within both but for rounding
        if other.body == stay.before:
            asking = counted_from(start_s, end_s, near_miss)
            found.append(_Question(asking, stay.members, always))
        if other.body == stay.after:
            asking = counted_until(start_s, end_s, near_miss)
            found.append(_Question(asking, stay.members, always))
    return found


def _counted(
    meetings: Sequence[_Meeting], told: Iterator[float], near_miss: float | None
) -> list[tuple[float, float]]:
    """Return when the distance of moving bodies from what they come from or go to counts.

    Args:
        meetings: Of all bodies.
        told: What `_parted_questions` came to.
        near_miss: Nearer than this is a near miss [m]; None: what counts is not wanted.
    """
    found: list[tuple[float, float]] = []
    for stay, other, (start_s, end_s) in meetings:
        if not stay.parted_from(other):
            continue
        if near_miss is None or stay.lie is not Lie.HELD:
            found.append((end_s, end_s))
            continue
        counts_s = min(next(told), end_s) if other.body == stay.before else start_s
        ceases_s = next(told) if other.body == stay.after else end_s
        found.append((counts_s, max(ceases_s, counts_s)))
    return found


def _moving_against_still(
    table: Table,
    stay: Stay,
    other: Stay,
    interval: tuple[float, float],
    counts: tuple[float, float],
    group: tuple[str, ...],
) -> None:
    if not stay.parted_from(other):
        table.add(group, stay.members, other.members, interval, STRICT)
        return
    table.add(group, stay.members, other.lowered, interval, NEAR)
    table.add(group, stay.members, other.members, counts, DISTANCE)


def _common(a: tuple[float, float], b: tuple[float, float]) -> tuple[float, float]:
    return max(a[0], b[0]), min(a[1], b[1])
