"""Instructions that move the arm or the hand, and settings of motions, as closures."""

from collections.abc import Callable

from vrts.base.numbers import round_half_away
from vrts.base.oat import pose_from_components
from vrts.base.pose import IDENTITY, Pose
from vrts.base.source import Span
from vrts.base.units import DEG
from vrts.engine.context import Context
from vrts.engine.evaluate import Compiler
from vrts.engine.events import Cause, MotionEnded, MotionStarted
from vrts.engine.faults import RuntimeFault
from vrts.engine.outcomes import BLOCKED
from vrts.engine.planner import Planned, Speed, backed_off, speed_fraction
from vrts.engine.step import Step, place_of, reached
from vrts.ir import instructions as ir
from vrts.ir.expressions import Expression
from vrts.ir.runtime_errors import RuntimeErrorKind
from vrts.ir.values import Value
from vrts.robots.kinematics import forward


class MotionStepCompiler:
    """Compiles motions, their settings and the hand."""

    def __init__(self, expressions: Compiler) -> None:
        """Share the compiler of expressions."""
        self.expressions = expressions

    def motion(
        self, instruction: ir.Move | ir.Depart | ir.Drive | ir.Ready, following: int, cause: Cause
    ) -> Step:
        """Return the step of an instruction that moves the arm."""
        plan = self._plan(instruction, cause)

        def move(c: Context) -> int:
            planner = c.planner
            if c.phase == 2:  # the motion ended early; its fault comes when the arm stands
                if not reached(c, planner.settled_at):
                    return BLOCKED
                fault, c.fault, c.phase = c.fault, None, 0
                assert fault is not None
                raise fault
            if not reached(c, planner.motion_end):
                c.phase = 1
                return BLOCKED
            start = c.now if c.phase == 1 else c.now + planner.arm.tick
            c.phase = 0
            planned, target = plan(c)
            motion = planner.append(planned, start, target, cause)
            c.events.append(MotionStarted(start, motion, cause))
            c.events.append(MotionEnded(planner.motion_end, motion, cause))
            for action, by in c.next_hand:
                command_hand(c, action, start, by)
            c.next_hand = []
            if planned.fault is None:
                return following
            c.fault, c.phase = planned.fault, 2
            c.wake = planner.settled_at
            return BLOCKED

        return move

    def _plan(
        self, instruction: ir.Move | ir.Depart | ir.Drive | ir.Ready, cause: Cause
    ) -> Callable[[Context], tuple[Planned, Pose | None]]:
        e = self.expressions
        match instruction:
            case ir.Move(interpolation=interpolation, target=target, retreat=retreat):
                location = e.location(target)
                back = e.real(retreat) if retreat is not None else None
                place = place_of(target) or cause.span

                def plan_move(c: Context) -> tuple[Planned, Pose | None]:
                    goal = location(c)
                    if back is None and not isinstance(goal, Pose):
                        return self._to_joints(c, goal, interpolation, place)
                    pose = goal if isinstance(goal, Pose) else c.planner.pose_of(goal)  # type: ignore[arg-type]
                    if back is not None:
                        pose = backed_off(pose, back(c))
                    return self._to_pose(c, pose, interpolation, place)

                return plan_move
            case ir.Depart(interpolation=interpolation, distance=distance):
                away = e.real(distance)
                return lambda c: self._to_pose(
                    c, backed_off(c.planner.destination, away(c)), interpolation, cause.span
                )
            case ir.Drive(joint=joint, change=change, speed=speed):
                which, by = e.real(joint), e.real(change)
                own = e.real(speed) if speed is not None else None

                def plan_drive(c: Context) -> tuple[Planned, Pose | None]:
                    k = round_half_away(which(c))
                    if not 1 <= k <= 6:
                        raise RuntimeFault(
                            RuntimeErrorKind.ILLEGAL_JOINT,
                            f"there is no joint {k}; joints are 1 to 6",
                            cause.span,
                        )
                    q = list(c.planner.dest)
                    q[k - 1] += by(c) * DEG
                    percent = own(c) if own is not None else 100.0
                    fraction = _fraction(c, Speed(percent, ir.SpeedUnit.PERCENT), cause)
                    goal = (q[0], q[1], q[2], q[3], q[4], q[5])
                    return c.planner.plan_joints(goal, fraction, cause.span), None

                return plan_drive
            case ir.Ready():

                def plan_ready(c: Context) -> tuple[Planned, Pose | None]:
                    planner = c.planner
                    fraction = speed_fraction(planner.arm, planner.take_speed())
                    return planner.plan_joints(planner.arm.ready, fraction, cause.span), None

                return plan_ready

    def _to_pose(
        self, c: Context, pose: Pose, interpolation: ir.Interpolation, span: Span
    ) -> tuple[Planned, Pose | None]:
        planner = c.planner
        speed = planner.take_speed()
        if interpolation is ir.Interpolation.LINEAR:
            planned = planner.plan_line(pose, speed, span)
            return planned, None if planned.fault else pose
        return planner.plan_pose(pose, speed_fraction(planner.arm, speed), span), pose

    def _to_joints(
        self, c: Context, goal: Value, interpolation: ir.Interpolation, span: Span
    ) -> tuple[Planned, Pose | None]:
        planner = c.planner
        if interpolation is ir.Interpolation.LINEAR:
            return self._to_pose(c, planner.pose_of(goal), interpolation, span)  # type: ignore[arg-type]
        fraction = speed_fraction(planner.arm, planner.take_speed())
        return planner.plan_joints(goal, fraction, span), None  # type: ignore[arg-type]

    def delay(self, time: Callable[[Context], float], following: int) -> Step:
        """Return the step of DELAY."""

        def delay(c: Context) -> int:
            if not reached(c, c.planner.motion_end):
                return BLOCKED
            c.planner.hold(c.now, time(c))
            return following

        return delay

    def speed(self, instruction: ir.SetSpeed, following: int) -> Step:
        """Return the step of SPEED."""
        value = self.expressions.real(instruction.value)
        unit, scope, span = instruction.unit, instruction.scope, place_of(instruction.value)

        def set_speed(c: Context) -> int:
            speed = Speed(value(c), unit)
            if speed.value <= 0.0:
                raise RuntimeFault(
                    RuntimeErrorKind.ILLEGAL_VALUE, "a speed must be above zero", span
                )
            if scope is ir.Scope.ALWAYS:
                c.planner.speed = speed
            else:
                c.planner.next_speed = speed
            return following

        return set_speed

    def tool(self, pose: Expression | None, following: int) -> Step:
        """Return the step of TOOL."""
        tool = self.expressions.pose(pose) if pose is not None else None

        def set_tool(c: Context) -> int:
            if not reached(c, c.planner.settled_at):
                return BLOCKED
            c.planner.set_tool(tool(c) if tool is not None else IDENTITY)
            return following

        return set_tool

    def base(self, instruction: ir.SetBase, following: int) -> Step:
        """Return the step of BASE."""
        operands = tuple(
            self.expressions.real(operand) if operand is not None else None
            for operand in (instruction.dx, instruction.dy, instruction.dz, instruction.rotation)
        )

        def set_base(c: Context) -> int:
            if not reached(c, c.planner.settled_at):
                return BLOCKED
            dx, dy, dz, turn = (0.0 if o is None else o(c) for o in operands)
            c.planner.base = pose_from_components(dx, dy, dz, 90.0 + turn, -90.0, 0.0)
            return following

        return set_base

    # --- hand ---------------------------------------------------------------------------------

    def hand_now(self, action: ir.HandAction, following: int, cause: Cause) -> Step:
        """Return the step of OPENI, CLOSEI or RELAXI."""

        def hand_now(c: Context) -> int:
            if c.phase == 0:
                if not reached(c, c.planner.settled_at):
                    return BLOCKED
                command_hand(c, action, c.now, cause)
                c.until = c.now + c.hand_time
                c.phase = 1
            if not reached(c, c.until):
                return BLOCKED
            c.phase = 0
            return following

        return hand_now


def command_hand(c: Context, action: ir.HandAction, time_s: float, cause: Cause) -> None:
    """Begin an action of the hand at a time, along the motion planned."""
    planner = c.planner

    def flange_at(t: float) -> Pose:
        return forward(planner.arm, planner.configuration_at(t))

    c.hand.command(action, time_s, flange_at, planner.motion_end, cause, c.events)


def _fraction(c: Context, speed: Speed, cause: Cause) -> float:
    if speed.value <= 0.0:
        raise RuntimeFault(RuntimeErrorKind.ILLEGAL_VALUE, "a speed must be above zero", cause.span)
    return speed_fraction(c.planner.arm, speed)
