"""What may touch in a grip, and when: read from the record of a run, by no code of the check.

Pads may press 1 mm into what they grasp, from the command that closes them until the finger has
first come free of it after the release. A support is tested 1 mm lower against what it held up or
will. Everything else may touch 0.2 mm deep.
"""

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from tests.adversary.cases import Case
from tests.adversary.judge import (
    ROBOT,
    TOLERANCE,
    Judge,
    Meeting,
    Part,
    arm_parts,
    finger_parts,
    hand_parts,
    matrix,
    palm_parts,
    parts_of,
)
from vrts.engine.memory.events import Grasped, HandCommanded, Released
from vrts.engine.memory.records import Lie, Placement
from vrts.scene.model import Body, Mobility

PRESSED = 1e-3  # [m] pads may press so far into what they grasp
LOWERED = 1e-3  # [m] supports are tested so much lower
FREE = 2e-4  # [m] a finger farther away has come free
LOOK = 2e-3  # [s] between looks whether it has


class Grip(NamedTuple):
    """A grip, as its events tell it."""

    close_s: float
    open_s: float


def judge_of(case: Case) -> Judge:
    """Return the judge of a case with a support, a thing beside, and one body that is grasped."""
    segments = case.record.timeline.segments
    return Judge(segments, (*_of_bodies(case), *_of_robot(case), *_of_fingers(case)))


def grips_of(case: Case) -> list[Grip]:
    """Return the grips, in order of time."""
    found: list[Grip] = []
    close_s = 0.0
    for event in case.record.events:
        if isinstance(event, HandCommanded) and event.action == "close":
            close_s = event.time_s
        elif isinstance(event, Grasped):
            found.append(Grip(close_s, np.inf))
        elif isinstance(event, Released):
            found[-1] = found[-1]._replace(open_s=event.time_s)
    return found


def _still(case: Case) -> Iterator[Body]:
    yield from (body for body in case.scene.bodies if body.mobility is Mobility.FIXED)


def _of_robot(case: Case) -> Iterator[Meeting]:
    """Yield arm and hand, and all that stands; arm and palm, and what is grasped."""
    machine = case.scene.robot
    for body in _still(case):
        stands = Placement(body.name, 0.0, np.inf, Lie.RESTING, body.X_WO, None)
        for part in (*arm_parts(machine), *hand_parts(machine)):
            for other in parts_of(body, stands):
                yield Meeting((ROBOT, body.name), part, other, 0.0, np.inf)
    for body, lie in _places(case):
        for part in (*arm_parts(machine), *palm_parts(machine)):
            for other in parts_of(body, lie):
                yield Meeting((ROBOT, body.name), part, other, lie.start_s, lie.end_s)


def _of_bodies(case: Case) -> Iterator[Meeting]:
    """Yield what is held or falls, and all that stands."""
    for body, lie in _places(case):
        if lie.lie not in (Lie.HELD, Lie.FALLING):
            continue
        places = case.record.placements[body.name]
        k = places.index(lie)
        before = places[k - 1].support if k else body.rests_on
        after = next((p.support for p in places[k + 1 :] if p.lie is not Lie.FALLING), None)
        who = ROBOT if lie.lie is Lie.HELD else body.name
        for other in _still(case):
            parted = other.name in (before, after)
            X_WO = matrix(other.X_WO)
            X_WO[2, 3] -= LOWERED if parted else 0.0
            for piece in other.pieces:
                stands = Part(piece.shape, -1, X_WO @ matrix(piece.X_OP), 0.0)
                for part in parts_of(body, lie):
                    group = who, other.name
                    times = lie.start_s, lie.end_s
                    yield Meeting(group, part, stands, *times, counts=not parted)


def _of_fingers(case: Case) -> Iterator[Meeting]:
    """Yield each finger and what it grasps, under the rule of each time."""
    horizon = case.record.timeline.segments[-1].end_s
    held = grips_of(case)
    for finger in case.scene.robot.gripper.fingers:
        rules = [(0.0, 0.0)]  # from when, and how much deeper it may be
        for number, grip in enumerate(held):
            until = held[number + 1].close_s if number + 1 < len(held) else horizon
            rules.append((grip.close_s, PRESSED - TOLERANCE))
            free_s = _free_from(case, finger_parts(finger), min(grip.open_s, until), until)
            rules.append((free_s, 0.0))
        ends = [start for start, _ in rules[1:]] + [np.inf]
        for (start, eased), end in zip(rules, ends, strict=True):
            yield from _with_grasped(case, finger_parts(finger), start, end, eased)


def _free_from(case: Case, parts: tuple[Part, ...], open_s: float, until: float) -> float:
    """Return when a finger first comes free of what was let go; `until` if it does not."""
    times = np.arange(open_s, until, LOOK)
    if not len(times):
        return until
    nearest = np.full(len(times), np.inf)
    judge = Judge(case.record.timeline.segments, ())
    for meeting in _with_grasped(case, parts, open_s, until, 0.0):
        there = (meeting.start_s <= times) & (times < meeting.end_s)
        if there.any():
            gaps = judge.distances(meeting, times[there])
            nearest[there] = np.minimum(nearest[there], gaps)
    free = np.flatnonzero(nearest > FREE)
    return float(times[free[0]]) if len(free) else until


def _with_grasped(
    case: Case, parts: tuple[Part, ...], start_s: float, end_s: float, eased: float
) -> Iterator[Meeting]:
    for body, lie in _places(case):
        start, end = max(start_s, lie.start_s), min(end_s, lie.end_s)
        if end <= start:
            continue
        for part in parts:
            for other in parts_of(body, lie):
                counts = eased == 0.0 and start_s == 0.0
                yield Meeting((ROBOT, body.name), part, other, start, end, eased, counts)


def _places(case: Case) -> Iterator[tuple[Body, Placement]]:
    for body in case.scene.bodies:
        for lie in case.record.placements.get(body.name, ()):
            yield body, lie
