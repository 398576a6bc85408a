"""What is asked of the arm: a motion to joints, to a location, or along a line, and its refusals.

Frames as in `planner`: X_VT is a location of a program, X_BT the same in the robot's base frame.
"""

import math
from dataclasses import replace
from functools import lru_cache
from typing import NamedTuple

from vrts.base.pose import Pose, translation
from vrts.base.source import Span
from vrts.base.units import MM
from vrts.controllers.model import ControllerModel, WristChoice
from vrts.engine.faults import RuntimeFault
from vrts.engine.motion.faults import limit_fault, reach_fault
from vrts.engine.motion.lines.path import line
from vrts.engine.motion.lines.reach import end_out_of_reach
from vrts.engine.motion.plan import Intent, joint_intent, line_intent
from vrts.engine.motion.settings import Settings
from vrts.ir.instructions import BranchRequest
from vrts.ir.runtime_errors import RuntimeErrorKind
from vrts.robots.kinematics.branch import branch_of
from vrts.robots.kinematics.choice import OutOfLimits, OutOfReach, Request, choose
from vrts.robots.kinematics.kinematics import forward, limit_violations
from vrts.robots.kinematics.limits import TIE
from vrts.robots.kinematics.singular import singular_at
from vrts.robots.model import Arm, ArmBranch, Configuration, Elbow, Shoulder, Wrist


class Stance(NamedTuple):
    """From where a motion is asked for."""

    arm: Arm
    configuration: Configuration
    branch: ArmBranch
    request: Request  # arm branch that was asked for and not yet carried out
    X_VB: Pose  # displacement of the robot, BASE
    X_FT: Pose
    model: ControllerModel

    @property
    def X_BT(self) -> Pose:
        """The tool in the robot's base frame."""
        return forward(self.arm, self.configuration) @ self.X_FT


def to_joints(
    stance: Stance, goal: Configuration, settings: Settings, fraction: float, span: Span | None
) -> Intent:
    """Return a joint-interpolated motion to a configuration.

    Raises:
        RuntimeFault: A joint is outside its limits.
    """
    violations = limit_violations(stance.arm, goal)
    if violations:
        raise limit_fault(violations[0], span, "the location")
    branches = (stance.branch, branch_of(stance.arm, goal, stance.branch, stance.model.branches))
    start = stance.configuration
    return joint_intent(stance.arm, start, goal, branches, settings, fraction, stance.model)


def to_pose(
    stance: Stance, X_VT: Pose, settings: Settings, fraction: float, span: Span | None
) -> Intent:
    """Return a joint-interpolated motion of the tool to a location of the program.

    Raises:
        RuntimeFault: It is out of reach, or outside the joint limits on the arm branch.
    """
    arm = stance.arm if settings.multiple else half_turns(stance.arm)
    X_BF = stance.X_VB.inverse() @ X_VT @ stance.X_FT.inverse()
    keeps = stance.model.branches.wrist is WristChoice.KEPT
    start, request = stance.configuration, stance.request
    found = choose(arm, X_BF, stance.branch, start, request, keep_wrist=keeps)
    if isinstance(found, OutOfReach):
        raise reach_fault(found.kind, found.excess_m, span, "the location")
    if isinstance(found, OutOfLimits):
        raise limit_fault(found.violations[0], span, "the location", found.elsewhere)
    branches = (stance.branch, found.branch)
    goal = found.configuration
    return joint_intent(stance.arm, start, goal, branches, settings, fraction, stance.model)


def to_line(
    stance: Stance, X_VT: Pose, settings: Settings, fraction: float, span: Span | None
) -> Intent:
    """Return a straight line of the tool to a location of the program.

    What stops it on the way is found when it is planned: the arm goes as far as it can.

    Raises:
        RuntimeFault: It cannot be started, or its end is out of reach.
    """
    _refuse_line(stance, span)
    path = line(stance.X_BT, stance.X_VB.inverse() @ X_VT, stance.model.lines.turn)
    origin = (stance.configuration, stance.branch)
    error = end_out_of_reach(stance.arm, path, stance.X_FT, origin)
    if error is not None:
        raise reach_fault(*error, span, "the end of the straight line")
    return line_intent(stance.arm, path, origin, settings, fraction, stance.model, span)


def needs_branch_of(stance: Stance, joints: Configuration, span: Span | None) -> None:
    """Check that a straight line can end in a configuration.

    Raises:
        RuntimeFault: It lies on another arm branch.
    """
    present = stance.branch
    wanted = branch_of(stance.arm, joints, present, stance.model.branches)
    if wanted[:2] != present[:2]:
        raise _cannot_change([word.value.upper() for word in wanted[:2]], span)


def with_request(request: Request, branch: BranchRequest) -> Request:
    """Return the requested arm branch with one more word of it."""
    match branch:
        case BranchRequest.RIGHTY:
            return request._replace(shoulder=Shoulder.RIGHTY)
        case BranchRequest.LEFTY:
            return request._replace(shoulder=Shoulder.LEFTY)
        case BranchRequest.ABOVE:
            return request._replace(elbow=Elbow.ABOVE)
        case BranchRequest.BELOW:
            return request._replace(elbow=Elbow.BELOW)
        case BranchRequest.FLIP:
            return request._replace(wrist=Wrist.FLIP)
        case BranchRequest.NOFLIP:
            return request._replace(wrist=Wrist.NOFLIP)


def backed_off(target: Pose, distance_mm: float) -> Pose:
    """Return the location a distance back along the tool's z axis."""
    return target @ translation(0.0, 0.0, -distance_mm * MM)


@lru_cache(maxsize=8)
def half_turns(arm: Arm) -> Arm:
    """Return an arm whose joints 4 and 6 stay within half a turn, as SINGLE asks."""
    lower, upper = list(arm.lower), list(arm.upper)
    for k in (3, 5):
        half = math.pi + TIE  # a joint at half a turn stays there, whatever the last digit says
        lower[k], upper[k] = max(lower[k], -half), min(upper[k], half)
    return replace(arm, lower=tuple(lower), upper=tuple(upper))


def _cannot_change(branch: list[str], span: Span | None) -> RuntimeFault:
    return RuntimeFault(
        RuntimeErrorKind.CANNOT_ALTER_CONFIGURATION,
        f"a straight line cannot change the arm branch to {' '.join(branch)}",
        span,
        help=("use MOVE or APPRO for the motion that changes the branch",),
    )


def _refuse_line(stance: Stance, span: Span | None) -> None:
    present, wanted = stance.branch, stance.request
    changes = [
        word.value.upper()
        for word, now in ((wanted.shoulder, present.shoulder), (wanted.elbow, present.elbow))
        if word is not None and word is not now
    ]
    if wanted.wrist is not None and wanted.wrist is not present.wrist:
        changes.append(wanted.wrist.value.upper())
    if changes:
        raise _cannot_change(changes, span)
    where = singular_at(stance.arm, stance.configuration)
    if where in ("shoulder", "elbow"):
        stretched = "straight up" if where == "shoulder" else "out"
        raise RuntimeFault(
            RuntimeErrorKind.ILLEGAL_MOTION_FROM_HERE,
            f"no straight line can start from here: the arm is stretched {stretched}",
            span,
            notes=(f"the {where} is singular here, as it is at READY",),
            help=("begin with MOVE",),
        )
