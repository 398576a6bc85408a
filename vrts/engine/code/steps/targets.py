"""Where instructions that move the arm send it, as closures: evaluated when they are reached."""

import math
from collections.abc import Callable
from typing import NamedTuple

from vrts.base.numbers import round_half_away
from vrts.base.oat import oat_from_rotation, rotation_from_oat
from vrts.base.pose import (
    X_AXIS,
    Y_AXIS,
    Z_AXIS,
    Pose,
    Vector,
    add,
    cross,
    dot,
    multiply,
    rotation_about,
    scale,
)
from vrts.base.source import Span
from vrts.base.units import DEG, MM
from vrts.controllers.model import AlignTurn
from vrts.engine.code.values.compiler import Compiler
from vrts.engine.code.values.operands import span_of
from vrts.engine.faults import RuntimeFault
from vrts.engine.memory.events import Cause
from vrts.engine.motion.requests import backed_off, needs_branch_of
from vrts.engine.motion.settings import Settings, Speed
from vrts.engine.programs.context import Context
from vrts.ir import instructions as ir
from vrts.ir.runtime_errors import RuntimeErrorKind
from vrts.robots.kinematics.limits import TIE
from vrts.robots.model import Configuration

WORLD_AXES = tuple(scale(axis, sign) for axis in (X_AXIS, Y_AXIS, Z_AXIS) for sign in (1.0, -1.0))


class Target(NamedTuple):
    """Where a motion shall go, as evaluated when the instruction was reached."""

    interpolation: ir.Interpolation
    pose: Pose | None  # X_VT
    joints: Configuration | None
    settings: Settings
    fraction: float
    span: Span
    opening: float | None = None  # of MOVET: above 0 opens, else closes
    drive: tuple[int, float] | None = None  # of DRIVE: index of the joint, change [rad]


MotionInstruction = ir.Move | ir.Depart | ir.Drive | ir.Draw | ir.Align | ir.Ready | ir.Nest


class TargetCompiler:
    """Compiles what motion instructions say of where to go, and how fast."""

    def __init__(self, expressions: Compiler) -> None:
        """Share the compiler of expressions."""
        self.expressions = expressions

    def target(self, instruction: MotionInstruction, cause: Cause) -> Callable[[Context], Target]:
        """Return what evaluates where an instruction goes; it takes the settings of one motion."""
        match instruction:
            case ir.Move():
                return self._move(instruction, cause)
            case ir.Depart(interpolation=interpolation, distance=distance):
                away = self.expressions.real(distance)
                return lambda c: _to_pose(
                    c, interpolation, backed_off(c.planner.destination, away(c)), cause.span
                )
            case ir.Drive():
                return self._drive(instruction, cause)
            case ir.Draw():
                return self._draw(instruction, cause)
            case ir.Align():
                return lambda c: _to_pose(
                    c,
                    ir.Interpolation.JOINT,
                    aligned(c.planner.destination, c.planner.model.lines.align),
                    cause.span,
                )
            case ir.Ready():
                return lambda c: _to_joints(c, c.planner.arm.ready, cause.span)
            case ir.Nest():

                def nest(c: Context) -> Target:
                    ready = c.planner.arm.ready
                    joints = [
                        c.system.parameter(f"NEST.POS[{k + 1}]", q / DEG) * DEG
                        for k, q in enumerate(ready)
                    ]
                    return _to_joints(c, tuple(joints), cause.span)  # type: ignore[arg-type]

                return nest

    def _move(self, move: ir.Move, cause: Cause) -> Callable[[Context], Target]:
        e, interpolation = self.expressions, move.interpolation
        location = e.location(move.target)
        back = e.real(move.retreat) if move.retreat is not None else None
        opening = e.real(move.opening) if move.opening is not None else None
        span = span_of(move.target) or cause.span

        def target(c: Context) -> Target:
            goal = location(c)
            joints = None if isinstance(goal, Pose) else goal
            if joints is not None and back is None and interpolation is ir.Interpolation.JOINT:
                found = _to_joints(c, joints, span)  # type: ignore[arg-type]
            else:
                pose = goal if isinstance(goal, Pose) else c.planner.pose_of(joints)  # type: ignore[arg-type]
                if joints is not None and interpolation is ir.Interpolation.LINEAR and back is None:
                    needs_branch_of(c.planner.stance, joints, span)  # type: ignore[arg-type]
                if back is not None:
                    pose = backed_off(pose, back(c))
                found = _to_pose(c, interpolation, pose, span)
            return found if opening is None else found._replace(opening=opening(c))

        return target

    def _drive(self, drive: ir.Drive, cause: Cause) -> Callable[[Context], Target]:
        e = self.expressions
        which, by = e.real(drive.joint), e.real(drive.change)
        own = e.real(drive.speed) if drive.speed is not None else None

        def target(c: Context) -> Target:
            k = round_half_away(which(c))
            if not 1 <= k <= 6:
                raise RuntimeFault(
                    RuntimeErrorKind.ILLEGAL_JOINT,
                    f"there is no joint {k}; joints are 1 to 6",
                    cause.span,
                )
            change = by(c) * DEG
            percent = own(c) if own is not None else 100.0
            speed = positive(Speed(percent, ir.SpeedUnit.PERCENT), cause.span)
            keeps = not c.planner.model.next_motion.drive_uses_speed
            settings = c.planner.take_settings(but_speed=keeps)
            fraction = speed.fraction(c.planner.arm, speed_max(c))
            return Target(
                ir.Interpolation.JOINT,
                None,
                None,
                settings,
                fraction,
                cause.span,
                drive=(k - 1, change),
            )

        return target

    def _draw(self, draw: ir.Draw, cause: Cause) -> Callable[[Context], Target]:
        e = self.expressions
        operands = tuple(e.real(o) if o is not None else None for o in draw.offsets)
        own = e.real(draw.speed) if draw.speed is not None else None

        def target(c: Context) -> Target:
            values = [0.0 if o is None else o(c) for o in operands]
            values += [0.0] * (6 - len(values))
            shift: Vector = (values[0] * MM, values[1] * MM, values[2] * MM)
            turn = multiply(
                rotation_about(X_AXIS, values[3] * DEG),
                multiply(
                    rotation_about(Y_AXIS, values[4] * DEG),
                    rotation_about(Z_AXIS, values[5] * DEG),
                ),
            )
            here = c.planner.destination
            if draw.in_tool:
                pose = here @ Pose(turn, shift)
            else:
                pose = Pose(multiply(turn, here.rotation), add(here.translation, shift))
            found = _to_pose(c, ir.Interpolation.LINEAR, pose, cause.span)
            if own is None:
                return found
            speed = positive(Speed(own(c), ir.SpeedUnit.MM_PER_S), cause.span)
            return found._replace(fraction=speed.fraction(c.planner.arm, speed_max(c)))

        return target


