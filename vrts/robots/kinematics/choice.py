"""Which solution a joint-interpolated motion to a pose takes."""

from collections.abc import Collection
from typing import NamedTuple

from vrts.base.pose import Pose
from vrts.robots.kinematics.branch import ALL_BRANCHES
from vrts.robots.kinematics.kinematics import limit_violations, reach_error, solve
from vrts.robots.kinematics.limits import TIE
from vrts.robots.kinematics.serial_solutions import solutions
from vrts.robots.model import (
    Arm,
    ArmBranch,
    Configuration,
    Elbow,
    SerialArm,
    Shoulder,
    SphericalWristArm,
    Wrist,
)


class Request(NamedTuple):
    """Parts of an arm branch that the program asked for; None where it asked for nothing."""

    shoulder: Shoulder | None = None
    elbow: Elbow | None = None
    wrist: Wrist | None = None


NOTHING_REQUESTED = Request()


class Choice(NamedTuple):
    """A solution within the joint limits."""

    configuration: Configuration
    branch: ArmBranch


class OutOfReach(NamedTuple):
    """The pose is out of reach on every branch."""

    kind: str  # "too far" or "too close"
    excess_m: float


class OutOfLimits(NamedTuple):
    """The branch asked for violates joint limits."""

    branch: ArmBranch
    configuration: Configuration
    violations: tuple[tuple[int, float, float, float], ...]  # joint, position, lower, upper [rad]
    elsewhere: tuple[ArmBranch, ...]  # branches on which the pose is within limits


def choose(
    arm: Arm,
    X_BF: Pose,
    present: ArmBranch,
    near: Configuration,
    request: Request = NOTHING_REQUESTED,
    *,
    keep_wrist: bool = False,
) -> Choice | OutOfReach | OutOfLimits:
    """Return the solution that a MOVE to a pose takes.

    Shoulder and elbow are those requested, else those of the present branch. FLIP and NOFLIP bind
    only when requested; otherwise the wrist solution within limits whose largest change of joints
    4 to 6 is smaller is taken [assumed, manual robots/branches#wrist], or with `keep_wrist` the
    present one where it is within limits. Arms without branches take, of the solutions within
    limits, the one whose largest change of a joint is smallest; requests are ignored.
    """
    if isinstance(arm, SerialArm):
        return _choose_nearest(arm, X_BF, present, near)
    error = reach_error(arm, X_BF)
    if error is not None:
        return OutOfReach(*error)
    shoulder = request.shoulder or present.shoulder
    elbow = request.elbow or present.elbow
    wrists = (request.wrist,) if request.wrist else (present.wrist, _other(present.wrist))
    candidates = [
        (branch, q)
        for branch in (ArmBranch(shoulder, elbow, wrist) for wrist in wrists)
        if (q := solve(arm, X_BF, branch, near)) is not None
    ]
    within = [(branch, q) for branch, q in candidates if not limit_violations(arm, q)]
    if within:
        branch, q = within[0]
        for other in () if keep_wrist else within[1:]:  # as far: the present wrist
            if _wrist_change(other[1], near) < _wrist_change(q, near) - TIE:
                branch, q = other
        return Choice(q, branch)
    branch, q = candidates[0]
    return OutOfLimits(
        branch, q, limit_violations(arm, q), branches_within_limits(arm, X_BF, near, ALL_BRANCHES)
    )


def _choose_nearest(
    arm: SerialArm, X_BF: Pose, present: ArmBranch, near: Configuration
) -> Choice | OutOfReach | OutOfLimits:
    found = solutions(arm, X_BF, near)
    if not found:
        return OutOfReach(*(reach_error(arm, X_BF) or ("too far", 0.0)))
    violations = limit_violations(arm, found[0])
    if violations:
        return OutOfLimits(present, found[0], violations, ())
    return Choice(found[0], present)


def branches_within_limits(
    arm: SphericalWristArm,
    X_BF: Pose,
    near: Configuration,
    branches: Collection[ArmBranch] = ALL_BRANCHES,
) -> tuple[ArmBranch, ...]:
    """Return the branches on which a pose is reached within the joint limits."""
    return tuple(
        branch
        for branch in branches
        if (q := solve(arm, X_BF, branch, near)) is not None and not limit_violations(arm, q)
    )


def _wrist_change(q: Configuration, near: Configuration) -> float:
    return max(abs(q[k] - near[k]) for k in (3, 4, 5))


def _other(wrist: Wrist) -> Wrist:
    return Wrist.NOFLIP if wrist is Wrist.FLIP else Wrist.FLIP
