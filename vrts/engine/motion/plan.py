"""One motion from rest to rest: its path, its time scaling, and what stops it on the way."""

from collections.abc import Callable, Hashable
from typing import NamedTuple

from vrts.base.pose import Pose
from vrts.base.remembered import is_remembering, remembered
from vrts.base.source import Span
from vrts.controllers.model import ControllerModel, NoLength
from vrts.engine.faults import RuntimeFault
from vrts.engine.motion.lines.faults import obstacle_fault
from vrts.engine.motion.lines.path import Course, LinePath
from vrts.engine.motion.lines.set_points import STILL, Piece, SetPoints, deviation, follow, joined
from vrts.engine.motion.paths import JointPath, Path
from vrts.engine.motion.polynomials import Row
from vrts.engine.motion.profile import Phase, Profile, at, profile
from vrts.engine.motion.remarks import Remark, remarks_on
from vrts.engine.motion.settings import Settings
from vrts.ir.instructions import Interpolation
from vrts.robots.kinematics.branch import branch_of
from vrts.robots.model import Arm, ArmBranch, Configuration

SHORTEST_LINE = 1e-6  # [m] or [rad]: less is no motion at all
ROUNDING = 1e-9  # [m] or [rad]: a motion of less goes nowhere


class Intent(NamedTuple):
    """A motion that is asked for: where from, where to and how fast."""

    interpolation: Interpolation
    path: Path
    profile: Profile  # from rest to rest
    start: Configuration
    start_branch: ArmBranch
    goal: Configuration | None  # None: the end of the line tells
    goal_branch: ArmBranch | None
    settings: Settings
    fraction: float  # program speed as a share of full speed
    model: ControllerModel
    span: Span | None = None  # of the target, for what is wrong with it
    keeps_request: bool = False  # an arm branch that was asked for is left to a later motion

    @property
    def goes_nowhere(self) -> bool:
        """Whether the arm is there already."""
        path = self.path
        if isinstance(path, JointPath):
            return all(abs(change) <= ROUNDING for change in path.change)
        return path.length <= ROUNDING and path.turned <= ROUNDING

    @property
    def told_apart(self) -> tuple[Hashable, ...]:
        """All that makes it another motion; its model by the address."""
        return (id(self.model), *self[:9], self.keeps_request)

    @property
    def takes_no_time(self) -> bool:
        """Whether it ends where and when it begins, as the controller model has it."""
        match self.model.pace.no_length:
            case NoLength.NO_TIME:
                return self.goes_nowhere
            case NoLength.LEAST_TIME:
                return False
            case NoLength.BY_KIND:
                return isinstance(self.path, JointPath) and self.path.start == self.path.goal


class Planned(NamedTuple):
    """A motion from rest to rest, ready to be put on the timeline."""

    path: Path
    profile: Profile
    pieces: list[Piece]  # from time 0; none when nothing moves
    goal: Configuration
    branch: ArmBranch
    deviation_m: float = 0.0
    remarks: tuple[Remark, ...] = ()
    fault: RuntimeFault | None = None  # it ends before its target, for this reason


def joint_intent(
    arm: Arm,
    start: Configuration,
    goal: Configuration,
    branches: tuple[ArmBranch, ArmBranch],
    settings: Settings,
    fraction: float,
    model: ControllerModel,
) -> Intent:
    """Return a joint-interpolated motion; the branches are those at start and goal."""
    path = JointPath(start, goal)
    return Intent(
        Interpolation.JOINT,
        path,
        joint_profile(arm, path, settings, fraction, model),
        start,
        branches[0],
        goal,
        branches[1],
        settings,
        fraction,
        model,
    )


def joint_profile(
    arm: Arm, path: JointPath, settings: Settings, fraction: float, model: ControllerModel
) -> Profile:
    """Return the time scaling of a joint motion from rest to rest."""
    return profile(
        path.needed(arm.speed, fraction),
        *settings.acceleration_times(arm),
        arm.tick,
        settings.duration,
        least_accelerations=model.pace.least_accelerations,
    )


def line_intent(
    arm: Arm,
    path: LinePath,
    start: tuple[Configuration, ArmBranch],
    settings: Settings,
    fraction: float,
    model: ControllerModel,
    span: Span | None,
) -> Intent:
    """Return a straight line."""
    scaling = line_profile(arm, path, settings, fraction, model)
    return Intent(
        Interpolation.LINEAR, path, scaling, *start, None, None, settings, fraction, model, span
    )


