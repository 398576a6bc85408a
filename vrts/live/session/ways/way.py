"""One way of the arm as a run that has not happened, and what the collision check says of it.

The motion is the one that `Go` would give: planned from the end of the motions given, from rest to
rest. Objects stay where they were last, and what the hand holds comes along.
"""

from collections.abc import Mapping, Sequence
from typing import Final, NamedTuple

import numpy as np

from vrts.base.pose import Pose
from vrts.check.collision.collision import check_collisions
from vrts.check.curves.timeline_arrays import curves
from vrts.check.verdict import ContactEvent
from vrts.engine.faults import RuntimeFault
from vrts.engine.memory.events import Event, Grasped, HandCommanded
from vrts.engine.memory.records import Lie, Motion, Placement, Segment
from vrts.engine.motion.requests import Stance
from vrts.ir.instructions import HandAction
from vrts.live.session.channel.messages import AskReach
from vrts.live.session.channel.rows import WayTouch
from vrts.live.session.growing.growing_run import GrowingRun
from vrts.live.session.operator.motions import go, pose_of
from vrts.report.page.replay_data import contact_sentence
from vrts.robots.kinematics.choice import Request
from vrts.robots.kinematics.kinematics import forward
from vrts.robots.model import ArmBranch, Configuration
from vrts.scene.model import Scene

POINTS: Final = 33  # of the tool's path
MOST_TOUCHES: Final = 8  # that are told
_STAND_S = 0.028  # [s] that an arm is looked at which is there already
_CLOSED_S, _HELD_S = -2.0, -1.0  # [s] before the motion: the hand closed, the object was held
_END_S = 1e-3  # [s] before the end, from which on a contact is one of the goal
_DECIMALS = 5


class Asked(NamedTuple):
    """All that an answer depends on but the scene; small, so that it can be sent."""

    configuration: Configuration
    branch: ArmBranch
    request: Request
    X_VB: Pose
    X_FT: Pose
    position_m: tuple[float, float, float]
    oat_rad: tuple[float, float, float]
    straight: bool
    opening_m: float
    tracks: tuple[tuple[Placement, ...], ...]  # of each body the last placement, and one before


class Found(NamedTuple):
    """What is said of a way."""

    touches: tuple[WayTouch, ...]
    path_m: tuple[float, ...]  # x y z of the tool's point, `POINTS` times
    sure: bool  # whether all was decided


class _Segments(NamedTuple):
    segments: Sequence[Segment]


class _Record(NamedTuple):
    """A run that has not happened."""

    timeline: _Segments
    motions: Sequence[Motion]
    events: Sequence[Event]
    placements: Mapping[str, Sequence[Placement]]


def asked_of(growing: GrowingRun, order: AskReach) -> Asked:
    """Return what an answer to a question depends on now."""
    system = growing.machine.system
    stance = system.planner.stance
    return Asked(
        stance.configuration,
        stance.branch,
        stance.request,
        stance.X_VB,
        stance.X_FT,
        order.position_m,
        order.oat_rad,
        order.straight,
        growing.opening,
        tuple(tuple(track[-2:]) for track in system.hand.placements.values()),
    )


def find(scene: Scene, stance: Stance, asked: Asked) -> Found | None:
    """Return what the way to a pose touches; None: the arm cannot go there.

    Args:
        scene: What stands where.
        stance: Any of the session: its arm and its model never change.
        asked: Where the arm is, and where it is to go.
    """
    stance = Stance(
        stance.arm,
        asked.configuration,
        asked.branch,
        asked.request,
        asked.X_VB,
        asked.X_FT,
        stance.model,
    )
    try:
        planned = go(stance, pose_of(asked.position_m, asked.oat_rad), straight=asked.straight)
    except RuntimeFault:
        return None
    opening = (asked.opening_m,)
    segments = [
        Segment(start_s, end_s, (*rows, opening), None)
        for start_s, end_s, rows in planned.planned.pieces
    ]
    if not segments:
        here = tuple((q,) for q in asked.configuration)
        segments = [Segment(0.0, _STAND_S, (*here, opening), None)]
    report = check_collisions(scene, _record(segments, asked), clearance=False)
    end_s = segments[-1].end_s
    found = sorted((*report.contacts, *report.undetermined), key=lambda each: each.start_s)
    return Found(
        tuple(_touch(each, end_s) for each in found[:MOST_TOUCHES]),
        _path(stance, segments),
        report.certified,
    )


def _record(segments: Sequence[Segment], asked: Asked) -> _Record:
    """Return the motion as a run, with all bodies as they are when it begins."""
    placements: dict[str, Sequence[Placement]] = {}
    events: list[Event] = []
    for track in asked.tracks:
        last = track[-1]
        if last.lie is Lie.FALLING:
            continue  # nobody knows yet where it comes to rest
        before = [each._replace(start_s=_CLOSED_S, end_s=0.0) for each in track[:-1]]
        placements[last.body] = [*before, last._replace(start_s=0.0)]
        if last.lie is Lie.HELD:
            close = HandAction.CLOSE.value
            events += [
                HandCommanded(_CLOSED_S, close, None),
                Grasped(_HELD_S, last.body, last.X, None),
            ]
    return _Record(_Segments(segments), (), events, placements)


def _touch(event: ContactEvent, end_s: float) -> WayTouch:
    return WayTouch(
        contact_sentence(event),
        event.parts,
        round(event.start_s / end_s, _DECIMALS),
        round(min(event.end_s / end_s, 1.0), _DECIMALS),
        (
            round(event.point[0], _DECIMALS),
            round(event.point[1], _DECIMALS),
            round(event.point[2], _DECIMALS),
        ),
        at_goal=event.end_s >= end_s - _END_S,
    )


def _path(stance: Stance, segments: Sequence[Segment]) -> tuple[float, ...]:
    """Return where the tool's point goes, evenly in time [m]."""
    times = np.linspace(segments[0].start_s, segments[-1].end_s, POINTS)
    rows: list[list[float]] = curves(segments).values(times).tolist()
    frames = (forward(stance.arm, (q[0], q[1], q[2], q[3], q[4], q[5])) for q in rows)
    points = ((frame @ stance.X_FT).translation for frame in frames)
    return tuple(round(x, _DECIMALS) for point in points for x in point)