def aligned(pose: Pose, way: AlignTurn) -> Pose:
    """Return a pose turned about its origin until z is parallel to the nearest world axis.

    The turn is the smallest one, about z x axis; or, where the axis is level, the one that leaves
    VAL's angle T as it was [manual language/motion#align].
    """
    z = pose.approach
    along = [dot(axis, z) for axis in WORLD_AXES]
    nearest = max(along) - TIE  # as near: the first
    axis = next(axis for axis, share in zip(WORLD_AXES, along, strict=True) if share > nearest)
    if way is AlignTurn.KEEPS_T and axis[2] == 0.0:
        o = math.atan2(axis[0], -axis[1]) / DEG
        _, _, t = oat_from_rotation(pose.rotation)
        return Pose(rotation_from_oat(o, 0.0, t), pose.translation)
    normal = cross(z, axis)
    sine = math.sqrt(dot(normal, normal))
    if sine < 1e-12:
        return pose
    angle = math.atan2(sine, dot(z, axis))
    turn = rotation_about(scale(normal, 1.0 / sine), angle)
    return Pose(multiply(turn, pose.rotation), pose.translation)


def positive(speed: Speed, span: Span | None) -> Speed:
    """Return a speed that is above zero.

    Raises:
        RuntimeFault: It is not.
    """
    if speed.value <= 0.0:
        raise RuntimeFault(RuntimeErrorKind.ILLEGAL_VALUE, "a speed must be above zero", span)
    return speed


def speed_max(c: Context) -> float:
    """Return the parameter SPEED.MAX [%]."""
    return c.system.parameter("SPEED.MAX", c.planner.model.pace.most_speed_percent)


def _to_pose(c: Context, interpolation: ir.Interpolation, pose: Pose, span: Span) -> Target:
    settings = c.planner.take_settings()
    fraction = settings.speed.fraction(c.planner.arm, speed_max(c))
    return Target(interpolation, pose, None, settings, fraction, span)


def _to_joints(c: Context, joints: Configuration, span: Span) -> Target:
    settings = c.planner.take_settings()
    fraction = settings.speed.fraction(c.planner.arm, speed_max(c))
    return Target(ir.Interpolation.JOINT, None, joints, settings, fraction, span)
