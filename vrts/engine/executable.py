"""A module made ready to run: every program as a list of closures, and its memory's layout."""

from collections.abc import Callable
from dataclasses import dataclass

from vrts.engine.cells import Array, Bound, Cell, Memory
from vrts.engine.context import Context, Frame
from vrts.engine.evaluate import Compiler, Evaluate, Numbering
from vrts.engine.events import Cause
from vrts.engine.faults import RuntimeFault
from vrts.engine.outcomes import CYCLE_ENDED, SWITCHED
from vrts.engine.step import Step
from vrts.engine.steps import StepCompiler
from vrts.ir import instructions as ir
from vrts.ir.expressions import Expression, Place, Slot, WholeArray
from vrts.ir.module import Module, Program
from vrts.ir.runtime_errors import RuntimeErrorKind
from vrts.ir.values import Type, type_of_value

Bind = Callable[[Context], Bound]


@dataclass(frozen=True, slots=True)
class ExecutableProgram:
    """One program."""

    program: Program
    steps: tuple[Step, ...]
    causes: tuple[Cause, ...]  # beside steps


class Executable:
    """All programs of a module. Holds no state: runs share it."""

    def __init__(self, module: Module, call_depth: int) -> None:
        """Compile every program."""
        self.module = module
        self.call_depth = call_depth
        self.numbers = {name: k for k, name in enumerate(module.programs)}
        self._numbering = Numbering()
        self._expressions = Compiler(self._numbering)
        self._steps = StepCompiler(self._expressions)
        for datum in module.data:
            self._numbering.number(datum.name)
            if datum.subscripts:
                self._numbering.arrays.add(datum.name)
        self.programs = tuple(self._program(program) for program in module.programs.values())
        self.names = tuple(self._numbering.numbers)

    def memory(self) -> Memory:
        """Return fresh memory that holds the module's data."""
        bound = self._numbering.bound()
        for datum in self.module.data:
            found = bound[self._numbering.number(datum.name)]
            cell = found.element(datum.subscripts) if isinstance(found, Array) else found
            cell.assign(datum.value, 0.0)
        return Memory(bound)

    def frame(self, number: int, slots: list[Bound]) -> Frame:
        """Return a frame at the start of a program."""
        program = self.programs[number].program
        return Frame(number, slots, program.loops, program.cases)

    def fresh_slots(self, number: int) -> list[Bound]:
        """Return slots of a program called without arguments."""
        program = self.programs[number].program
        return [_fresh(program, slot) for slot in (*program.formals, *program.autos)]

    def _program(self, program: Program) -> ExecutableProgram:
        causes = tuple(Cause(program.name, step, span) for step, span in program.origins)
        steps = tuple(
            self._step(instruction, index, cause)
            for index, (instruction, cause) in enumerate(
                zip(program.instructions, causes, strict=True)
            )
        )
        return ExecutableProgram(program, steps, causes)

    def _step(self, instruction: ir.Instruction, index: int, cause: Cause) -> Step:
        match instruction:
            case ir.Call():
                return self._call(instruction, index + 1, cause)
            case ir.Return(skip=None):
                return _return
            case _:
                return self._steps.step(instruction, index, cause)

    def _call(self, call: ir.Call, following: int, cause: Cause) -> Step:
        number = self.numbers.get(call.program)
        span = call.program_span or cause.span
        if number is None:

            def unknown(c: Context) -> int:
                raise RuntimeFault(
                    RuntimeErrorKind.UNDEFINED_PROGRAM,
                    f"there is no program `{call.program}`",
                    span,
                    data={"name": call.program},
                )

            return unknown
        actuals = tuple(self._actual(argument) for argument in call.arguments)
        callee = self.module.programs[call.program]
        depth = self.call_depth

        def enter(c: Context) -> int:
            if len(c.frames) > depth:
                raise RuntimeFault(
                    RuntimeErrorKind.STACK_FULL,
                    f"programs call each other more than {depth} deep",
                    span,
                    help=("let the calls come to an end, or use a loop",),
                )
            if len(actuals) > len(callee.formals):
                raise RuntimeFault(
                    RuntimeErrorKind.ARGUMENT_MISMATCH,
                    f"`{callee.name}` takes {len(callee.formals)} arguments, not {len(actuals)}",
                    span,
                )
            slots: list[Bound] = []
            for k, formal in enumerate(callee.formals):
                bind = actuals[k] if k < len(actuals) else None
                found = _fresh(callee, formal) if bind is None else bind(c)
                _check(found, formal, is_array=k in callee.array_formals, cause=cause)
                slots.append(found)
            slots += [_fresh(callee, auto) for auto in callee.autos]
            c.frames[-1].index = following
            c.frames.append(self.frame(number, slots))
            c.slots = slots
            return SWITCHED

        return enter

    def _actual(self, argument: Expression | Place | WholeArray | None) -> Bind | None:
        match argument:
            case None:
                return None
            case WholeArray(variable=variable):
                return self._expressions.bound(variable, array=True)
            case Place():
                return self._expressions.cell(argument)
            case _:
                value: Evaluate = self._expressions.value(argument)

                def by_value(c: Context) -> Bound:
                    cell = Cell("argument")
                    cell.assign(value(c), c.now)
                    return cell

                return by_value


def _return(c: Context) -> int:
    if len(c.frames) == 1:
        return CYCLE_ENDED
    c.frames.pop()
    c.slots = c.frames[-1].slots
    return SWITCHED


def _fresh(program: Program, slot: Slot) -> Bound:
    return Array(slot.name) if slot.number in program.array_formals else Cell(slot.name)


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
