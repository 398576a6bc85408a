"""From a location to a motion: settings, arm branches, checks on the way, and the polynomials.

Frames: VAL's world is the robot's base frame displaced by BASE, so a location X of a program is
reached by the tool at X_BT = X_VB^-1 X, with X_VB the displacement of the robot.
"""

import math
from typing import NamedTuple

from vrts.base.pose import IDENTITY, Pose, translation
from vrts.base.source import Span
from vrts.base.units import DEG, INCH, MM, deg, mm
from vrts.engine.events import Cause
from vrts.engine.faults import SINGULAR_JUMP, RuntimeFault
from vrts.engine.joint_path import Piece, joint_pieces, joint_profile
from vrts.engine.line_path import (
    Course,
    Line,
    Obstacle,
    follow,
    line_profile,
    singular_at,
    tool_at,
    turning,
)
from vrts.engine.profile import TICK_TOLERANCE
from vrts.engine.records import Motion
from vrts.engine.timeline import ArmPiece, value
from vrts.ir.instructions import BranchRequest, Interpolation, SpeedUnit
from vrts.ir.runtime_errors import RuntimeErrorKind
from vrts.ir.values import Joints
from vrts.robots.branch import INITIAL_BRANCH, branch_of
from vrts.robots.choice import NOTHING_REQUESTED, OutOfLimits, OutOfReach, choose
from vrts.robots.kinematics import forward, limit_violations
from vrts.robots.model import (
    ArmBranch,
    Configuration,
    Elbow,
    Shoulder,
    SphericalWristArm,
    Wrist,
)

SPEED_MAX = 100.0  # [%] a higher program speed acts as this [assumed, val2.md 3.1]
SETTLING_TICKS = 3  # at a stop with FINE [assumed, val2.md 3.1]
SHORTEST_LINE = 1e-6  # [m] or [rad]: less is no motion at all


class Speed(NamedTuple):
    """A program speed."""

    value: float
    unit: SpeedUnit


FULL_SPEED = Speed(100.0, SpeedUnit.PERCENT)


class Planned(NamedTuple):
    """A motion ready to be appended, and the fault that ends it early, if one does."""

    interpolation: Interpolation
    pieces: list[Piece]
    goal: Configuration
    branch: ArmBranch
    speed_fraction: float
    deviation_m: float
    crossed_wrist: bool
    fault: RuntimeFault | None


