"""Runs put together from records: motions, grasps and falls without a program or a controller."""

import math
from collections.abc import Mapping
from dataclasses import dataclass, field

from vrts.base.pose import Pose, Rotation, Vector, rotation_angle, subtract, translation
from vrts.base.source import SourceFile, Span
from vrts.engine.memory.events import Cause, Event, Grasped, HandCommanded, Landed, Released
from vrts.engine.memory.records import GRAVITY, Lie, Motion, Placement, Segment
from vrts.geometry.shapes import Piece
from vrts.ir.instructions import HandAction, Interpolation
from vrts.robots.catalog import robot
from vrts.robots.kinematics.branch import ArmBranch
from vrts.robots.kinematics.kinematics import forward, joint_velocity, solve
from vrts.robots.model import Configuration, Elbow, Robot, Shoulder, Wrist
from vrts.scene.model import Body, Mobility, Scene

TICK = 0.028
STROKE = 0.3
DOWN: Rotation = (-1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, -1.0)  # fingers open along y
BRANCH = ArmBranch(Shoulder.LEFTY, Elbow.ABOVE, Wrist.NOFLIP)
TEXT = SourceFile("story.v2", "step\n" * 200)


def down(x: float, y: float, z: float) -> Pose:
    """Pose of the pad centre with the hand straight down, in m."""
    return Pose(DOWN, (x, y, z))


def fixed(name: str, *pieces: Piece, at: Vector = (0.0, 0.0, 0.0)) -> Body:
    """A thing that stays where it is."""
    X_WO = translation(*at)
    return Body(name, name, "box", Mobility.FIXED, pieces, X_WO, (0.5, 0.5, 0.5), (0.0, 0.0, 0.0))


def movable(name: str, *pieces: Piece, at: Vector, on: str | None) -> Body:
    """A thing that can be carried."""
    X_WO = translation(*at)
    color = (0.5, 0.5, 0.5)
    return Body(name, name, "can", Mobility.MOVABLE, pieces, X_WO, color, (0.0, 0.0, 0.0), None, on)


def scene_of(*bodies: Body, machine: Robot | None = None) -> Scene:
    """A scene with the 761."""
    machine = machine or robot("puma761")
    return Scene("test", "test", machine, machine.gripper.X_FP, bodies, {}, "")


@dataclass(frozen=True)
class Line:
    """A timeline."""

    segments: tuple[Segment, ...]


@dataclass(frozen=True)
class Record:
    """What the check reads of a run."""

    timeline: Line
    motions: tuple[Motion, ...]
    events: tuple[Event, ...]
    placements: Mapping[str, tuple[Placement, ...]]


