"""A module made ready to run: every program as a list of closures, and its memory's layout."""

from collections.abc import Callable, Collection
from dataclasses import dataclass
from typing import NamedTuple

from vrts.base.source import SourceFile, Span
from vrts.engine.code.step import Step
from vrts.engine.code.steps.steps import StepCompiler
from vrts.engine.code.values.evaluate import Compiler, Evaluate
from vrts.engine.code.values.extent import robot_only, simulates
from vrts.engine.code.values.places import Numbering
from vrts.engine.faults import RuntimeFault
from vrts.engine.machine.context import Context, Frame, FrameKind
from vrts.engine.machine.process import note_progress
from vrts.engine.memory.cells import UNDEFINED, Array, Bound, Cell, Memory
from vrts.engine.memory.events import Cause
from vrts.engine.outcomes import CYCLE_ENDED, SWITCHED
from vrts.ir import instructions as ir
from vrts.ir.expressions import Expression, Place, Slot, WholeArray
from vrts.ir.module import Module, Program
from vrts.ir.runtime_errors import RuntimeErrorKind
from vrts.ir.values import Type, type_of_value

Bind = Callable[[Context], Bound]
_NOWHERE = Span(SourceFile("", ""), 0, 0)
_NO_CAUSE = Cause("", 0, _NOWHERE)
_GONE = Program("", (), frozenset(), (), (), (), 0, 0, _NOWHERE)


@dataclass(frozen=True, slots=True)
class ExecutableProgram:
    """One program."""

    program: Program
    base: int  # number of its first instruction among those of all programs
    steps: tuple[Step, ...]
    causes: tuple[Cause, ...]  # beside steps


class Source(NamedTuple):
    """All that an executable is made of, as plain data."""

    call_depth: int
    programs: tuple[tuple[Program, int], ...]  # with the number of the first instruction
    instructions: int
    free: tuple[int, ...]
    numbers: dict[str, int]
    loaded: dict[str, Program]
    variables: tuple[str, ...]
    arrays: tuple[str, ...]


