"""A corner rounded: the end of one motion and the beginning of the next, added up.

From W before to W after the nominal instant at the corner both motions are under way: the first
slows down, the second picks up speed [Paul1981]_, as the controller model has it [manual
language/motion#corners]. Two joint motions add in the joints, two lines in
space, and a joint motion and a line in the joints of both.
"""

from typing import NamedTuple

from vrts.base.pose import Pose
from vrts.base.remembered import is_remembering, remembered
from vrts.controllers.model import Branches, CornerShape
from vrts.engine.memory.records import INSTANT
from vrts.engine.motion.lines.path import Course, LinePath, rounding
from vrts.engine.motion.lines.set_points import (
    STILL,
    Offset,
    Piece,
    SetPoints,
    deviation,
    follow,
    joined,
)
from vrts.engine.motion.paths import JointPath, Path
from vrts.engine.motion.plan import Intent, joint_pieces, parameters
from vrts.engine.motion.polynomials import Row, added
from vrts.engine.motion.profile import Profile, at
from vrts.engine.motion.remarks import Remark, remarks_on
from vrts.robots.kinematics.branch import branch_of
from vrts.robots.model import Arm, ArmBranch, Configuration


class Leg(NamedTuple):
    """The motion that was given last, on the timeline."""

    path: Path
    profile: Profile
    departure: float  # nominal, in path time [s]
    deceleration: float  # [s]

    @property
    def arrival(self) -> float:
        """Nominal, in path time [s]."""
        return self.departure + self.profile.duration


class Corner(NamedTuple):
    """Two motions joined."""

    start_s: float  # of the zone, in path time
    pieces: list[Piece]  # from the zone's start to the end of the second motion
    leg: Leg  # the second motion
    goal: Configuration
    branch: ArmBranch
    deviation_m: float
    remarks: tuple[Remark, ...]


def half_width(leg: Leg, intent: Intent, arm: Arm) -> float:
    """Return W [s], whole ticks: of the longer of the two accelerations, as the model has it.

    It is never less than half of that: the first motion must not have begun to stop.
    """
    longer = max(leg.deceleration, intent.settings.acceleration_times(arm)[0])
    if arm.blend_time is None:
        wanted = intent.model.corners.half_accelerations * longer
    else:
        wanted = 0.5 * arm.blend_time * longer / arm.acceleration_time
    return arm.tick * max(round(wanted / arm.tick), round(0.5 * longer / arm.tick))


def fits(leg: Leg, intent: Intent, half: float) -> bool:
    """Return whether the zone leaves room for the zones at the other ends."""
    return (
        leg.profile.rise <= leg.profile.duration - half + INSTANT
        and half + intent.profile.fall <= intent.profile.duration + INSTANT
    )


def round_corner(
    arm: Arm,
    X_FT: Pose,
    leg: Leg,
    intent: Intent,
    state: tuple[Configuration, Configuration],
) -> Corner | None:
    """Return two motions joined, or None when a line cannot be followed that way.

    Args:
        arm: The arm.
        X_FT: The tool, the same for both.
        leg: The motion under way.
        intent: The next, from the end of the first.
        state: Configuration and velocity in path time at the start of the zone.
    """
    if not is_remembering():
        return _rounded_corner(arm, X_FT, leg, intent, state)
    key = ("corner", id(arm), X_FT, leg, *intent.told_apart, state)
    alive = (arm, intent.model)
    return remembered(key, lambda: _rounded_corner(arm, X_FT, leg, intent, state), alive=alive)


