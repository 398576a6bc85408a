"""Instructions of the IR as closures: each takes the context and returns what comes next.

The result is the index of the next instruction, or a negative outcome of `outcomes`. An instruction
that has to wait returns BLOCKED and is entered again; `Context.phase` remembers how far it came.
"""

from collections.abc import Callable

from vrts.base.numbers import round_half_away
from vrts.base.oat import components
from vrts.base.pose import Pose
from vrts.base.source import Span
from vrts.base.units import deg
from vrts.engine.arithmetic import checked_string, integer, rounded
from vrts.engine.context import Context
from vrts.engine.evaluate import Compiler, Evaluate
from vrts.engine.evaluate_strings import written
from vrts.engine.events import Cause, Printed, SignalChanged
from vrts.engine.extent import simulates
from vrts.engine.faults import RuntimeFault
from vrts.engine.motion_steps import MotionStepCompiler
from vrts.engine.outcomes import (
    BLOCKED,
    CYCLE_ENDED,
    HALTED,
    PAUSED,
    WAIT_NEVER_ENDS,
    LimitReached,
)
from vrts.engine.pieces import packed, spread
from vrts.engine.signals import OUTPUTS, known
from vrts.engine.step import Step, place_of, reached
from vrts.ir import instructions as ir
from vrts.ir.expressions import (
    Apply,
    Binary,
    Compose,
    Expression,
    Format,
    FormatKind,
    Function,
    Place,
    Unary,
)
from vrts.ir.runtime_errors import RuntimeErrorKind
from vrts.ir.values import Type, Value
from vrts.robots.kinematics import forward, solve

HIGHEST_TIMER = 15  # [val2.md 3.9]
MOST_BITS = 16  # that BITS writes at once [val2.md 3.5]
MOST_PACKED = 32767 * 128  # characters of a string array

CHANGING = frozenset(
    {Function.TIMER, Function.RANDOM, Function.HERE, Function.HERE_JOINTS, Function.HAND}
)  # functions whose value may change although no signal and no variable does


