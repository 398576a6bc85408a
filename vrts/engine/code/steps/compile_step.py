"""Instructions of the IR as closures: each takes the context and returns what comes next.

The result is the index of the next instruction, or a negative outcome of `closures`. An instruction
that has to wait returns BLOCKED and is entered again; `Context.phase` remembers how far it came.
"""

from collections.abc import Callable

from vrts.base.pose import Pose
from vrts.base.source import Span
from vrts.engine.code.closures import (
    BLOCKED,
    CYCLE_ENDED,
    HALTED,
    PAUSED,
    Evaluate,
    Step,
    reached,
)
from vrts.engine.code.steps.call_steps import CallStepCompiler
from vrts.engine.code.steps.extent import robot_only, simulates
from vrts.engine.code.steps.frame_steps import FrameStepCompiler
from vrts.engine.code.steps.guard import for_robot
from vrts.engine.code.steps.hand_steps import HandStepCompiler
from vrts.engine.code.steps.motion_steps import MotionStepCompiler
from vrts.engine.code.steps.reaction_steps import ReactionStepCompiler
from vrts.engine.code.steps.setting_steps import SettingStepCompiler
from vrts.engine.code.steps.signal_steps import SignalStepCompiler
from vrts.engine.code.steps.switch_steps import switch_step
from vrts.engine.code.steps.terminal_steps import TerminalStepCompiler, put
from vrts.engine.code.values.arithmetic import checked_string, rounded
from vrts.engine.code.values.compiler import Compiler
from vrts.engine.code.values.controller_functions import parameter
from vrts.engine.code.values.operands import parameter_cell
from vrts.engine.code.values.real_expressions import truth
from vrts.engine.code.values.static_types import static_type
from vrts.engine.faults import RuntimeFault
from vrts.engine.memory.events import Cause
from vrts.engine.programs.context import Context
from vrts.engine.programs.locks import Wish, refused
from vrts.ir import instructions as ir
from vrts.ir.expressions import Expression, Place
from vrts.ir.runtime_errors import RuntimeErrorKind
from vrts.ir.values import Type, Value
from vrts.robots.kinematics.kinematics import forward, solve


