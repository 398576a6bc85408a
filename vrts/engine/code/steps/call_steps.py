"""Calls and returns, as closures."""

from collections.abc import Callable

from vrts.base.source import Span
from vrts.engine.code.closures import CYCLE_ENDED, SWITCHED, Bind, Real, Step
from vrts.engine.code.values.compiler import Compiler
from vrts.engine.faults import RuntimeFault
from vrts.engine.memory.cells import Array, Bound, Cell
from vrts.engine.memory.events import Cause
from vrts.engine.programs.context import Context
from vrts.engine.programs.cycles import note_progress
from vrts.engine.programs.frames import FrameKind
from vrts.engine.programs.loaded import fresh
from vrts.ir import instructions as ir
from vrts.ir.expressions import Expression, Place, Slot, WholeArray
from vrts.ir.runtime_errors import RuntimeErrorKind
from vrts.ir.values import Type, type_of_value


class CallStepCompiler:
    """Compiles calls and returns."""

    def __init__(self, expressions: Compiler, call_depth: int) -> None:
        """Share the compiler of expressions; programs call each other at most so deep."""
        self.expressions = expressions
        self.call_depth = call_depth

    def call(self, instruction: ir.Call | ir.CallNamed, following: int, cause: Cause) -> Step:
        """Return the step of CALL and CALLS."""
        arguments = instruction.arguments
        if isinstance(instruction, ir.CallNamed):
            text = self.expressions.string(instruction.program)
            return self._call(
                lambda c: text(c).strip().lower(), arguments, following, cause, cause.span
            )
        name = instruction.program
        span = instruction.program_span or cause.span
        return self._call(lambda c: name, arguments, following, cause, span)

    def leave(self, instruction: ir.Return, *, implicit: bool) -> Step:
        """Return the step of RETURN; an implicit one is the end of the program's text."""
        skip = instruction.skip
        skipped = self.expressions.real(skip) if skip is not None else None
        return _return(skipped, implicit=implicit)

    def _call(
        self,
        name: Callable[[Context], str],
        arguments: tuple[Expression | Place | WholeArray | None, ...],
        following: int,
        cause: Cause,
        span: Span,
    ) -> Step:
        actuals = tuple(self._actual(argument) for argument in arguments)
        depth = self.call_depth

        def enter(c: Context) -> int:
            wanted = name(c)
            programs = c.system.programs
            number = programs.numbers.get(wanted)
            if number is None:
                raise RuntimeFault(
                    RuntimeErrorKind.UNDEFINED_PROGRAM,
                    f"there is no program `{wanted}`",
                    span,
                    data={"name": wanted},
                )
            if len(c.frames) > depth:
                raise RuntimeFault(
                    RuntimeErrorKind.STACK_FULL,
                    f"programs call each other more than {depth} deep",
                    span,
                    help=("let the calls come to an end, or use a loop",),
                )
            callee = programs.loaded[number].program
            if len(actuals) > len(callee.formals):
                raise RuntimeFault(
                    RuntimeErrorKind.ARGUMENT_MISMATCH,
                    f"`{callee.name}` takes {len(callee.formals)} arguments, not {len(actuals)}",
                    span,
                )
            slots: list[Bound] = []
            for k, formal in enumerate(callee.formals):
                bind = actuals[k] if k < len(actuals) else None
                if bind is None:
                    slots.append(fresh(callee, formal))
                    continue
                found = bind(c)
                if found.value.__class__ is not float or formal.type is not Type.REAL:
                    _check(found, formal, is_array=k in callee.array_formals, cause=cause)
                slots.append(found)
            slots += [fresh(callee, auto) for auto in callee.autos]
            c.frames[-1].index = following
            c.enter(programs.frame(number, slots))
            return SWITCHED

        return enter

    def _actual(self, argument: Expression | Place | WholeArray | None) -> Bind | None:
        match argument:
            case None:
                return None
            case WholeArray(variable=variable):
                return self.expressions.bound(variable, array=True)
            case Place():
                return self.expressions.cell(argument)
            case _:
                value = self.expressions.value(argument)

                def by_value(c: Context) -> Bound:
                    cell = Cell("argument")
                    cell.assign(value(c), c.finished)
                    return cell

                return by_value


def _return(skip: Real | None, *, implicit: bool) -> Step:
    def leave(c: Context) -> int:
        if len(c.frames) == 1:
            return CYCLE_ENDED
        frame = c.frames[-1]
        if frame.kind is FrameKind.ERROR and implicit:
            # an error program says how to go on [assumed, manual language/reactions#error-end]
            return CYCLE_ENDED
        steps = int(skip(c)) if skip is not None else 0
        left = c.leave()
        if left.kind is not FrameKind.CALL:
            note_progress(c)
        if steps > 0:
            _skip(c, steps)
        return SWITCHED

    return leave


def _skip(c: Context, steps: int) -> None:
    """Go on some steps later than after the call, as VAL's `RETURN n` does."""
    frame = c.frames[-1]
    program = c.system.programs.loaded[frame.program].program
    called = program.origins[frame.index - 1].step
    wanted = called + 1 + steps
    is_over = wanted > len(program.steps)  # there are not so many: the end of the program
    frame.index = len(program.instructions) - 1 if is_over else program.steps[wanted - 1]


def _check(found: Bound, formal: Slot, *, is_array: bool, cause: Cause) -> None:
    problem = None
    if isinstance(found, Array) is not is_array:
        problem = "an array" if isinstance(found, Array) else "no array"
    elif isinstance(found, Cell) and formal.type is not Type.DYNAMIC:
        value = found.value
        if isinstance(value, float | str | tuple) and type_of_value(value) is not formal.type:
            problem = f"a {type_of_value(value).value}"
    if problem is not None:
        raise RuntimeFault(
            RuntimeErrorKind.ARGUMENT_MISMATCH,
            f"argument `{formal.name}` takes a {formal.type.value} but is given {problem}",
            cause.span,
        )