class StepCompiler:
    """Compiles the instructions of one program, except calls and returns."""

    def __init__(self, expressions: Compiler) -> None:
        """Share the compiler of expressions."""
        self.expressions = expressions
        self.motions = MotionStepCompiler(expressions)

    def step(self, instruction: ir.Instruction, index: int, cause: Cause) -> Step:
        """Return the closure of an instruction that stands at an index."""
        following = index + 1
        e = self.expressions
        if isinstance(instruction, ir.Opaque):
            return refusal(f"{instruction.words} is not simulated", cause)
        if not simulates(instruction):
            return refusal(f"`{cause.span.text}` is not simulated yet", cause)
        match instruction:
            case ir.Assign(place=place, value=value):
                return self._assign(place, e.value(value), following)
            case ir.AssignHere(place=place, frame=frame):
                return self._assign_here(place, frame, following)
            case ir.Move() | ir.Depart() | ir.Drive() | ir.Ready():
                return self.motions.motion(instruction, following, cause)
            case ir.Delay(time=time):
                return self.motions.delay(e.real(time), following)
            case ir.Break():
                return lambda c: following if reached(c, c.planner.settled_at) else BLOCKED
            case ir.SetSpeed():
                return self.motions.speed(instruction, following)
            case ir.RequestBranch(branch=branch):

                def request(c: Context) -> int:
                    if not reached(c, c.planner.settled_at):
                        return BLOCKED
                    c.planner.ask(branch)
                    return following

                return request
            case ir.MoveHand(action=action, immediate=immediate):
                if immediate:
                    return self.motions.hand_now(action, following, cause)

                def hand_later(c: Context) -> int:
                    c.next_hand.append((action, cause))
                    return following

                return hand_later
            case ir.SetTool(pose=pose):
                return self.motions.tool(pose, following)
            case ir.SetBase():
                return self.motions.base(instruction, following)
            case ir.Jump(target=target):
                return lambda c: target
            case ir.JumpIf(condition=condition, when=when, target=target):
                test = e.real(condition)
                return lambda c: target if (test(c) != 0.0) is when else following
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
                return self._ending(message, CYCLE_ENDED, cause, waits=False)
            case ir.Halt(message=message):
                return self._ending(message, HALTED, cause, waits=True)
            case ir.Pause(message=message):
                return self._ending(message, PAUSED, cause, waits=True)
            case ir.Signal(signals=signals):
                return self._signal(signals, following, cause)
            case ir.Wait(condition=condition):
                return self._wait(condition, following, cause)
            case ir.Type(items=items):
                return self._type(items, following, cause)
            case ir.SetTimer(number=number, value=value):
                return self._set_timer(e.real(number), e.real(value), following, cause)
            case ir.Reset():
                return lambda c: _reset(c, following, cause)
            case ir.SetBits():
                return self._set_bits(instruction, following, cause)
            case ir.Pack():
                return self._pack(instruction, following, cause)
            case ir.Decompose():
                return self._decompose(instruction, following)
            case ir.Call() | ir.Return():
                raise ValueError("calls and returns are compiled by `executable`")
            case _:
                raise ValueError(f"{type(instruction).__name__} is said to be carried out")

    # --- timers, outputs, strings -------------------------------------------------------------

    def _set_timer(
        self,
        number: Callable[[Context], float],
        value: Callable[[Context], float],
        following: int,
        cause: Cause,
    ) -> Step:
        def set_timer(c: Context) -> int:
            which = integer(number(c), cause.span, 1, HIGHEST_TIMER, "timer")
            c.timers[which] = c.now - value(c)
            return following

        return set_timer

    def _set_bits(self, instruction: ir.SetBits, following: int, cause: Cause) -> Step:
        first, length = self.expressions.real(instruction.first), instruction.length
        count, value = self.expressions.real(length), self.expressions.real(instruction.value)

        def set_bits(c: Context) -> int:
            start = round_half_away(first(c))
            many = integer(count(c), cause.span, 1, MOST_BITS, "number of signals")
            bits = round_half_away(value(c))
            for k in range(many):
                known(start + k, cause.span, writable=True)
            for k in range(many):
                _turn(c, start + k, bool(bits >> k & 1), cause)
            return following

        return set_bits

    def _pack(self, instruction: ir.Pack, following: int, cause: Cause) -> Step:
        e, place = self.expressions, instruction.place
        first, length = e.real(instruction.first), e.real(instruction.length)
        text = e.string(instruction.text)
        elements = e.elements(place)

        def pack(c: Context) -> int:
            start = integer(first(c), cause.span, 1, MOST_PACKED, "position")
            part = text(c)
            many = integer(length(c), cause.span, 0, MOST_PACKED, "number of characters")
            for element, at, taken in spread(start, many):
                cell = elements(c, element)
                now = cell.value if isinstance(cell.value, str) else ""
                cell.assign(checked_string(packed(now, at, taken, part[:taken]), cause.span), c.now)
                part = part[taken:]
            return following

        return pack

    def _decompose(self, instruction: ir.Decompose, following: int) -> Step:
        e = self.expressions
        elements, location = e.elements(instruction.place), e.location(instruction.location)
        plain = instruction.plain_angles

        def decompose(c: Context) -> int:
            found = location(c)
            if isinstance(found, Pose):
                x, y, z, o, a, t = components(found)
                values = (x, y, z, *((o - 90.0, a + 90.0, t) if plain else (o, a, t)))
            else:
                values = tuple(deg(joint) for joint in found)  # type: ignore[union-attr]
            for k, value in enumerate(values):
                elements(c, k).assign(rounded(value, instruction.place.span), c.now)
            return following

        return decompose

    # --- assignment ---------------------------------------------------------------------------

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
            cell(c).assign(found, c.now)
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
                cell(c).assign(q, c.now)
                return following
            X = planner.base @ forward(planner.arm, q) @ planner.tool
            cell(c).assign(base(c).inverse() @ X if base is not None else X, c.now)
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
                    cell(c).assign(begin(c), c.now)
                    frame = c.frames[-1]
                    frame.limits[loop] = limit(c)
                    frame.increments[loop] = 1.0 if by is None else by(c)
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
                    cell(c).assign(total, c.now)
                    return test

                return next_for

    def _ending(
        self, message: Expression | None, outcome: int, cause: Cause, *, waits: bool
    ) -> Step:
        text = self.expressions.string(message) if message is not None else None

        def end(c: Context) -> int:
            if waits and not reached(c, c.planner.settled_at):
                return BLOCKED
            if text is not None:
                _print(c, text(c) + "\r\n", cause)
            return outcome

        return end

    # --- signals and terminal -----------------------------------------------------------------

    def _signal(self, signals: tuple[Expression, ...], following: int, cause: Cause) -> Step:
        numbers = tuple((self.expressions.real(s), place_of(s)) for s in signals)

        def signal(c: Context) -> int:
            for value, span in numbers:
                wanted = round_half_away(value(c))
                if wanted == 0:
                    continue
                known(wanted, span, writable=True)
                on = wanted > 0
                if on is not (abs(wanted) in c.signals.on):
                    c.signals.turn(abs(wanted), on=on)
                    c.events.append(SignalChanged(c.now, abs(wanted), on, cause))
            return following

        return signal

    def _wait(self, condition: Expression | None, following: int, cause: Cause) -> Step:
        if condition is None:

            def give_up(c: Context) -> int:
                if c.phase == 1:
                    c.phase = 0
                    return following
                c.phase = 1
                c.wake = c.now + c.planner.arm.tick
                return BLOCKED

            return give_up
        test = self.expressions.real(condition)
        changes = _uses(condition, CHANGING)

        def wait(c: Context) -> int:
            if test(c) != 0.0:
                return following
            if changes:
                c.wake = c.now + c.planner.arm.tick
                return BLOCKED
            coming = c.signals.next_input_s
            if coming is None:
                raise LimitReached(
                    WAIT_NEVER_ENDS,
                    "this WAIT never ends: nothing that is still to happen makes it true",
                    cause.span,
                    f"looked at when it was reached, at {c.now:.3f} s",
                    "wait for a signal that the scenario turns on, or set it in the program",
                )
            c.wake = max(coming, c.now + c.planner.arm.tick)
            return BLOCKED

        return wait

    def _type(self, items: "tuple[Expression | Format, ...]", following: int, cause: Cause) -> Step:
        text = written(self.expressions, items, "TYPE")
        last = items[-1] if items else None
        end = "" if isinstance(last, Format) and last.kind is FormatKind.STAY else "\r\n"

        def write(c: Context) -> int:
            _print(c, text(c) + end, cause)
            return following

        return write


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


def _turn(c: Context, signal: int, on: bool, cause: Cause) -> None:
    if on is not (signal in c.signals.on):
        c.signals.turn(signal, on=on)
        c.events.append(SignalChanged(c.now, signal, on, cause))


def _reset(c: Context, following: int, cause: Cause) -> int:
    for signal in OUTPUTS:
        _turn(c, signal, False, cause)
    return following


def _print(c: Context, text: str, cause: Cause) -> None:
    c.terminal.wrote(text)
    c.events.append(Printed(c.now, text, cause))


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


def _uses(expression: object, functions: frozenset[Function]) -> bool:
    match expression:
        case Apply(function=function, arguments=arguments):
            return function in functions or any(_uses(a, functions) for a in arguments)
        case Unary(operand=operand):
            return _uses(operand, functions)
        case Binary(left=left, right=right):
            return _uses(left, functions) or _uses(right, functions)
        case Compose(parts=parts):
            return any(_uses(part, functions) for part in parts)
        case _:
            return False
