"""Motions that were not typed: checked as the controller will, then given as one instruction."""

import math
from typing import NamedTuple

from vrts.base.oat import components, pose_from_components, rotation_from_oat
from vrts.base.pose import (
    X_AXIS,
    Y_AXIS,
    Z_AXIS,
    Pose,
    Vector,
    multiply,
    rotation_about,
    translation,
)
from vrts.base.source import SourceFile
from vrts.base.units import deg
from vrts.engine.motion.lines.path import LinePath
from vrts.engine.motion.plan import Planned, from_rest
from vrts.engine.motion.requests import Stance, to_joints, to_line, to_pose
from vrts.engine.motion.settings import Settings
from vrts.ir.commands import Do
from vrts.ir.module import Module
from vrts.lang.compiler import compile_source
from vrts.monitor.desk import ALONE
from vrts.robots.kinematics.branch import has_branches
from vrts.robots.kinematics.kinematics import limit_violations, solve
from vrts.robots.model import Configuration

JOG_LENGTH = 1.0  # [m] farthest that one press of a key goes
JOG_TURN = math.radians(170.0)  # [rad] the same about an axis
_LOOK_M, _LOOK_RAD = 10e-3, math.radians(2.0)  # between looks at how far a key can go
_JUMP = 0.35  # [rad] between looks at which a joint turns too fast to go on: a singularity
_MARGIN = 1e-5  # [rad] before a limit
_SHORTER = 0.98  # of a line that a singularity cuts
_AXES: tuple[Vector, ...] = (X_AXIS, Y_AXIS, Z_AXIS)


class Instruction(NamedTuple):
    """What is to be carried out, and where it leads."""

    lines: tuple[str, ...]
    planned: Planned  # from rest, at full speed

    @property
    def command(self) -> Do:
        """Return the command for the controller."""
        return instructed(*self.lines)


def instructed(*lines: str) -> Do:
    """Return the command that carries out instructions, which are sound."""
    text = "\n".join((f".PROGRAM {ALONE}", *lines, ".END", ""))
    module = compile_source(SourceFile("pendant", text)).module
    assert module is not None
    return Do(Module({ALONE: module.programs[ALONE]}, ()))


def go(stance: Stance, X_BT: Pose, *, straight: bool, speed: float = 100.0) -> Instruction:
    """Return the motion of the tool to a pose in the base frame.

    Raises:
        RuntimeFault: It cannot go there, or not along a line.
    """
    X_VT = pose_from_components(*(_written(n) for n in components(stance.X_VB @ X_BT)))  # type: ignore[arg-type]
    ask = to_line if straight else to_pose
    planned = from_rest(stance.arm, stance.X_FT, ask(stance, X_VT, Settings(), speed / 100.0, None))
    if planned.fault is not None:
        raise planned.fault
    numbers = ",".join(f"{number:.4f}" for number in components(X_VT))
    words = f"{'MOVES' if straight else 'MOVE'} TRANS({numbers})"
    return Instruction((words,) if speed == 100.0 else (f"SPEED {speed:g}", words), planned)


def pose_of(position_m: tuple[float, float, float], oat_rad: tuple[float, float, float]) -> Pose:
    """Return the pose that a pointer shows."""
    o, a, t = (deg(angle) for angle in oat_rad)
    return Pose(rotation_from_oat(o, a, t), position_m)


def turn_joint(stance: Stance, joint: int, by: float, speed: float = 100.0) -> Instruction:
    """Return the motion of one joint, numbered from 0, by an angle [rad].

    Raises:
        RuntimeFault: It would leave its limits.
    """
    q = list(stance.configuration)
    q[joint] += by
    intent = to_joints(stance, _six(q), Settings(), 1.0, None)
    planned = from_rest(stance.arm, stance.X_FT, intent)
    return Instruction((f"DRIVE {joint + 1},{deg(by):.6f},{speed:g}",), planned)


def displaced(stance: Stance, frame: str, axis: int, by: float) -> Pose:
    """Return X_BT after a shift along, or a turn about, an axis of the world or of the tool.

    Args:
        stance: Where the tool is.
        frame: "world" or "tool".
        axis: 0 to 2: along X, Y, Z; 3 to 5: about them, through the tool's point.
        by: How far [m] or [rad].
    """
    X_BT = stance.X_BT
    if axis < 3:
        shift = [0.0, 0.0, 0.0]
        shift[axis] = by
        if frame == "tool":
            return X_BT @ translation(*shift)
        return Pose(X_BT.rotation, (translation(*shift) @ X_BT).translation)
    turn = rotation_about(_AXES[axis - 3], by)
    if frame == "tool":
        return X_BT @ Pose(turn, (0.0, 0.0, 0.0))
    return Pose(multiply(turn, X_BT.rotation), X_BT.translation)


def farthest(stance: Stance, frame: str, axis: int, way: int, speed: float) -> Instruction | None:
    """Return the motion as far as a held key may lead; None when there is no way at all.

    Args:
        stance: Where the arm is, at rest.
        frame: "joint", "world" or "tool".
        axis: From 0.
        way: 1 or -1.
        speed: Share of the pendant's full speed.

    Raises:
        RuntimeFault: A line cannot begin here.
    """
    percent = stance.model.pace.pendant_percent * speed
    if frame == "joint":
        arm, q = stance.arm, stance.configuration
        end = arm.upper[axis] - _MARGIN if way > 0 else arm.lower[axis] + _MARGIN
        if (end - q[axis]) * way <= 0.0:
            return None
        return turn_joint(stance, axis, end - q[axis], percent)
    step = _LOOK_M if axis < 3 else _LOOK_RAD
    looks = _looks(stance, frame, axis, way * step, int((JOG_LENGTH, JOG_TURN)[axis >= 3] / step))
    if looks == 0:
        X_BT = displaced(stance, frame, axis, way * 0.1 * step)
        return go(stance, X_BT, straight=True, speed=percent)  # or the fault that says why not
    X_BT1 = displaced(stance, frame, axis, way * step * looks)
    intent = to_line(stance, stance.X_VB @ X_BT1, Settings(), percent / 100.0, None)
    planned = from_rest(stance.arm, stance.X_FT, intent)
    if planned.fault is None or not isinstance(planned.path, LinePath):
        return go(stance, X_BT1, straight=True, speed=percent)
    return go(stance, planned.path.pose(_SHORTER), straight=True, speed=percent)


def _looks(stance: Stance, frame: str, axis: int, step: float, most: int) -> int:
    """Return how many steps along a line can be followed."""
    arm, near = stance.arm, stance.configuration
    X_TF = stance.X_FT.inverse()
    for number in range(1, most + 1):
        X_BF = displaced(stance, frame, axis, number * step) @ X_TF
        q = solve(arm, X_BF, stance.branch, near)
        if q is None or limit_violations(arm, q):
            return number - 1
        if max(abs(a - b) for a, b in zip(q, near, strict=True)) > _JUMP:
            return number - 1
        near = q
    return most


def branch_words(stance: Stance, planned: Planned) -> tuple[str, ...]:
    """Return the words of the arm branch at the end of a motion; none for arms without."""
    return tuple(word.value for word in planned.branch) if has_branches(stance.arm) else ()


def _written(number: float) -> float:
    """Return a number as instructions write it."""
    return round(number, 4) + 0.0


def _six(q: list[float]) -> Configuration:
    return (q[0], q[1], q[2], q[3], q[4], q[5])
