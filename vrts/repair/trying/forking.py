"""Where a candidate begins: with the run that it shares, before the first step that differs."""

from bisect import bisect_right
from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple, TypeAlias, cast

from vrts.base.source import Span
from vrts.engine.instead import instead
from vrts.engine.memory.records import Ending
from vrts.engine.run import Run
from vrts.engine.statements import statements
from vrts.ir.expressions import Global
from vrts.ir.instructions import Instruction
from vrts.ir.module import Datum, Module, Program

Bare: TypeAlias = tuple[object, ...]


class _Differs(NamedTuple):
    """What two modules do not have in common."""

    programs: Mapping[str, int]  # and from which instruction on
    data: tuple[Datum, ...]


class Shared:
    """A run with the states on its way from which others may go on."""

    def __init__(self, runs: Sequence[Run]) -> None:
        """Take the same run again and again, each time farther."""
        self._runs = [run for run in runs if run.ending is Ending.RUNNING]
        last = runs[-1]
        history = last.history
        self._module = last.module
        self._bare = {name: _code(p) for name, p in last.module.programs.items()}
        self._first: dict[str, list[tuple[int, int]]] = {}  # of programs: instructions, statements
        self._mentions: dict[str, int] = {}  # of variables: the first statement
        if not any(statement.process for statement in statements(history, 0, history.finished)):
            self._look(last)
        else:
            self._runs = []

    def _look(self, run: Run) -> None:
        """Find when each program comes farther than before, and when a variable is named."""
        code = run.history.code
        farthest: dict[str, int] = {}
        seen: set[int] = set()
        for number, at in enumerate(run.history.robot.trace.instructions, 1):
            if at in seen:
                continue
            seen.add(at)
            k = bisect_right(code.bases, at) - 1
            program = code.programs[k]
            index = at - code.bases[k]
            for name in _named(program.instructions[index]):
                self._mentions.setdefault(name, number)
            if index > farthest.get(program.name, -1):
                farthest[program.name] = index
                self._first.setdefault(program.name, []).append((index, number))

    def before(self, module: Module) -> Run | None:
        """Return the run of other programs as far as it is the same; None: from its beginning."""
        if not self._runs:
            return None
        differs = self._differs(module)
        if differs is None:
            return None
        first = [self._reached(name, index) for name, index in differs.programs.items()]
        first += [self._mentions.get(datum.name) for datum in differs.data]
        # the statement before the first that differs may be under way
        last = min((n for n in first if n is not None), default=self._runs[-1].statements + 2) - 2
        shared = [run for run in self._runs if run.statements <= last]
        if not shared:
            return None
        return instead(shared[-1], module, differs.programs, differs.data)

    def _reached(self, name: str, index: int) -> int | None:
        """Return the first statement of a program from an instruction on."""
        return next((n for at, n in self._first.get(name, ()) if at >= index), None)

    def _differs(self, module: Module) -> _Differs | None:
        mine = self._module
        if list(module.programs) != list(mine.programs):
            return None
        programs: dict[str, int] = {}
        for name, program in module.programs.items():
            one, other = self._bare[name], _code(program)
            if one != other:
                head = one[0] == other[0]
                programs[name] = _same(one[1:], other[1:]) if head else 0
                if not head and self._reached(name, 0) is not None:
                    return None
        before = {(d.name, d.subscripts): d.value for d in mine.data}
        after = {(d.name, d.subscripts): d for d in module.data}
        if not before.keys() <= after.keys() or len(after) < len(module.data):
            return None
        changed = [d for key, d in after.items() if key not in before or before[key] != d.value]
        return _Differs(programs, tuple(changed))


def _same(one: Sequence[object], other: Sequence[object]) -> int:
    """Return how many are the same from the first on."""
    count = 0
    for a, b in zip(one, other, strict=False):
        if a != b:
            break
        count += 1
    return count


def _code(program: Program) -> Bare:
    """Return what a program does, without where it stands: its frame, then its instructions."""
    head = (program.formals, program.array_formals, program.autos, program.loops, program.cases)
    return (_bare(head), *(_bare(instruction) for instruction in program.instructions))


def _bare(node: object) -> object:
    if isinstance(node, Span):
        return None
    if isinstance(node, tuple):
        parts = cast("tuple[object, ...]", node)
        return (type(parts).__name__, *map(_bare, parts))
    return node


def _named(node: Instruction | object) -> Iterator[str]:
    """Yield the global variables that an instruction names."""
    if isinstance(node, Global):
        yield node.name
    elif isinstance(node, tuple) and not isinstance(node, Span):
        for part in cast("tuple[object, ...]", node):
            yield from _named(part)