def _rounded_corner(
    arm: Arm,
    X_FT: Pose,
    leg: Leg,
    intent: Intent,
    state: tuple[Configuration, Configuration],
) -> Corner | None:
    half = half_width(leg, intent, arm)
    at_rest = intent.model.corners.shape is CornerShape.PARABOLA  # as each would be by itself
    before = leg.profile._replace(fall=half, to_rest=at_rest)
    after = intent.profile._replace(rise=half, from_rest=at_rest)
    arrival = leg.arrival
    following = Leg(intent.path, after, arrival, intent.settings.acceleration_times(arm)[1])
    start = arrival - half
    first, second = leg.path, intent.path
    slowing, slowed = before.tail(), before.end
    over = after.end - INSTANT

    on_first = first.courses() if isinstance(first, LinePath) else None
    on_second = second.courses() if isinstance(second, LinePath) else None
    parameter_at = parameters(after)

    def course_before(t: float) -> Course:
        assert on_first is not None
        return on_first(*at(slowing, min(t - leg.departure, slowed)))

    def course_after(t: float) -> Course:
        assert on_second is not None
        x = t - arrival
        return on_second(*((1.0, 0.0) if x >= over else parameter_at(x)))

    zone = round(2.0 * half / arm.tick)
    if isinstance(second, JointPath):
        rest = joint_pieces(second, after.phases()[1:], arrival)
        if isinstance(first, JointPath):
            pieces = [_both(first, second, before, after, start, 2.0 * half), *rest]
            return _corner(start, pieces, following, intent)
        times = _times(start, zone, arm.tick)
        head, begun = after.head(), second.change

        def joining(t: float) -> Offset:
            u, rate = at(head, t - arrival)
            return Offset(_scaled(begun, u), _scaled(begun, rate))

        points = follow(
            arm,
            X_FT,
            times,
            course_before,
            (*state, intent.start_branch),
            joining,
        )
        return _into_joints(points, following, intent, rest)
    count = zone + round((after.end - half) / arm.tick)
    times = _times(start, count, arm.tick)
    if isinstance(first, JointPath):
        left = first.change

        def leaving(t: float) -> Offset:
            if t >= times[zone]:
                return Offset(STILL, STILL)
            u, rate = at(slowing, t - leg.departure)
            return Offset(_scaled(left, u - 1.0), _scaled(left, rate))

        points = follow(
            arm,
            X_FT,
            times,
            course_after,
            (first.goal, STILL, intent.start_branch),
            leaving,
        )
        return _into_line(arm, X_FT, points, following, zone, intent.model.branches)
    over_zone, rounded = times[zone], rounding(first.X_BT1)

    def course(t: float) -> Course:
        if t >= over_zone:
            return course_after(t)
        return rounded(course_before(t), course_after(t))

    points = follow(arm, X_FT, times, course, (*state, intent.start_branch))
    return _into_line(arm, X_FT, points, following, zone, intent.model.branches)


def _corner(start: float, pieces: list[Piece], leg: Leg, intent: Intent) -> Corner:
    assert intent.goal is not None
    assert intent.goal_branch is not None
    return Corner(start, pieces, leg, intent.goal, intent.goal_branch, 0.0, ())


def _into_joints(points: SetPoints, leg: Leg, intent: Intent, rest: list[Piece]) -> Corner | None:
    """Return a line that goes over into a joint motion."""
    if points.obstacle is not None:
        return None
    after = rest[0][2]  # the joint motion goes on exactly where the zone ends
    points.q[-1] = tuple(row[0] for row in after)  # type: ignore[call-overload]
    points.rates[-1] = tuple(row[1] if len(row) > 1 else 0.0 for row in after)  # type: ignore[call-overload]
    return _corner(points.times[0], [*joined(points), *rest], leg, intent)


def _into_line(
    arm: Arm, X_FT: Pose, points: SetPoints, leg: Leg, zone: int, rules: Branches
) -> Corner | None:
    """Return a motion that goes over into a line."""
    if points.obstacle is not None:
        return None
    assert isinstance(leg.path, LinePath)
    pieces, goal = joined(points), points.q[-1]
    return Corner(
        points.times[0],
        pieces,
        leg,
        goal,
        branch_of(arm, goal, points.branch, rules),
        deviation(arm, X_FT, leg.path, pieces[zone:]),
        remarks_on(leg.path, points),
    )


def _both(
    first: JointPath,
    second: JointPath,
    before: Profile,
    after: Profile,
    start: float,
    length: float,
) -> Piece:
    u, v = before.tail().coefficients, after.head().coefficients
    rows: list[Row] = []
    for corner, out, into in zip(first.goal, first.change, second.change, strict=True):
        leaving = tuple(out * (c - 1.0 if k == 0 else c) for k, c in enumerate(u))
        row = added(leaving, tuple(into * c for c in v))
        rows.append((corner + row[0], *row[1:]))
    return (start, start + length, tuple(rows))


def _times(start: float, count: int, tick: float) -> list[float]:
    return [start + k * tick for k in range(count + 1)]


def _scaled(change: Configuration, u: float) -> Configuration:
    d1, d2, d3, d4, d5, d6 = change
    return (u * d1, u * d2, u * d3, u * d4, u * d5, u * d6)
