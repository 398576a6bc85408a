"""A short run made by hand from the records: a can is carried over a table and hits a base.

Reports read records, so they can be tested without the stages that make them.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import cast

from tests.support_reports import SOURCE, TASK, contact_loss, grade, span
from vrts.base.diagnostic import Diagnostic, Label, Moment, Rule, error
from vrts.base.oat import pose_from_components
from vrts.base.pose import Pose, translation
from vrts.check.judgement import Judgement
from vrts.check.task.task import ViaPoint
from vrts.check.verdict import Answer, CollisionReport, ContactEvent, Verdict
from vrts.engine.memory.events import (
    Cause,
    Event,
    Grasped,
    HandCommanded,
    Landed,
    MotionEnded,
    MotionStarted,
    Printed,
    ProgramEnded,
    ProgramStarted,
    Released,
)
from vrts.engine.memory.records import Ending, Lie, Motion, Placement, Segment
from vrts.engine.run import Run
from vrts.geometry.shapes import Box, Cylinder, Piece
from vrts.ir.instructions import Interpolation
from vrts.ir.module import Module
from vrts.report.assessment import Assessment
from vrts.robots.catalog import robot
from vrts.robots.kinematics.kinematics import forward, solve
from vrts.robots.model import ArmBranch, Configuration, Elbow, Shoulder, Wrist
from vrts.scene.model import Body, Mobility, Scene

CONTACT = Rule("V401", "contact")
BRANCH = ArmBranch(Shoulder.LEFTY, Elbow.ABOVE, Wrist.NOFLIP)
MOVES = Cause("sort", 2, span("MOVES base2_put"))
TYPE = Cause("sort", 3, span('TYPE "done"'))

GRASP_S, START_S, END_S, FALL_S, RUN_S = 0.3, 0.5, 2.5, 2.8, 3.2
CONTACT_S = (1.2, 1.6)


@dataclass(frozen=True)
class Timeline:
    """Segments in time order."""

    segments: Sequence[Segment]

    @property
    def segments_or_start(self) -> Sequence[Segment]:
        """The same; there is one."""
        return self.segments


@dataclass(frozen=True)
class Record:
    """The part of a Run that reports read."""

    scene: Scene
    timeline: Timeline
    motions: Sequence[Motion]
    events: Sequence[Event]
    placements: Mapping[str, Sequence[Placement]]
    findings: tuple[Diagnostic, ...]
    ending: Ending
    ended_s: float | None
    horizon_s: float


def _box(name: str, kind: str, half: tuple[float, float, float], X_WO: Pose) -> Body:
    piece = Piece(Box(half), translation(0, 0, 0))
    return Body(name, name, kind, Mobility.FIXED, (piece,), X_WO, (0.5, 0.4, 0.3), (0, 0, 0))


def scene() -> Scene:
    """Return a table with two bases and a can."""
    can = Piece(Cylinder(0.03, 0.0575), translation(0, 0, 0.0575))
    bodies = (
        _box("floor", "floor", (5, 5, 0.05), translation(0, 0, -1.17)),
        _box("table", "table", (0.4, 0.7, 0.02), translation(1.0, 0, -0.32)),
        _box("base1", "base", (0.06, 0.06, 0.075), translation(0.95, -0.1, -0.225)),
        _box("base2", "base", (0.06, 0.06, 0.05), translation(1.1, 0.23, -0.25)),
        Body(
            "can1",
            "the red can",
            "can",
            Mobility.MOVABLE,
            (can,),
            translation(0.8, -0.45, -0.3),
            (0.7, 0.05, 0.05),
            (0, 0, 0.0575),
            (0, 0, 1),
            "table",
        ),
    )
    X_FT = pose_from_components(0, 0, 150, 90, -90, 0)
    return Scene("hand-made", "A can and two bases", robot("puma761"), X_FT, bodies, {}, "1" * 64)


def _above(x: float, y: float, z: float) -> Configuration:
    """Return the configuration with the pads at a point and the hand straight down."""
    arm = robot("puma761").arm
    X_BF = pose_from_components(1000 * x, 1000 * y, 1000 * (z + 0.15), 90, 90, 0)
    found = solve(arm, X_BF, BRANCH, arm.ready)
    assert found is not None
    return found


def _rest(q: Configuration, start_s: float, end_s: float, hand: tuple[float, float]) -> Segment:
    slope = (hand[1] - hand[0]) / (end_s - start_s)
    return Segment(start_s, end_s, (*((x,) for x in q), (hand[0], slope)), None)


def _move(a: Configuration, b: Configuration, start_s: float, end_s: float) -> Segment:
    """Return the cubic from rest to rest."""
    t = end_s - start_s
    rows = tuple(
        (x, 0.0, 3 * (y - x) / t**2, -2 * (y - x) / t**3) for x, y in zip(a, b, strict=True)
    )
    return Segment(start_s, end_s, (*rows, (0.06,)), 0)


def run() -> Run:
    """Return a run of 3.2 s: close, carry, open in the air, the can falls."""
    place = scene()
    a, b = _above(0.8, -0.45, -0.19), _above(1.1, 0.23, -0.09)
    segments = (
        _rest(a, 0.0, GRASP_S, (0.08, 0.06)),
        _rest(a, GRASP_S, START_S, (0.06, 0.06)),
        _move(a, b, START_S, END_S),
        _rest(b, END_S, FALL_S, (0.06, 0.08)),
        _rest(b, FALL_S, RUN_S, (0.08, 0.08)),
    )
    arm = place.robot.arm
    X_WO = place.body("can1").X_WO
    X_FO = forward(arm, a).inverse() @ X_WO
    dropped = forward(arm, b) @ X_FO
    X_WT = forward(arm, b) @ place.X_FT
    linear = Interpolation.LINEAR
    moves = Motion(linear, START_S, END_S, a, b, X_WT, place.X_FT, 0.6, 0.0, MOVES)
    landed_s = END_S + 0.1
    fallen = replace_height(dropped, dropped.translation[2] - 9.81 / 2 * 0.1**2)
    can = (
        Placement("can1", 0.0, GRASP_S, Lie.RESTING, X_WO, "table"),
        Placement("can1", GRASP_S, END_S, Lie.HELD, X_FO, None),
        Placement("can1", END_S, landed_s, Lie.FALLING, dropped, None),
        Placement("can1", landed_s, float("inf"), Lie.RESTING, fallen, "base2"),
    )
    events: tuple[Event, ...] = (
        ProgramStarted(0.0, "sort"),
        HandCommanded(0.0, "close", None),
        Grasped(GRASP_S, "can1", X_FO, None),
        MotionStarted(START_S, 0, MOVES),
        MotionEnded(END_S, 0, MOVES),
        Released(END_S, "can1", 0.049, None),
        Landed(landed_s, "can1", "base2", None),
        Printed(2.7, "done </script>\n", TYPE),
        ProgramEnded(RUN_S, "completed"),
    )
    record = Record(
        place,
        Timeline(segments),
        (moves,),
        events,
        {"can1": can},
        (),
        Ending.COMPLETED,
        RUN_S,
        RUN_S,
    )
    return cast(Run, record)


def with_segments(*segments: Segment) -> Run:
    """Return the run with another timeline, which lasts from 0 to the end of the last segment."""
    record = cast(Record, run())
    end = segments[-1].end_s
    return cast(Run, replace(record, timeline=Timeline(segments), ended_s=end, horizon_s=end))


def replace_height(X: Pose, z: float) -> Pose:
    """Return a pose at another height [m]."""
    x, y, _ = X.translation
    return Pose(X.rotation, (x, y, z))


def assessment() -> Assessment:
    """Return the assessment of the run: the held can hits a base."""
    start_s, end_s = CONTACT_S
    contact = ContactEvent(
        *("robot", "base1", ("can1", "base1"), start_s, end_s, 1.4, 0.0231),
        (0.95, -0.1, -0.16),
        "can1",
        MOVES,
    )
    moment = Moment(start_s, (*_above(0.9, -0.2, -0.16), 0.06), ("can1", "base1"))
    found = error(CONTACT, "the held can1 hits base1", Label(MOVES.span, "here"), moment=moment)
    report = CollisionReport((contact,), (), (), None, True, {"nodes": 12})
    verdicts = (
        Verdict("collision", Answer.VIOLATED, "1 contact", (found,)),
        Verdict("target can1", Answer.HOLDS, "0.1 mm from its place"),
    )
    loss = contact_loss(Fraction(3, 2))._replace(
        sentence="at 1.2 s, line 2 `MOVES base2_put`, the held can1 hits base1", moment=moment
    )
    task = replace(TASK, vias=(ViaPoint("gate", (0.95, -0.1, 0.1), 0.05, None),))
    return Assessment(
        "submission-07",
        "submission-07.v2",
        SOURCE,
        (),
        Module({}, ()),
        scene(),
        task,
        run(),
        Judgement(verdicts, report),
        grade(loss),
    )