class Executable:
    """All programs in memory. Holds no state: runs share it."""

    def __init__(
        self, module: Module, call_depth: int, earlier: "Executable | None" = None
    ) -> None:
        """Compile every program; those of an earlier executable stay unless they are replaced."""
        self.call_depth = call_depth
        self._numbering: Numbering = Numbering() if earlier is None else earlier._numbering.copy()
        self._expressions = Compiler(self._numbering)
        self._steps = StepCompiler(self._expressions)
        self.programs: tuple[ExecutableProgram, ...] = () if earlier is None else earlier.programs
        self.numbers: dict[str, int] = {} if earlier is None else dict(earlier.numbers)
        self.causes: list[Cause] = [] if earlier is None else earlier.causes.copy()
        self._free: tuple[int, ...] = () if earlier is None else earlier._free
        programs = {} if earlier is None else dict(earlier.module.programs)
        programs.update(module.programs)
        data = module.data if earlier is None else (*earlier.module.data, *module.data)
        self.module = Module(programs, data)
        for datum in module.data:
            self._numbering.number(datum.name)
            if datum.subscripts:
                self._numbering.arrays.add(datum.name)
        for program in module.programs.values():
            self.numbers[program.name] = self._put(program)

    def without(self, names: tuple[str, ...]) -> "Executable":
        """Return an executable in which some programs are no longer known."""
        other = Executable(Module({}, ()), self.call_depth, self)
        for name in names:
            other.numbers.pop(name, None)
        left = {k: p for k, p in self.module.programs.items() if k not in names}
        other.module = Module(left, self.module.data)
        return other

    @property
    def source(self) -> Source:
        """What `remade` makes the same of."""
        return Source(
            self.call_depth,
            tuple((known.program, known.base) for known in self.programs),
            len(self.causes),
            self._free,
            dict(self.numbers),
            dict(self.module.programs),
            tuple(self._numbering.numbers),
            tuple(sorted(self._numbering.arrays)),
        )

    @classmethod
    def remade(cls, source: Source) -> "Executable":
        """Return an executable of what another one was made of."""
        found = cls(Module({}, ()), source.call_depth)
        found._numbering.arrays.update(source.arrays)
        for name in source.variables:
            found._numbering.number(name)
        found.causes = [_NO_CAUSE] * source.instructions
        for program, base in source.programs:
            ready = found._program(program, base)
            found.programs = (*found.programs, ready)
            found.causes[base : base + len(ready.causes)] = ready.causes
        found.numbers, found._free = dict(source.numbers), source.free
        found.module = Module(source.loaded, ())
        return found

    def only(self, used: Collection[int]) -> "Executable":
        """Return an executable without the code of programs that nothing can reach any more.

        The others keep their numbers; what is free is used again for programs to come.

        Args:
            used: Numbers of programs that are being executed, or that a history tells of.
        """
        reached = {*used, *self.numbers.values()}
        if reached.issuperset(range(len(self.programs))):
            return self
        other = Executable(Module({}, ()), self.call_depth, self)
        other.module = Module(self.module.programs, ())  # what is in memory is known there
        count = max(reached, default=-1) + 1
        other.programs = tuple(
            program if number in reached else ExecutableProgram(_GONE, program.base, (), ())
            for number, program in enumerate(self.programs[:count])
        )
        if count < len(self.programs):
            del other.causes[self.programs[count].base :]
        other._free = tuple(number for number in range(count) if number not in reached)
        for number in other._free:
            base, end = other._room(number)
            other.causes[base:end] = [_NO_CAUSE] * (end - base)
        return other

    def memory(self) -> Memory:
        """Return fresh memory that holds the module's data."""
        memory = Memory(self._numbering.bound())
        self.load(self.module, memory, 0)
        return memory

    def extend(self, memory: Memory) -> None:
        """Give memory the variables that it does not have yet."""
        fresh = self._numbering.bound()
        for k, bound in enumerate(memory.bound):
            if isinstance(fresh[k], Array) and isinstance(bound, Cell) and bound.value is UNDEFINED:
                memory.bound[k] = fresh[k]
        memory.bound += fresh[len(memory.bound) :]

    def load(self, module: Module, memory: Memory, finished: int) -> None:
        """Give memory the values of a module's data sections."""
        for datum in module.data:
            self.variable(memory, datum.name, datum.subscripts).assign(datum.value, finished)

    def variable(self, memory: Memory, name: str, subscripts: tuple[int, ...]) -> Cell:
        """Return the cell of a variable, making it when it is new."""
        if subscripts:
            self._numbering.arrays.add(name)
        number = self._numbering.number(name)
        self.extend(memory)
        bound = memory.bound[number]
        if subscripts:
            if isinstance(bound, Cell):
                bound = memory.bound[number] = Array(name)
            return bound.element(subscripts)
        if isinstance(bound, Array):
            bound = memory.bound[number] = Cell(name)
        return bound

    def bound(self, memory: Memory, name: str) -> Bound | None:
        """Return what a name stands for; None when it was never spoken of."""
        number = self._numbering.numbers.get(name)
        return memory.bound[number] if number is not None else None

    def frame(self, number: int, slots: list[Bound] | None = None) -> Frame:
        """Return a frame at the start of a program; without slots as called without arguments."""
        program = self.programs[number].program
        if slots is None:
            slots = [_fresh(program, slot) for slot in (*program.formals, *program.autos)]
        return Frame(number, slots, program.loops, program.cases)

    def _put(self, program: Program) -> int:
        """Take a program in, where there is room; return its number."""
        size = len(program.origins)
        for number in self._free:
            base, end = self._room(number)
            if end - base >= size:
                self._free = tuple(free for free in self._free if free != number)
                ready = self._program(program, base)
                self.causes[base : base + size] = ready.causes
                self.programs = (*self.programs[:number], ready, *self.programs[number + 1 :])
                return number
        ready = self._program(program, len(self.causes))
        self.causes += ready.causes
        self.programs = (*self.programs, ready)
        return len(self.programs) - 1

    def _room(self, number: int) -> tuple[int, int]:
        """Return the numbers of the instructions that belong to a program, whatever its size."""
        following = self.programs[number + 1 : number + 2]
        end = following[0].base if following else len(self.causes)
        return self.programs[number].base, end

    def _program(self, program: Program, base: int) -> ExecutableProgram:
        causes = tuple(Cause(program.name, step, span) for step, span in program.origins)
        steps = tuple(
            self._step(instruction, index, cause, len(causes))
            for index, (instruction, cause) in enumerate(
                zip(program.instructions, causes, strict=True)
            )
        )
        return ExecutableProgram(program, base, steps, causes)

    def _step(self, instruction: ir.Instruction, index: int, cause: Cause, count: int) -> Step:
        match instruction:
            case ir.Call(program=name, arguments=arguments):
                span = instruction.program_span or cause.span
                return self._call(lambda c: name, arguments, index + 1, cause, span)
            case ir.CallNamed(program=named, arguments=arguments):
                text = self._expressions.string(named)
                return self._call(
                    lambda c: text(c).strip().lower(), arguments, index + 1, cause, cause.span
                )
            case ir.Return(skip=skip):
                skipped = self._expressions.real(skip) if skip is not None else None
                return _return(skipped, implicit=index == count - 1)
            case _:
                step = self._steps.step(instruction, index, cause)
                if not robot_only(instruction) or not simulates(instruction):
                    return step
                return _for_robot(step, cause)

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
            executable = c.system.executable
            number = executable.numbers.get(wanted)
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
            callee = executable.programs[number].program
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
                    slots.append(_fresh(callee, formal))
                    continue
                found = bind(c)
                if found.value.__class__ is not float or formal.type is not Type.REAL:
                    _check(found, formal, is_array=k in callee.array_formals, cause=cause)
                slots.append(found)
            slots += [_fresh(callee, auto) for auto in callee.autos]
            c.frames[-1].index = following
            c.enter(executable.frame(number, slots))
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
                    cell.assign(value(c), c.finished)
                    return cell

                return by_value


def _return(skip: Callable[[Context], float] | None, *, implicit: bool) -> Step:
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
    program = c.system.executable.programs[frame.program].program
    called = program.origins[frame.index - 1].step
    wanted = called + 1 + steps
    is_over = wanted > len(program.steps)  # there are not so many: the end of the program
    frame.index = len(program.instructions) - 1 if is_over else program.steps[wanted - 1]


def _for_robot(step: Step, cause: Cause) -> Step:
    """Return the step of a robot instruction."""
    refused = refusal_of_process(cause)

    def guarded(c: Context) -> int:
        if not c.is_robot:
            return refused(c)
        if not c.system.powered:
            raise RuntimeFault(
                RuntimeErrorKind.ROBOT_POWER_OFF,
                "the arm has no power",
                cause.span,
                help=("`ENABLE POWER` turns it on again",),
            )
        return step(c)

    return guarded


def refusal_of_process(cause: Cause) -> Step:
    """Return what a robot instruction does in a process control program."""

    def refuse(c: Context) -> int:
        raise RuntimeFault(
            RuntimeErrorKind.ILLEGAL_IN_PROCESS,
            f"`{cause.span.text}` moves the robot; a process control program may not",
            cause.span,
            help=("set a signal here, and let the robot program wait for it",),
        )

    return refuse


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
