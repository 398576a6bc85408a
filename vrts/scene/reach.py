"""Whether the robot can get somewhere, in which ways, and what is near."""

import math
from itertools import product
from typing import NamedTuple

from vrts.base.pose import Pose
from vrts.base.units import mm
from vrts.robots.kinematics.branch import has_branches
from vrts.robots.kinematics.kinematics import reach_error, solve
from vrts.robots.model import ArmBranch, Configuration, Elbow, Robot, Shoulder, Wrist
from vrts.scene.clearance import Nearness, nearest_body, placed_robot
from vrts.scene.model import Scene

USUAL = ArmBranch(Shoulder.LEFTY, Elbow.ABOVE, Wrist.NOFLIP)  # a run starts so [assumed]


class Margin(NamedTuple):
    """How far the joint that is nearest to a limit is from it."""

    joint: int  # from 1
    amount: float  # [rad]; negative is beyond the limit
    upper: bool  # the upper limit, not the lower


class BranchReach(NamedTuple):
    """One way to reach a pose."""

    branch: ArmBranch
    configuration: Configuration  # [rad]
    margin: Margin

    @property
    def within_limits(self) -> bool:
        """Whether every joint is within its limits."""
        return self.margin.amount >= 0.0


class Reach(NamedTuple):
    """The answer of `reach`."""

    X_WF: Pose  # of the flange
    branches: tuple[BranchReach, ...]  # every arm branch, the usual one first; empty: out of reach
    error: tuple[str, float] | None  # ("too far" or "too close", by how much [m])
    nearest: Nearness | None  # with the hand open, on `best`; None: unreachable or no body

    @property
    def best(self) -> BranchReach | None:
        """The first branch within limits: the usual one where it is possible."""
        return next((way for way in self.branches if way.within_limits), None)

    @property
    def reachable(self) -> bool:
        """Whether the pose is within reach on some branch within the joint limits."""
        return self.best is not None


def reach(scene: Scene, X_WT: Pose) -> Reach:
    """Return whether a tool pose can be reached, on which branches, and the nearest body.

    Args:
        scene: The workspace; its TOOL is the tool, and its robot is based in W.
        X_WT: Pose of the tool; for the scene's own TOOL that is the middle between the pads.
    """
    X_WF = X_WT @ scene.X_FT.inverse()
    ways = branches(scene.robot, X_WF)
    answer = Reach(X_WF, ways, reach_error(scene.robot.arm, X_WF) if not ways else None, None)
    best = answer.best
    if best is None:
        return answer
    parts = placed_robot(scene.robot, best.configuration, scene.robot.gripper.opening_max)
    moving = tuple(part for part in parts if part.name != scene.robot.arm.links[0].name)
    return answer._replace(nearest=nearest_body(moving, scene.bodies))


def branches(robot: Robot, X_BF: Pose) -> tuple[BranchReach, ...]:
    """Return every arm branch that puts the flange at a pose, limits not enforced.

    Arms without branches have one way: the solution nearest to the ready configuration.
    """
    if not has_branches(robot.arm):
        q = solve(robot.arm, X_BF, USUAL, robot.arm.ready)
        return () if q is None else (BranchReach(USUAL, q, margin(robot, q)),)
    found: list[BranchReach] = []
    for shoulder, elbow, wrist in product(Shoulder, Elbow, Wrist):
        branch = ArmBranch(shoulder, elbow, wrist)
        configuration = solve(robot.arm, X_BF, branch, robot.arm.ready)
        if configuration is not None:
            found.append(BranchReach(branch, configuration, margin(robot, configuration)))
    return tuple(found)


def obstacle(robot: Robot, X_BF: Pose) -> str | None:
    """Return why no arm branch puts the flange at a pose, for a sentence; None where one does."""
    ways = branches(robot, X_BF)
    best = max(ways, key=lambda way: way.margin.amount, default=None)
    if best is not None:
        if best.within_limits:
            return None
        beyond = math.degrees(-best.margin.amount)
        return f"joint {best.margin.joint} would be {beyond:.0f} degrees beyond its limit"
    error = reach_error(robot.arm, X_BF)
    if error is None:
        return "out of reach"
    kind, amount = error
    what = "beyond reach" if kind == "too far" else "too close to the robot"
    return f"{mm(amount):.0f} mm {what}"


def margin(robot: Robot, q: Configuration) -> Margin:
    """Return the joint that is nearest to a limit, or farthest beyond one."""
    nearest = Margin(0, math.inf, upper=False)
    for joint, (value, lower, upper) in enumerate(
        zip(q, robot.arm.lower, robot.arm.upper, strict=True), 1
    ):
        for amount, is_upper in ((value - lower, False), (upper - value, True)):
            if amount < nearest.amount:
                nearest = Margin(joint, amount, is_upper)
    return nearest