@dataclass
class Story:
    """Builds a run step by step; `t` is the present."""

    scene: Scene
    q: Configuration
    opening: float = 0.08
    t: float = 0.0
    segments: list[Segment] = field(default_factory=list[Segment])
    motions: list[Motion] = field(default_factory=list[Motion])
    events: list[Event] = field(default_factory=list[Event])
    placements: dict[str, list[Placement]] = field(default_factory=dict[str, list[Placement]])

    def __post_init__(self) -> None:
        for body in self.scene.bodies:
            if body.mobility is Mobility.MOVABLE:
                first = Placement(body.name, 0.0, math.inf, Lie.RESTING, body.X_WO, body.rests_on)
                self.placements[body.name] = [first]

    @property
    def X_WP(self) -> Pose:
        """Where the pad centre is."""
        return forward(self.scene.robot.arm, self.q) @ self.scene.robot.gripper.X_FP

    def solved(self, X_WP: Pose) -> Configuration:
        """The configuration of a pad centre pose."""
        X_BF = X_WP @ self.scene.robot.gripper.X_FP.inverse()
        q = solve(self.scene.robot.arm, X_BF, BRANCH, self.q)
        assert q is not None
        return q

    def cause(self) -> Cause:
        """The next instruction."""
        step = len(self.events) + len(self.motions) + 1
        return Cause("story", step, Span(TEXT, 5 * step - 5, 5 * step - 1))

    def move(self, goal: Pose | Configuration, speed: float = 0.5) -> None:
        """Turn all joints to a goal on cubics from rest to rest."""
        arm = self.scene.robot.arm
        q = self.solved(goal) if isinstance(goal, Pose) else goal
        shares = [abs(b - a) / v for a, b, v in zip(self.q, q, arm.speed, strict=True)]
        duration = max(0.1, 1.5 * max(shares) / speed)
        rows = [hermite(a, b, 0.0, 0.0, duration) for a, b in zip(self.q, q, strict=True)]
        start = self.t
        self._append(rows, duration, len(self.motions))
        self._motion(Interpolation.JOINT, start, q, speed)

    def line(self, goal: Pose, speed_m_s: float = 0.25) -> None:
        """Carry the pad centre along a straight line at set points of 28 ms; no turning."""
        here = self.X_WP
        assert rotation_angle(here.rotation, goal.rotation) < 1e-9
        step = subtract(goal.translation, here.translation)
        duration = max(2 * TICK, 1.5 * math.hypot(*step) / speed_m_s)
        count = math.ceil(duration / TICK)
        duration, start = count * TICK, self.t
        known = self.q, (0.0,) * 6
        for k in range(1, count + 1):
            s = k / count
            share, rate = s * s * (3 - 2 * s), 6 * s * (1 - s) / duration
            x, y, z = here.translation
            at = (x + share * step[0], y + share * step[1], z + share * step[2])
            q = self.solved(Pose(here.rotation, at))
            v = (rate * step[0], rate * step[1], rate * step[2])
            dq = joint_velocity(self.scene.robot.arm, q, v, (0.0, 0.0, 0.0))
            assert dq is not None
            rows = [
                hermite(a, b, va, vb, TICK)
                for a, b, va, vb in zip(known[0], q, known[1], dq, strict=True)
            ]
            self._append(rows, TICK, len(self.motions))
            known = q, dq
            self.q = q
        self._motion(Interpolation.LINEAR, start, self.q, 0.5)

    def wait(self, duration: float) -> None:
        """Stand still."""
        self._append([(q,) for q in self.q], duration, None)

    def hand(self, opening: float, action: HandAction) -> None:
        """Open or close at the gripper's pace, standing still."""
        self.events.append(HandCommanded(self.t, action.value, self.cause()))
        duration = abs(opening - self.opening) / 0.08 * STROKE
        if duration == 0.0:
            return
        rate = (opening - self.opening) / duration
        row = (self.opening, rate)
        rows = [(q,) for q in self.q]
        self.segments.append(Segment(self.t, self.t + duration, (*rows, row), None))
        self.t += duration
        self.opening = opening

    def grasp(self, body: str, width: float = 0.06) -> None:
        """Close on a body, which then travels with the hand."""
        self.hand(width, HandAction.CLOSE)
        X_WO = self.placements[body][-1].X
        X_FO = forward(self.scene.robot.arm, self.q).inverse() @ X_WO
        self.events.append(Grasped(self.t, body, X_FO, self.cause()))
        self._place(Placement(body, self.t, math.inf, Lie.HELD, X_FO, None))

    def release(self, body: str, support: str, fall: float = 0.0) -> None:
        """Open; the body sinks by a height and rests."""
        X_WO = forward(self.scene.robot.arm, self.q) @ self.placements[body][-1].X
        self.events.append(Released(self.t, body, fall, self.cause()))
        start = self.t
        if fall > 0.0:
            self._place(Placement(body, start, math.inf, Lie.FALLING, X_WO, None))
            start += math.sqrt(2 * fall / GRAVITY)
        x, y, z = X_WO.translation
        rest = Pose(X_WO.rotation, (x, y, z - fall))
        self._place(Placement(body, start, math.inf, Lie.RESTING, rest, support))
        self.hand(0.08, HandAction.OPEN)
        self.events.append(Landed(start, body, support, None))

    def record(self) -> Record:
        """The run so far."""
        placements = {name: tuple(own) for name, own in self.placements.items()}
        events = tuple(sorted(self.events, key=lambda event: event.time_s))
        return Record(Line(tuple(self.segments)), tuple(self.motions), events, placements)

    def _place(self, placement: Placement) -> None:
        own = self.placements[placement.body]
        own[-1] = own[-1]._replace(end_s=placement.start_s)
        own.append(placement)

    def _append(self, rows: list[tuple[float, ...]], duration: float, motion: int | None) -> None:
        end = self.t + duration
        self.segments.append(Segment(self.t, end, (*rows, (self.opening,)), motion))
        self.t = end

    def _motion(
        self, interpolation: Interpolation, start: float, q: Configuration, speed: float
    ) -> None:
        arm = self.scene.robot.arm
        X_FP = self.scene.robot.gripper.X_FP
        cause = self.cause()
        motion = Motion(
            interpolation, start, self.t, self.q, q, forward(arm, q) @ X_FP, X_FP, speed, 0.0, cause
        )
        self.motions.append(motion)
        self.q = q


def hermite(a: float, b: float, va: float, vb: float, duration: float) -> tuple[float, ...]:
    """A cubic from a to b with given end velocities."""
    d = b - a
    return (
        a,
        va,
        (3 * d / duration - 2 * va - vb) / duration,
        (va + vb - 2 * d / duration) / duration**2,
    )
