"""A module made ready to run: every program as a list of closures, and its memory's layout."""

from collections.abc import Collection
from typing import NamedTuple

from vrts.base.source import SourceFile, Span
from vrts.engine.code.closures import Step
from vrts.engine.code.layout import Layout
from vrts.engine.code.steps.compile_step import StepCompiler
from vrts.engine.code.values.evaluate import compiler
from vrts.engine.memory.cells import Memory
from vrts.engine.memory.events import Cause
from vrts.engine.programs.loaded import Loaded, Programs
from vrts.ir.module import Module, Program

_NOWHERE = Span(SourceFile("", ""), 0, 0)
_NO_CAUSE = Cause("", 0, _NOWHERE)
_GONE = Program("", (), frozenset(), (), (), (), 0, 0, _NOWHERE)


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
    """All programs in memory with their steps. Holds no state: runs share it."""

    def __init__(
        self, module: Module, call_depth: int, earlier: "Executable | None" = None
    ) -> None:
        """Compile every program; those of an earlier executable stay unless they are replaced."""
        self.call_depth = call_depth
        self.layout: Layout = Layout() if earlier is None else earlier.layout.copy()
        self._compiler = StepCompiler(compiler(self.layout), call_depth)
        self.steps: tuple[tuple[Step, ...], ...] = () if earlier is None else earlier.steps
        self.programs: Programs = (
            Programs((), {}, []) if earlier is None else earlier.programs.copy()
        )
        self._free: tuple[int, ...] = () if earlier is None else earlier._free
        programs = {} if earlier is None else dict(earlier.module.programs)
        programs.update(module.programs)
        data = module.data if earlier is None else (*earlier.module.data, *module.data)
        self.module = Module(programs, data)
        for datum in module.data:
            self.layout.number(datum.name)
            if datum.subscripts:
                self.layout.arrays.add(datum.name)
        for program in module.programs.values():
            self.programs.numbers[program.name] = self._put(program)

    def without(self, names: tuple[str, ...]) -> "Executable":
        """Return an executable in which some programs are no longer known."""
        other = Executable(Module({}, ()), self.call_depth, self)
        for name in names:
            other.programs.numbers.pop(name, None)
        left = {k: p for k, p in self.module.programs.items() if k not in names}
        other.module = Module(left, self.module.data)
        return other

    @property
    def source(self) -> Source:
        """What `remade` makes the same of."""
        return Source(
            self.call_depth,
            tuple((known.program, known.base) for known in self.programs.loaded),
            len(self.programs.causes),
            self._free,
            dict(self.programs.numbers),
            dict(self.module.programs),
            tuple(self.layout.numbers),
            tuple(sorted(self.layout.arrays)),
        )

    @classmethod
    def remade(cls, source: Source) -> "Executable":
        """Return an executable of what another one was made of."""
        found = cls(Module({}, ()), source.call_depth)
        found.layout.arrays.update(source.arrays)
        for name in source.variables:
            found.layout.number(name)
        found.programs.causes = [_NO_CAUSE] * source.instructions
        for number, (program, base) in enumerate(source.programs):
            found._place(number, program, base)
        found.programs.numbers, found._free = dict(source.numbers), source.free
        found.module = Module(source.loaded, ())
        return found

    def only(self, used: Collection[int]) -> "Executable":
        """Return an executable without the code of programs that nothing can reach any more.

        The others keep their numbers; what is free is used again for programs to come.

        Args:
            used: Numbers of programs that are being executed, or that a history tells of.
        """
        mine = self.programs
        reached = {*used, *mine.numbers.values()}
        if reached.issuperset(range(len(mine.loaded))):
            return self
        other = Executable(Module({}, ()), self.call_depth, self)
        other.module = Module(self.module.programs, ())  # what is in memory is known there
        count = max(reached, default=-1) + 1
        theirs = other.programs
        theirs.loaded = tuple(
            known if number in reached else Loaded(_GONE, known.base, ())
            for number, known in enumerate(mine.loaded[:count])
        )
        other.steps = tuple(
            steps if number in reached else () for number, steps in enumerate(self.steps[:count])
        )
        if count < len(mine.loaded):
            del theirs.causes[mine.loaded[count].base :]
        other._free = tuple(number for number in range(count) if number not in reached)
        for number in other._free:
            base, end = theirs.room(number)
            theirs.causes[base:end] = [_NO_CAUSE] * (end - base)
        return other

    def memory(self) -> Memory:
        """Return fresh memory that holds the module's data."""
        memory = Memory(self.layout.fresh())
        self.load(self.module, memory, 0)
        return memory

    def load(self, module: Module, memory: Memory, finished: int) -> None:
        """Give memory the values of a module's data sections."""
        for datum in module.data:
            self.layout.variable(memory, datum.name, datum.subscripts).assign(datum.value, finished)

    def _put(self, program: Program) -> int:
        """Take a program in, where there is room; return its number."""
        size = len(program.origins)
        for number in self._free:
            base, end = self.programs.room(number)
            if end - base >= size:
                self._free = tuple(free for free in self._free if free != number)
                self._place(number, program, base)
                return number
        number = len(self.programs.loaded)
        self._place(number, program, len(self.programs.causes))
        return number

    def _place(self, number: int, program: Program, base: int) -> None:
        """Compile a program, and know it by a number and from an instruction on."""
        causes = tuple(Cause(program.name, step, span) for step, span in program.origins)
        steps = tuple(
            self._compiler.step(instruction, index, cause, len(causes))
            for index, (instruction, cause) in enumerate(
                zip(program.instructions, causes, strict=True)
            )
        )
        known = self.programs
        before, after = known.loaded[:number], known.loaded[number + 1 :]
        known.loaded = (*before, Loaded(program, base, causes), *after)
        known.causes[base : base + len(causes)] = causes
        self.steps = (*self.steps[:number], steps, *self.steps[number + 1 :])