class StepCompiler:
    """Compiles instructions of any kind."""

    def __init__(self, expressions: Compiler, call_depth: int) -> None:
        """Share the compiler of expressions; programs call each other at most so deep."""
        self.expressions = expressions
        self.calls = CallStepCompiler(expressions, call_depth)
        self.motions = MotionStepCompiler(expressions)
        self.frames = FrameStepCompiler(expressions)
        self.settings = SettingStepCompiler(expressions)
        self.hands = HandStepCompiler(expressions)
        self.signals = SignalStepCompiler(expressions)
        self.reactions = ReactionStepCompiler(expressions)
        self.texts = TerminalStepCompiler(expressions)

    def step(self, instruction: ir.Instruction, index: int, cause: Cause, count: int) -> Step:
        """Return the closure of an instruction that stands at an index, of so many."""
        match instruction:
            case ir.Call() | ir.CallNamed():
                return self.calls.call(instruction, index + 1, cause)
            case ir.Return():
                return self.calls.leave(instruction, implicit=index == count - 1)
            case _:
                step = self._step(instruction, index, cause)
                guarded = robot_only(instruction) and simulates(instruction)
                return for_robot(step, cause) if guarded else step

    def _step(self, instruction: ir.Instruction, index: int, cause: Cause) -> Step:
        following = index + 1
        e = self.expressions
        if isinstance(instruction, ir.Opaque):
            return refusal(f"{instruction.words} is not simulated", cause)
        if not simulates(instruction):
            return refusal(f"`{cause.span.text}` is not simulated yet", cause)
        match instruction:
            case ir.Assign(place=place, value=value):
                if place.variable.type is Type.REAL and static_type(value) is Type.REAL:
                    return self._assign_real(place, e.real(value), following)
                return self._assign(place, e.value(value), following)
            case ir.AssignHere(place=place, frame=frame):
                return self._assign_here(place, frame, following)
            case (
                ir.Move()
                | ir.Depart()
                | ir.Drive()
                | ir.Draw()
                | ir.Align()
                | ir.Ready()
                | ir.Nest()
            ):
                return self.motions.motion(instruction, following, cause)
            case ir.Delay(time=time):
                return self.motions.delay(time, following)
            case ir.Break():
                return lambda c: following if reached(c, c.planner.settled_at) else BLOCKED
            case ir.Brake():

                def brake(c: Context) -> int:
                    c.planner.brake(c.now)
                    c.hand.path_changed(c.now)
                    c.look_again()
                    return following

                return brake
            case (
                ir.SetSpeed()
                | ir.SetMonitorSpeed()
                | ir.SetAcceleration()
                | ir.SetDuration()
                | ir.SetAccuracy()
                | ir.SetNulling()
                | ir.SetIntegration()
                | ir.SetTurns()
            ):
                return self.settings.setting(instruction, following, cause)
            case ir.RequestBranch():
                return self.settings.branch(instruction, following, cause)
            case ir.MoveHand():
                return self.hands.move_hand(instruction, following, cause)
            case ir.Grasp():
                return self.hands.grasp(instruction, following, cause)
            case ir.SetTool(pose=pose):
                return self.frames.tool(pose, following)
            case ir.SetBase() | ir.SetBaseFrame():
                return self.frames.base(instruction, following)
            case ir.Jump(target=target):
                return lambda c: target
            case ir.JumpIf(condition=condition, when=when, target=target):
                return self._jump_if(condition, target, following, when=when)
            case ir.BeginFor() | ir.TestFor() | ir.NextFor():
                return self._for(instruction, following, cause)
            case ir.BeginCase(selector=selector, case=case):
                select = e.value(selector)

                def begin_case(c: Context) -> int:
                    c.frames[-1].cases[case] = select(c)  # type: ignore[call-overload]
                    return following

                return begin_case
            case ir.TestCase(case=case, values=values, otherwise=otherwise):
                items = tuple(e.value(item) for item in values)

                def test_case(c: Context) -> int:
                    selected = c.frames[-1].cases[case]
                    matches = any(item(c) == selected for item in items)
                    return following if matches else otherwise

                return test_case
            case ir.Stop(message=message):
                return self._ending(message, CYCLE_ENDED, following, cause, waits=False)
            case ir.Halt(message=message):
                return self._ending(message, HALTED, following, cause, waits=True)
            case ir.Pause(message=message):
                return self._ending(message, PAUSED, following, cause, waits=True)
            case (
                ir.Signal()
                | ir.Reset()
                | ir.SetBits()
                | ir.Pulse()
                | ir.DelayedSignal()
                | ir.SetAnalog()
                | ir.SetTimer()
                | ir.Wait()
                | ir.WaitTime()
            ):
                return self.signals.step(instruction, following, cause)
            case (
                ir.React()
                | ir.ReactError()
                | ir.ReturnError()
                | ir.Ignore()
                | ir.Lock()
                | ir.StartProcess()
                | ir.AbortProcess()
                | ir.EndProcess()
            ):
                return self.reactions.step(instruction, following, cause)
            case ir.Type() | ir.Prompt() | ir.Pack() | ir.Decompose():
                return self.texts.step(instruction, following, cause)
            case ir.Switch():
                return switch_step(instruction, following, cause)
            case ir.SetParameter():
                return self._set_parameter(instruction, following, cause)
            case ir.Call() | ir.CallNamed() | ir.Return():
                raise ValueError("calls and returns are compiled apart")

    def _jump_if(self, condition: Expression, target: int, following: int, *, when: bool) -> Step:
        holds = truth(self.expressions, condition)
        if when:
            return lambda c: target if holds(c) else following
        return lambda c: following if holds(c) else target

    def _set_parameter(self, instruction: ir.SetParameter, following: int, cause: Cause) -> Step:
        e = self.expressions
        value = e.real(instruction.value)
        index = e.real(instruction.subscript) if instruction.subscript is not None else None

        def set_parameter(c: Context) -> int:
            which = None if index is None else index(c)
            name = parameter_cell(instruction.name, which, cause.span)
            wanted = value(c)
            if instruction.name in c.system.locks.names:
                kept = parameter(c, instruction.name, name, cause.span)
                if wanted != kept:
                    keeps = f"it stays {kept:g}"
                    refused(c, Wish(instruction.name, f"PARAMETER {name}", keeps), cause)
                return following
            c.system.set_parameter(name, wanted, c.finished)
            return following

        return set_parameter

    # --- assignment ---------------------------------------------------------------------------

    def _assign_real(self, place: Place, value: Callable[[Context], float], following: int) -> Step:
        """Return the assignment of what is known to be a real to what is known to hold one."""
        cell = self.expressions.cell(place)

        def assign(c: Context) -> int:
            found = value(c)
            target = cell(c)
            target.value = found
            target.values.append(found)
            target.since.append(c.finished)
            return following

        return assign

    def _assign(self, place: Place, value: Evaluate, following: int) -> Step:
        cell, wanted, span = self.expressions.cell(place), place.variable.type, place.span

        def assign(c: Context) -> int:
            found = value(c)
            if isinstance(found, str):
                checked_string(found, span)
            elif isinstance(found, Pose) and wanted is Type.JOINTS:
                found = _joints_of(c, found, span)
            elif isinstance(found, tuple) and not isinstance(found, Pose) and wanted is Type.POSE:
                found = c.planner.pose_of(found)  # type: ignore[arg-type]
            cell(c).assign(found, c.finished)
            return following

        return assign

    def _assign_here(self, place: Place, frame: Expression | None, following: int) -> Step:
        e = self.expressions
        cell, wanted = e.cell(place), place.variable.type
        base = e.pose(frame) if frame is not None else None

        def here(c: Context) -> int:
            planner = c.planner
            q = planner.configuration_at(c.now)
            if wanted is Type.JOINTS:
                cell(c).assign(q, c.finished)
                return following
            X = planner.base @ forward(planner.arm, q) @ planner.tool
            cell(c).assign(base(c).inverse() @ X if base is not None else X, c.finished)
            return following

        return here

    # --- control ------------------------------------------------------------------------------

    def _for(
        self, instruction: ir.BeginFor | ir.TestFor | ir.NextFor, following: int, cause: Cause
    ) -> Step:
        e = self.expressions
        cell, load, loop = e.cell(instruction.place), e.load(instruction.place), instruction.loop
        match instruction:
            case ir.BeginFor(first=first, last=last, increment=increment):
                begin, limit = e.real(first), e.real(last)
                by = e.real(increment) if increment is not None else None

                def begin_for(c: Context) -> int:
                    start, variable = begin(c), cell(c)
                    before, variable.value = variable.value, start  # the limit may depend on it
                    try:
                        last, step = limit(c), 1.0 if by is None else by(c)
                    finally:
                        variable.value = before
                    variable.assign(start, c.finished)
                    frame = c.frames[-1]
                    frame.limits[loop], frame.increments[loop] = last, step
                    return following

                return begin_for
            case ir.TestFor(leave=leave):

                def test_for(c: Context) -> int:
                    frame = c.frames[-1]
                    limit = frame.limits[loop]
                    if limit is None:
                        raise _never_begun(cause)
                    value: float = load(c)  # type: ignore[assignment]
                    past = value > limit if frame.increments[loop] >= 0.0 else value < limit
                    return leave if past else following

                return test_for
            case ir.NextFor(test=test):

                def next_for(c: Context) -> int:
                    frame = c.frames[-1]
                    if frame.limits[loop] is None:
                        raise _never_begun(cause)
                    value: float = load(c)  # type: ignore[assignment]
                    total = rounded(value + frame.increments[loop], cause.span)
                    cell(c).assign(total, c.finished)
                    return test

                return next_for

    def _ending(
        self, message: Expression | None, outcome: int, following: int, cause: Cause, *, waits: bool
    ) -> Step:
        text = self.expressions.string(message) if message is not None else None

        def end(c: Context) -> int:
            if waits and not reached(c, c.planner.settled_at):
                return BLOCKED
            if text is not None:
                put(c, text(c) + "\r\n", cause)
            c.frames[-1].index = following
            return outcome

        return end


def refusal(headline: str, cause: Cause) -> Step:
    """Return the closure of an instruction that is not carried out: it stops the run."""

    def refuse(c: Context) -> int:
        raise RuntimeFault(
            RuntimeErrorKind.NOT_INSTALLED,
            headline,
            cause.span,
            help=("leave the step out, or change it, to simulate the rest",),
        )

    return refuse


def _joints_of(c: Context, pose: Pose, span: Span | None) -> Value:
    planner = c.planner
    X_BF = planner.base.inverse() @ pose @ planner.tool.inverse()
    found = solve(planner.arm, X_BF, planner.branch, planner.configuration)
    if found is None:
        raise RuntimeFault(RuntimeErrorKind.OUT_OF_RANGE, "the location is out of reach", span)
    return found


def _never_begun(cause: Cause) -> RuntimeFault:
    return RuntimeFault(
        RuntimeErrorKind.CONTROL_STRUCTURE,
        "the end of this FOR loop is reached although the loop was never begun",
        cause.span,
        help=("jump to the FOR step, not into its body",),
    )