class Planner:
    """Where the arm will be when all motions given so far are done, and the settings in force."""

    def __init__(self, arm: SphericalWristArm, configuration: Configuration, X_FT: Pose) -> None:
        """Start at rest."""
        self.arm = arm
        self.configuration = configuration  # at the end of the last motion
        self.branch = branch_of(arm, configuration, INITIAL_BRANCH)
        self.request = NOTHING_REQUESTED
        self.tool = X_FT  # X_FT
        self.base: Pose = IDENTITY  # X_VB
        self.speed = FULL_SPEED  # permanent
        self.next_speed: Speed | None = None
        self.tool_at_dest = forward(arm, configuration) @ X_FT  # X_BT at the destination
        self.dest: Configuration = configuration
        self.motion_end = 0.0  # end of the path of the last motion [s]
        self.settled_at = 0.0  # the arm has come to rest there [s]
        self.pieces: list[ArmPiece] = []
        self.motions: list[Motion] = []

    def copy(self) -> "Planner":
        """Return an independent planner that shares the past."""
        other = Planner.__new__(Planner)
        other.__dict__.update(self.__dict__)
        other.pieces = self.pieces.copy()
        other.motions = self.motions.copy()
        return other

    # --- settings -----------------------------------------------------------------------------

    def reset_settings(self) -> None:
        """Return to the permanent settings of a fresh execution cycle."""
        self.speed = FULL_SPEED
        self.next_speed = None

    def ask(self, branch: BranchRequest) -> None:
        """Remember a requested branch until a joint-interpolated motion carries it out."""
        match branch:
            case BranchRequest.RIGHTY:
                self.request = self.request._replace(shoulder=Shoulder.RIGHTY)
            case BranchRequest.LEFTY:
                self.request = self.request._replace(shoulder=Shoulder.LEFTY)
            case BranchRequest.ABOVE:
                self.request = self.request._replace(elbow=Elbow.ABOVE)
            case BranchRequest.BELOW:
                self.request = self.request._replace(elbow=Elbow.BELOW)
            case BranchRequest.FLIP:
                self.request = self.request._replace(wrist=Wrist.FLIP)
            case BranchRequest.NOFLIP:
                self.request = self.request._replace(wrist=Wrist.NOFLIP)

    def set_tool(self, X_FT: Pose) -> None:
        """Change the tool; the destination becomes where the new tool is."""
        self.tool = X_FT
        self.tool_at_dest = forward(self.arm, self.dest) @ X_FT

    def take_speed(self) -> Speed:
        """Return the speed of the motion now planned; a one-motion speed is used up."""
        speed = self.next_speed or self.speed
        self.next_speed = None
        return speed

    # --- locations ----------------------------------------------------------------------------

    def pose_of(self, q: Configuration) -> Pose:
        """Return the tool's location as a program sees it."""
        return self.base @ forward(self.arm, q) @ self.tool

    @property
    def destination(self) -> Pose:
        """DEST: where the last motion goes, as a program sees it."""
        return self.base @ self.tool_at_dest

    def configuration_at(self, time_s: float) -> Configuration:
        """Return the joints on the motions planned, at a time not before the last one's start."""
        for piece in reversed(self.pieces):
            if piece.start_s <= time_s:
                t = min(time_s, piece.end_s) - piece.start_s
                return tuple(value(row, t) for row in piece.rows)  # type: ignore[return-value]
        return self.motions[0].start if self.motions else self.configuration

    # --- motions ------------------------------------------------------------------------------

    def plan_joints(self, goal: Joints, fraction: float, span: Span | None) -> Planned:
        """Plan a joint-interpolated motion to a configuration.

        Raises:
            RuntimeFault: A joint is outside its limits.
        """
        violations = limit_violations(self.arm, goal)
        if violations:
            raise limit_fault(violations[0], span, "the location")
        branch = branch_of(self.arm, goal, self.branch)
        return self._joint_motion(goal, branch, fraction)

    def plan_pose(self, target: Pose, fraction: float, span: Span | None) -> Planned:
        """Plan a joint-interpolated motion of the tool to a location of the program.

        Raises:
            RuntimeFault: It is out of reach, or outside the joint limits on the arm branch.
        """
        X_BF = self.base.inverse() @ target @ self.tool.inverse()
        found = choose(self.arm, X_BF, self.branch, self.configuration, self.request)
        if isinstance(found, OutOfReach):
            raise reach_fault(found.kind, found.excess_m, span, "the location")
        if isinstance(found, OutOfLimits):
            raise limit_fault(found.violations[0], span, "the location", found.elsewhere)
        planned = self._joint_motion(found.configuration, found.branch, fraction)
        self.request = NOTHING_REQUESTED
        return planned

    def plan_line(self, target: Pose, speed: Speed, span: Span | None) -> Planned:
        """Plan a straight line of the tool to a location of the program.

        Raises:
            RuntimeFault: It cannot be started; what ends it on the way is in `fault`.
        """
        arm = self.arm
        self._refuse_line(span)
        start = forward(arm, self.configuration) @ self.tool
        line = Line(start, self.base.inverse() @ target, self.tool)
        fraction = speed_fraction(arm, speed)
        linear, angular = arm.linear_speed * fraction, arm.angular_speed * fraction
        scaling = line_profile(arm, line, linear, angular)
        course = follow(arm, line, self.configuration, self.branch, scaling)
        fault = None
        if course.obstacle is not None:
            fault = obstacle_fault(course.obstacle, line, span)
            course = self._shortened(line, course.obstacle, linear, angular)
        branch = branch_of(arm, course.goal, self.branch)
        return Planned(
            Interpolation.LINEAR,
            course.pieces,
            course.goal,
            branch,
            fraction,
            course.deviation_m,
            course.crossed_wrist,
            fault,
        )

    def append(self, planned: Planned, start_s: float, target: Pose | None, cause: Cause) -> int:
        """Put a planned motion on the timeline; return its number."""
        number = len(self.motions)
        end = start_s + (planned.pieces[-1][1] if planned.pieces else 0.0)
        tick = self.arm.tick
        end = round(end / tick) * tick
        for a, b, rows in planned.pieces:
            stop = end if b == planned.pieces[-1][1] else start_s + b
            self.pieces.append(ArmPiece(start_s + a, stop, rows, number))
        X_BT = forward(self.arm, planned.goal) @ self.tool
        self.motions.append(
            Motion(
                planned.interpolation,
                start_s,
                end,
                self.configuration,
                planned.goal,
                X_BT,
                self.tool,
                planned.speed_fraction,
                planned.deviation_m,
                cause,
            )
        )
        self.configuration = self.dest = planned.goal
        self.branch = planned.branch
        self.tool_at_dest = X_BT if target is None else self.base.inverse() @ target
        self.motion_end = end
        self.settled_at = end + SETTLING_TICKS * tick
        return number

    def hold(self, start_s: float, seconds: float) -> None:
        """Stand still for a time, as DELAY does: a motion to nowhere."""
        ticks = math.ceil(max(seconds, 0.0) / self.arm.tick - TICK_TOLERANCE)
        self.motion_end = self.settled_at = start_s + ticks * self.arm.tick

    def _joint_motion(self, goal: Configuration, branch: ArmBranch, fraction: float) -> Planned:
        pieces: list[Piece] = []
        if max(abs(b - a) for a, b in zip(self.configuration, goal, strict=True)) > 0.0:
            scaling = joint_profile(self.arm, self.configuration, goal, fraction)
            pieces = joint_pieces(self.configuration, goal, scaling)
        return Planned(
            Interpolation.JOINT,
            pieces,
            goal,
            branch,
            fraction,
            0.0,
            crossed_wrist=False,
            fault=None,
        )

    def _shortened(self, line: Line, obstacle: Obstacle, linear: float, angular: float) -> Course:
        """Return the line from rest to rest up to the last set point before an obstacle."""
        u = obstacle.u
        while u > SHORTEST_LINE:
            end = tool_at(line, turning(line.X_BT0.rotation, line.X_BT1.rotation), u)
            shorter = Line(line.X_BT0, end, line.X_FT)
            scaling = line_profile(self.arm, shorter, linear, angular)
            course = follow(self.arm, shorter, self.configuration, self.branch, scaling)
            if course.obstacle is None:
                return course
            u *= 0.5
        return Course([], self.configuration, 0.0, 0.0, crossed_wrist=False, obstacle=None)

    def _refuse_line(self, span: Span | None) -> None:
        present, wanted = self.branch, self.request
        changes = [
            word.value.upper()
            for word, now in ((wanted.shoulder, present.shoulder), (wanted.elbow, present.elbow))
            if word is not None and word is not now
        ]
        if wanted.wrist is not None and wanted.wrist is not present.wrist:
            changes.append(wanted.wrist.value.upper())
        if changes:
            raise RuntimeFault(
                RuntimeErrorKind.CANNOT_ALTER_CONFIGURATION,
                f"a straight line cannot change the arm branch to {' '.join(changes)}",
                span,
                help=("use MOVE or APPRO for the motion that changes the branch",),
            )
        where = singular_at(self.arm, self.configuration)
        if where in ("shoulder", "elbow"):
            stretched = "straight up" if where == "shoulder" else "out"
            raise RuntimeFault(
                RuntimeErrorKind.ILLEGAL_MOTION_FROM_HERE,
                f"no straight line can start from here: the arm is stretched {stretched}",
                span,
                notes=(f"the {where} is singular here, as it is at READY",),
                help=("begin with MOVE",),
            )


