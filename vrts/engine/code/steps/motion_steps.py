"""Instructions that move the arm, as closures."""

import math
from collections.abc import Callable
from typing import NamedTuple

from vrts.base.numbers import round_half_away
from vrts.base.oat import pose_from_components
from vrts.base.pose import (
    IDENTITY,
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
from vrts.engine.code.closures import BLOCKED, Step, reached
from vrts.engine.code.steps.hand_steps import command_hand
from vrts.engine.code.values.compiler import Compiler
from vrts.engine.code.values.operands import span_of
from vrts.engine.faults import RuntimeFault
from vrts.engine.memory.events import Cause
from vrts.engine.memory.records import INSTANT
from vrts.engine.motion.plan import Intent
from vrts.engine.motion.requests import backed_off, needs_branch_of, to_joints, to_line, to_pose
from vrts.engine.motion.settings import Settings, Speed
from vrts.engine.programs.context import Context
from vrts.ir import instructions as ir
from vrts.ir.expressions import Expression
from vrts.ir.runtime_errors import RuntimeErrorKind
from vrts.robots.kinematics.limits import TIE
from vrts.robots.model import Configuration

# what a motion instruction that waits has come to
JOINED, WAITED, CUT_SHORT, REACHED = 1, 2, 3, 4

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


class MotionStepCompiler:
    """Compiles motions."""

    def __init__(self, expressions: Compiler) -> None:
        """Share the compiler of expressions."""
        self.expressions = expressions

    def motion(self, instruction: MotionInstruction, following: int, cause: Cause) -> Step:
        """Return the step of an instruction that moves the arm.

        It waits until the motion under way can be followed: by a rounded corner if it is known
        early enough, else when that motion has ended.
        """
        evaluate = self._target(instruction, cause)

        def move(c: Context) -> int:
            planner = c.planner
            if c.phase == CUT_SHORT:
                if not reached(c, planner.settled_at):
                    return BLOCKED
                fault, c.fault, c.phase = c.fault, None, 0
                assert fault is not None
                if _given_up(c, cause):
                    return following  # it never came to where it would have failed
                raise fault
            if c.phase == JOINED:
                pending = planner.pending
                if pending is not None:
                    start = planner.scale.time(pending.start_s)
                    if not reached(c, start):
                        return BLOCKED
                    planner.commit()
                    return begun(c, start)
                if planner.overdue:
                    planner.overdue = False
                    return begun(c, c.now)
                c.phase = REACHED  # it was taken back: a reaction came between
            if c.phase == 0:
                c.operands, c.phase = evaluate(c), REACHED
            target = c.operands
            assert isinstance(target, Target)
            if planner.free_at > c.now + INSTANT:
                if c.phase == REACHED and _joins(c, target, cause):
                    assert planner.pending is not None
                    c.phase, c.wake = JOINED, planner.scale.time(planner.pending.start_s)
                    return BLOCKED
                c.phase, c.wake = WAITED, planner.free_at
                return BLOCKED
            # a command waited for this tick already, which is the next one after it was given
            due = c.phase == WAITED or c.at_once
            ticks = 0 if due else planner.model.pace.departure_ticks
            start = c.after(ticks)
            intent = _intent(c, target)
            dry = c.system.is_on("DRY.RUN")
            c.fault = planner.begin(intent, start, target.pose, cause, dry=dry)
            if c.fault is not None:
                c.phase, c.wake = CUT_SHORT, planner.settled_at
                c.until = float(len(planner.motions) - 1)
                return BLOCKED
            return begun(c, start)

        def begun(c: Context, start: float) -> int:
            target = c.operands
            assert isinstance(target, Target)
            if target.opening is not None:
                opens = target.opening > 0.0
                action = ir.HandAction.OPEN if opens else ir.HandAction.CLOSE
                c.next_hand.append((action, cause))
            _begin_hand(c, start)
            c.phase, c.operands = 0, None
            c.hand.path_changed(c.now)
            return following

        return move

    def _target(self, instruction: MotionInstruction, cause: Cause) -> Callable[[Context], Target]:
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
                    c, ir.Interpolation.JOINT, aligned(c.planner.destination), cause.span
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

    # --- standing still -----------------------------------------------------------------------

    def delay(self, time: Expression, following: int) -> Step:
        """Return the step of DELAY: it waits its turn like a motion.

        Whether it counts as the next motion for settings and for the hand is the controller
        model's to say [manual language/motion#delay].
        """
        seconds = self.expressions.real(time)

        def delay(c: Context) -> int:
            planner, counts = c.planner, c.planner.model.next_motion
            if counts.delay_uses_settings and c.phase == 0:
                planner.take_settings()
                c.phase = WAITED
            if not reached(c, planner.free_at):
                return BLOCKED
            c.phase = 0
            planner.hold(c.now, seconds(c))
            if counts.delay_moves_hand:
                _begin_hand(c, c.now)
            return following

        return delay

    def tool(self, pose: Expression | None, following: int) -> Step:
        """Return the step of TOOL."""
        tool = self.expressions.pose(pose) if pose is not None else None

        def set_tool(c: Context) -> int:
            if not reached(c, c.planner.settled_at):
                return BLOCKED
            c.planner.set_tool(tool(c) if tool is not None else IDENTITY)
            c.system.held_tool.assign(c.planner.tool, c.finished)
            return following

        return set_tool

    def base(self, instruction: ir.SetBase | ir.SetBaseFrame, following: int) -> Step:
        """Return the step of BASE."""
        e = self.expressions
        if isinstance(instruction, ir.SetBaseFrame):
            frame = e.pose(instruction.pose)

            def base(c: Context) -> Pose:
                return frame(c).inverse()
        else:
            operands = tuple(
                e.real(operand) if operand is not None else None
                for operand in (
                    instruction.dx,
                    instruction.dy,
                    instruction.dz,
                    instruction.rotation,
                )
            )

            def base(c: Context) -> Pose:
                dx, dy, dz, turn = (0.0 if o is None else o(c) for o in operands)
                return pose_from_components(dx, dy, dz, 90.0 + turn, -90.0, 0.0)

        def set_base(c: Context) -> int:
            if not reached(c, c.planner.settled_at):
                return BLOCKED
            c.planner.base = base(c)
            c.system.held_base.assign(c.planner.base, c.finished)
            return following

        return set_base


def aligned(pose: Pose) -> Pose:
    """Return a pose turned about its origin until z is parallel to the nearest world axis.

    The turn is the smallest one, about z x axis [assumed, manual language/motion#align].
    """
    z = pose.approach
    along = [dot(axis, z) for axis in WORLD_AXES]
    nearest = max(along) - TIE  # as near: the first
    axis = next(axis for axis, share in zip(WORLD_AXES, along, strict=True) if share > nearest)
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


def _begin_hand(c: Context, start: float) -> None:
    """Begin what OPEN, CLOSE and RELAX left to the next motion."""
    for action, by in c.next_hand:
        command_hand(c, action, start, by)
    c.next_hand = []


def _to_pose(c: Context, interpolation: ir.Interpolation, pose: Pose, span: Span) -> Target:
    settings = c.planner.take_settings()
    fraction = settings.speed.fraction(c.planner.arm, speed_max(c))
    return Target(interpolation, pose, None, settings, fraction, span)


def _to_joints(c: Context, joints: Configuration, span: Span) -> Target:
    settings = c.planner.take_settings()
    fraction = settings.speed.fraction(c.planner.arm, speed_max(c))
    return Target(ir.Interpolation.JOINT, None, joints, settings, fraction, span)


def _intent(c: Context, target: Target) -> Intent:
    planner = c.planner
    if target.drive is not None:  # from where the arm will be then: other joints stand still
        joint, change = target.drive
        start = planner.dest if c.system.is_on("DRY.RUN") else planner.configuration
        goal = (*start[:joint], start[joint] + change, *start[joint + 1 :])
        intent = to_joints(planner.stance, goal, target.settings, target.fraction, target.span)  # type: ignore[arg-type]
        return intent._replace(keeps_request=True)
    if target.joints is not None:
        return to_joints(
            planner.stance, target.joints, target.settings, target.fraction, target.span
        )
    assert target.pose is not None
    if target.interpolation is ir.Interpolation.LINEAR:
        return to_line(planner.stance, target.pose, target.settings, target.fraction, target.span)
    return to_pose(planner.stance, target.pose, target.settings, target.fraction, target.span)


def _given_up(c: Context, cause: Cause) -> bool:
    """Return whether the motion of a step, whose number `until` keeps, was given up on its way."""
    motions, number = c.planner.motions, int(c.until)
    return number >= len(motions) or motions[number].cut or motions[number].cause != cause


def _joins(c: Context, target: Target, cause: Cause) -> bool:
    """Join a motion to the one under way, if it can be."""
    if not c.system.is_on("CP") or c.system.is_on("DRY.RUN"):
        return False
    try:
        intent = _intent(c, target)
    except RuntimeFault:
        return False  # it is raised again when the motion's turn comes
    if not c.planner.join(intent, c.now, target.pose, cause):
        return False
    c.hand.path_changed(c.now)
    return True
