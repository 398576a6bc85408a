"""Reactions, errors that are caught, and the process control program, as closures."""

from collections.abc import Callable

from vrts.base.numbers import round_half_away
from vrts.engine.code.closures import SWITCHED, Step
from vrts.engine.code.values.arithmetic import integer
from vrts.engine.code.values.compiler import Compiler
from vrts.engine.faults import RuntimeFault
from vrts.engine.memory.events import Cause
from vrts.engine.programs.context import Context
from vrts.engine.programs.cycles import abort, after_step, begin, end_later, note_progress, tell
from vrts.engine.programs.frames import FrameKind
from vrts.engine.programs.signals import OUTPUTS, known
from vrts.engine.programs.watches import MOST_WATCHES, Watch
from vrts.ir import instructions as ir
from vrts.ir.ranges import HIGHEST_PRIORITY
from vrts.ir.runtime_errors import RuntimeErrorKind

ReactionInstruction = (
    ir.React
    | ir.ReactError
    | ir.ReturnError
    | ir.Ignore
    | ir.Lock
    | ir.StartProcess
    | ir.AbortProcess
    | ir.EndProcess
)


class ReactionStepCompiler:
    """Compiles what changes the flow of a program from outside of it."""

    def __init__(self, expressions: Compiler) -> None:
        """Share the compiler of expressions."""
        self.expressions = expressions

    def step(self, instruction: ReactionInstruction, following: int, cause: Cause) -> Step:
        """Return the step of an instruction."""
        match instruction:
            case ir.React():
                return self._react(instruction, following, cause)
            case ir.ReactError(program=program):
                return self._catch(program, following, cause)
            case ir.ReturnError():
                return lambda c: _return_error(c, cause)
            case ir.Ignore(signal=signal):
                number = self.expressions.real(signal)

                def ignore(c: Context) -> int:
                    wanted = abs(round_half_away(number(c)))
                    c.watches = [w for w in c.watches if w.signal != wanted]
                    return following

                return ignore
            case ir.Lock(priority=priority):
                level = self.expressions.real(priority) if priority is not None else None

                def lock(c: Context) -> int:
                    wanted = 0.0 if level is None else level(c)
                    c.priority = integer(wanted, cause.span, 0, HIGHEST_PRIORITY, "priority")
                    c.frames[-1].index = following
                    note_progress(c)
                    return SWITCHED  # reactions that waited are looked at before the next step

                return lock
            case ir.StartProcess():
                return self._start(instruction, following, cause)
            case ir.AbortProcess():

                def stop(c: Context) -> int:
                    abort(c.process, c.now)
                    return following

                return stop
            case ir.EndProcess(mode=mode):
                chosen = self.expressions.real(mode) if mode is not None else None

                def end(c: Context) -> int:
                    on = chosen is None or chosen(c) > 0.0
                    end_later(c.process, on=on)
                    return following

                return end

    def _react(self, react: ir.React, following: int, cause: Cause) -> Step:
        e = self.expressions
        signal = e.real(react.signal)
        priority = e.real(react.priority) if react.priority is not None else None
        program = self._program(react.program, cause)

        def watch(c: Context) -> int:
            wanted = round_half_away(signal(c))
            known(wanted, cause.span)
            number = abs(wanted)
            if number in OUTPUTS or number == 0:
                raise RuntimeFault(
                    RuntimeErrorKind.ILLEGAL_SIGNAL,
                    f"signal {number} cannot be watched: it is an output",
                    cause.span,
                    notes=("inputs and internal signals can be",),
                )
            level = 1 if priority is None else round_half_away(priority(c))
            level = integer(float(level), cause.span, 1, HIGHEST_PRIORITY, "priority")
            others = [w for w in c.watches if w.signal != number]
            if len(others) >= MOST_WATCHES:
                raise RuntimeFault(
                    RuntimeErrorKind.ILLEGAL_VALUE,
                    f"more than {MOST_WATCHES} signals are watched",
                    cause.span,
                    help=("IGNORE a signal that need not be watched any more",),
                )
            c.watches = [
                *others,
                Watch(
                    number,
                    wanted > 0,
                    program(c),
                    level,
                    react.immediate,
                    react.always,
                    react.after_motion,
                    state=number in c.signals.on,
                ),
            ]
            return following

        return watch

    def _catch(self, name: str | None, following: int, cause: Cause) -> Step:
        program = self._program(name, cause)

        def catch(c: Context) -> int:
            c.error_program = program(c)
            return following

        return catch

    def _program(self, name: str | None, cause: Cause) -> Callable[[Context], int | None]:
        def number(c: Context) -> int | None:
            if name is None:
                return None
            return number_of(c, name, cause)

        return number

    def _start(self, start: ir.StartProcess, following: int, cause: Cause) -> Step:
        e = self.expressions
        cycles = e.real(start.cycles) if start.cycles is not None else None
        step = e.real(start.step) if start.step is not None else None

        def execute(c: Context) -> int:
            process = c.process
            name = start.program or process.program
            if process.running:
                raise RuntimeFault(
                    RuntimeErrorKind.PROCESS_EXECUTING,
                    f"`{process.program}` is still being executed",
                    cause.span,
                    help=("there is one process control program; PCABORT or PCEND ends it",),
                )
            number_of(c, name, cause)
            many = 1 if cycles is None else round_half_away(cycles(c))
            first = 1 if step is None else round_half_away(step(c))
            begin(process, name, many, first, c.now)
            return following

        return execute


def number_of(c: Context, name: str, cause: Cause) -> int:
    """Return the number of a program.

    Raises:
        RuntimeFault: There is none of that name.
    """
    number = c.system.programs.numbers.get(name)
    if number is None:
        raise RuntimeFault(
            RuntimeErrorKind.UNDEFINED_PROGRAM,
            f"there is no program `{name}`" if name else "no process control program was run yet",
            cause.span,
            data={"name": name},
        )
    return number


def _return_error(c: Context, cause: Cause) -> int:
    if c.frames[-1].kind is not FrameKind.ERROR:
        raise RuntimeFault(
            RuntimeErrorKind.ILLEGAL_RETURNE,
            "RETURNE stands in a program that no error has called",
            cause.span,
            help=("RETURN goes back to the caller; RETURNE belongs into the program of REACTE",),
        )
    c.leave()
    c.phase, c.operands, c.fault = 0, None, None
    frame = c.frames[-1]
    program = c.system.programs.loaded[frame.program].program
    frame.index = after_step(program, frame.index)
    tell(c)
    return SWITCHED
