"""Signals, timers and waiting, as closures."""

import math

from vrts.base.numbers import round_half_away
from vrts.engine.code.closures import BLOCKED, Step, reached
from vrts.engine.code.values.arithmetic import integer
from vrts.engine.code.values.compiler import Compiler
from vrts.engine.code.values.operands import span_of
from vrts.engine.code.values.volatile import changes_by_itself
from vrts.engine.memory.events import AnalogChanged, Cause, SignalChanged
from vrts.engine.motion.profile import TICK_TOLERANCE
from vrts.engine.programs.context import Context
from vrts.engine.programs.signals import OUTPUTS, known
from vrts.ir import instructions as ir
from vrts.ir.expressions import Expression
from vrts.ir.ranges import ANALOG_OUTPUTS, HIGHEST_TIMER, LEAST_COUNT, MOST_BITS, MOST_COUNT

CHANNELS = (ANALOG_OUTPUTS[0], ANALOG_OUTPUTS[-1])

SignalInstruction = (
    ir.Signal
    | ir.Reset
    | ir.SetBits
    | ir.Pulse
    | ir.DelayedSignal
    | ir.SetAnalog
    | ir.SetTimer
    | ir.Wait
    | ir.WaitTime
)


class SignalStepCompiler:
    """Compiles what deals with signals and time."""

    def __init__(self, expressions: Compiler) -> None:
        """Share the compiler of expressions."""
        self.expressions = expressions

    def step(self, instruction: SignalInstruction, following: int, cause: Cause) -> Step:
        """Return the step of an instruction."""
        match instruction:
            case ir.Signal(signals=signals):
                return self._signal(signals, following, cause)
            case ir.Reset():
                return lambda c: _reset(c, following, cause)
            case ir.SetBits():
                return self._set_bits(instruction, following, cause)
            case ir.Pulse():
                return self._pulse(instruction, following, cause)
            case ir.DelayedSignal():
                return self._delayed(instruction, following, cause)
            case ir.SetAnalog():
                return self._set_analog(instruction, following, cause)
            case ir.SetTimer():
                return self._set_timer(instruction, following, cause)
            case ir.Wait(condition=condition):
                return self._wait(condition, following)
            case ir.WaitTime(time=time):
                return self._wait_time(time, following)

    def _signal(self, signals: tuple[Expression, ...], following: int, cause: Cause) -> Step:
        numbers = tuple((self.expressions.real(s), span_of(s)) for s in signals)

        def signal(c: Context) -> int:
            for value, span in numbers:
                wanted = round_half_away(value(c))
                if wanted == 0:
                    continue
                known(wanted, span, writable=True)
                turn(c, abs(wanted), wanted > 0, cause)
            return following

        return signal

    def _set_bits(self, instruction: ir.SetBits, following: int, cause: Cause) -> Step:
        e = self.expressions
        first, count = e.real(instruction.first), e.real(instruction.length)
        value = e.real(instruction.value)

        def set_bits(c: Context) -> int:
            start = round_half_away(first(c))
            many = integer(count(c), cause.span, 1, MOST_BITS, "number of signals")
            bits = round_half_away(value(c))
            for k in range(many):
                known(start + k, cause.span, writable=True)
            for k in range(many):
                turn(c, start + k, bool(bits >> k & 1), cause)
            return following

        return set_bits

    def _pulse(self, instruction: ir.Pulse, following: int, cause: Cause) -> Step:
        number = self.expressions.real(instruction.signal)
        time = self.expressions.real(instruction.time) if instruction.time is not None else None

        def pulse(c: Context) -> int:
            wanted = round_half_away(number(c))
            known(wanted, cause.span, writable=True)
            model = c.planner.model
            lasts = model.programs.pulse_s if time is None else max(time(c), 0.0)
            on = wanted > 0
            turn(c, abs(wanted), on, cause)
            _schedule(c, c.now + lasts, abs(wanted), not on)
            return following

        return pulse

    def _delayed(self, instruction: ir.DelayedSignal, following: int, cause: Cause) -> Step:
        number = self.expressions.real(instruction.signal)
        time = self.expressions.real(instruction.time)

        def delayed(c: Context) -> int:
            wanted = round_half_away(number(c))
            known(wanted, cause.span, writable=True)
            _schedule(c, c.now + max(time(c), 0.0), abs(wanted), wanted > 0)
            return following

        return delayed

    def _set_analog(self, instruction: ir.SetAnalog, following: int, cause: Cause) -> Step:
        channel = self.expressions.real(instruction.channel)
        value = self.expressions.real(instruction.value)

        def set_analog(c: Context) -> int:
            number = integer(channel(c), cause.span, *CHANNELS, "analog output")
            counts = float(integer(value(c), cause.span, LEAST_COUNT, MOST_COUNT, "count"))
            c.system.analog[number] = counts
            c.events.append(AnalogChanged(c.now, number, counts, cause))
            return following

        return set_analog

    def _set_timer(self, instruction: ir.SetTimer, following: int, cause: Cause) -> Step:
        number = self.expressions.real(instruction.number)
        value, span = self.expressions.real(instruction.value), cause.span

        def set_timer(c: Context) -> int:
            which, system = integer(number(c), span, 1, HIGHEST_TIMER, "timer"), c.system
            now = c.now
            zero_s = system.timers[which] = now - value(c)
            if system.facts is not None:
                track = system.facts.timers.get(which) or system.facts.timer(which)
                track.times.append(now)
                track.numbers.append(c.finished)
                track.values.append(zero_s)  # type: ignore[arg-type]
            return following

        return set_timer

    # --- waiting ------------------------------------------------------------------------------

    def _wait(self, condition: Expression | None, following: int) -> Step:
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
        volatile = changes_by_itself(condition)

        def wait(c: Context) -> int:
            if test(c) != 0.0:
                return following
            if volatile:
                c.wake = c.now + c.planner.arm.tick
            else:
                c.wait_for_change()
            return BLOCKED

        return wait

    def _wait_time(self, time: Expression, following: int) -> Step:
        seconds = self.expressions.real(time)

        def wait(c: Context) -> int:
            if c.phase == 0:
                tick = c.planner.arm.tick
                ticks = math.ceil(max(seconds(c), 0.0) / tick - TICK_TOLERANCE)
                c.until, c.phase = c.now + ticks * tick, 1
            if not reached(c, c.until):
                return BLOCKED
            c.phase = 0
            return following

        return wait


def turn(c: Context, signal: int, on: bool, cause: Cause | None) -> None:
    """Turn a signal on or off, and note it when that is a change."""
    if c.signals.turn(signal, on=on):
        c.events.append(SignalChanged(c.now, signal, on, cause))


def _reset(c: Context, following: int, cause: Cause) -> int:
    for signal in OUTPUTS:
        turn(c, signal, False, cause)
    return following


def _schedule(c: Context, time_s: float, signal: int, on: bool) -> None:
    c.system.scheduled = sorted([*c.system.scheduled, (time_s, signal, on)])