def line_profile(
    arm: Arm, path: LinePath, settings: Settings, fraction: float, model: ControllerModel
) -> Profile:
    """Return the time scaling of a line from rest to rest."""
    turning = fraction
    if settings.rotation is not None:
        turning = min(settings.rotation, model.pace.most_speed_percent) / 100.0
    speeds = (arm.linear_speed * fraction, arm.angular_speed * turning)
    return profile(
        path.needed(*speeds, model.lines.measure),
        *settings.acceleration_times(arm),
        arm.tick,
        settings.duration,
        least_accelerations=model.pace.least_accelerations,
    )


def from_rest(arm: Arm, X_FT: Pose, intent: Intent) -> Planned:
    """Return a motion from rest to rest; a line ends early where it cannot be followed."""
    if not is_remembering():
        return _from_rest(arm, X_FT, intent)
    key = ("from rest", id(arm), X_FT, *intent.told_apart)
    alive = (arm, intent.model)
    return remembered(key, lambda: _from_rest(arm, X_FT, intent), alive=alive, worth=_whole)


def _whole(planned: Planned) -> bool:
    """Return whether nothing is wrong: a fault is told of one step, and gets its advice later."""
    return planned.fault is None


def _from_rest(arm: Arm, X_FT: Pose, intent: Intent) -> Planned:
    path = intent.path
    if isinstance(path, JointPath):
        assert intent.goal is not None
        assert intent.goal_branch is not None
        scaling = intent.profile
        moves = not intent.takes_no_time
        pieces = joint_pieces(path, scaling.phases(), scaling.rise) if moves else []
        return Planned(path, scaling, pieces, intent.goal, intent.goal_branch)
    start, branch = intent.start, intent.start_branch
    if intent.takes_no_time:
        return Planned(path, intent.profile, [], start, branch)
    fault, part, scaling = None, path, intent.profile
    points = follow_line(arm, X_FT, part, scaling, start, branch)
    while points.obstacle is not None:
        obstacle = points.obstacle
        u = parameter(scaling, points.times[obstacle.at] - scaling.rise)[0]
        if fault is None:
            met, worst = (
                parameter(scaling, t - scaling.rise)[0] for t in (obstacle.met_s, obstacle.worst_s)
            )
            fault = obstacle_fault(obstacle, path, (met, worst), intent.span)
        elif u > 0.5:
            u = 0.5
        if u <= SHORTEST_LINE:
            return Planned(part, scaling, [], start, branch, fault=fault)
        part = part.part(u)
        scaling = line_profile(arm, part, intent.settings, intent.fraction, intent.model)
        points = follow_line(arm, X_FT, part, scaling, start, branch)
    pieces = joined(points)
    goal = points.q[-1]
    return Planned(
        part,
        scaling,
        pieces,
        goal,
        branch_of(arm, goal, points.branch, intent.model.branches),
        deviation(arm, X_FT, part, pieces),
        remarks_on(path, points),
        fault,
    )


def follow_line(
    arm: Arm,
    X_FT: Pose,
    path: LinePath,
    scaling: Profile,
    start: Configuration,
    branch: ArmBranch,
) -> SetPoints:
    """Return the set points of a line from rest to rest, from time 0."""
    count = round(scaling.total / arm.tick)
    times = [k * arm.tick for k in range(count + 1)]

    courses, parameter_at = path.courses(), parameters(scaling)
    over, rise = times[count], scaling.rise

    def course(t: float) -> Course:
        return courses(*((1.0, 0.0) if t >= over else parameter_at(t - rise)))

    return follow(arm, X_FT, times, course, (start, STILL, branch))


def parameter(scaling: Profile, x: float) -> tuple[float, float]:
    """Return u and du/dx at a time from the nominal departure."""
    return parameters(scaling)(x)


def parameters(scaling: Profile) -> Callable[[float], tuple[float, float]]:
    """Return what does the same for many times."""
    duration, begin, end = scaling.duration, scaling.rise, scaling.duration - scaling.fall
    head = scaling.head() if begin else None  # without a zone nobody is in it
    tail = scaling.tail() if scaling.fall else None
    rate = 1.0 / duration

    def parameter_at(x: float) -> tuple[float, float]:
        if head is not None and x <= begin:
            return at(head, x)
        if tail is None or x < end:  # the end of constant speed
            return x / duration, rate
        return at(tail, x)

    return parameter_at


def joint_pieces(path: JointPath, phases: tuple[Phase, ...], offset: float) -> list[Piece]:
    """Return the polynomials of a joint path; `offset` is the time of the nominal departure."""
    change = path.change
    return [
        (
            offset + phase.start,
            offset + phase.start + phase.length,
            tuple(_row(q, d, phase.coefficients) for q, d in zip(path.start, change, strict=True)),
        )
        for phase in phases
    ]


def _row(q: float, d: float, u: Row) -> Row:
    if d == 0.0:
        return (q,)
    return (q + d * u[0], *(d * c for c in u[1:]))