def speed_fraction(arm: SphericalWristArm, speed: Speed) -> float:
    """Return a program speed as a share of full speed, at most that of SPEED_MAX."""
    match speed.unit:
        case SpeedUnit.PERCENT:
            percent = speed.value
        case SpeedUnit.MM_PER_S:
            percent = 100.0 * speed.value * MM / arm.linear_speed
        case SpeedUnit.INCH_PER_S:
            percent = 100.0 * speed.value * INCH / arm.linear_speed
    return min(percent, SPEED_MAX) / 100.0


def backed_off(target: Pose, distance_mm: float) -> Pose:
    """Return the location a distance back along the tool's z axis."""
    return target @ translation(0.0, 0.0, -distance_mm * MM)


def reach_fault(kind: str, excess_m: float, span: Span | None, what: str) -> RuntimeFault:
    """Return the fault of a location that no arm branch reaches."""
    far = kind == "too far"
    return RuntimeFault(
        RuntimeErrorKind.TOO_FAR if far else RuntimeErrorKind.TOO_CLOSE,
        f"{what} is {mm(excess_m):.0f} mm {'beyond reach' if far else 'too close to the robot'}",
        span,
        label=kind,
        help=("`vrts point SCENE X Y Z --down` tells what the arm reaches; lengths are in mm",),
        data={"excess_mm": mm(excess_m)},
    )


def limit_fault(
    violation: tuple[int, float, float, float],
    span: Span | None,
    what: str,
    elsewhere: tuple[ArmBranch, ...] = (),
) -> RuntimeFault:
    """Return the fault of a joint outside its limits."""
    joint, value, lower, upper = violation
    notes = tuple(
        f"the arm branch {' '.join(part.value.upper() for part in branch)} is within the limits"
        for branch in elsewhere[:1]
    )
    return RuntimeFault(
        RuntimeErrorKind.JOINT_OUT_OF_RANGE,
        f"joint {joint} would be at {deg(value):.1f} degrees for {what};"
        f" its limits are {deg(lower):.0f} and {deg(upper):.0f}",
        span,
        joint=joint,
        notes=notes,
        data={"joint": joint, "value_deg": deg(value)},
    )


def obstacle_fault(obstacle: Obstacle, line: Line, span: Span | None) -> RuntimeFault:
    """Return the fault that stops a straight line on its way."""
    after = f"after {mm(line.length) * obstacle.u:.0f} of {mm(line.length):.0f} mm"
    joint, value, lower, upper = obstacle.detail
    if obstacle.kind in ("too far", "too close"):
        return reach_fault(obstacle.kind, value, span, f"the straight line, {after},")
    if obstacle.kind == "limit":
        return limit_fault((joint, value, lower, upper), span, f"the straight line {after}")
    return RuntimeFault(
        RuntimeErrorKind.ILLEGAL_MOTION_FROM_HERE,
        f"the straight line meets a singularity {after}: joint {joint} would have to turn at"
        f" {value / DEG:.0f} degrees/s; its limit is {upper / DEG:.0f}",
        span,
        rule=SINGULAR_JUMP,
        help=("go round the singularity, or use MOVE instead of MOVES",),
        joint=joint,
        data={"joint": joint, "needed_deg_s": value / DEG},
    )
