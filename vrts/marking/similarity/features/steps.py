"""A program as one list of steps without disguise: calls put in place, loops alike, filler gone."""

from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple, cast

from vrts.ir.control import BeginFor, Call, Jump, JumpIf, NextFor, Return, TestCase, TestFor
from vrts.ir.data import Assign, Prompt, Type
from vrts.ir.expressions import Binary, BinaryOperator, Constant, Load, Place, Slot
from vrts.ir.instructions import Instruction
from vrts.ir.module import Module, Program
from vrts.ir.motion import Break, Delay, Depart, Draw, Drive, Move, SetSpeed
from vrts.marking.similarity.features.expressions import (
    EXPRESSIONS,
    Known,
    constant_of,
    given_of,
    spelled,
    variables_in,
)

MOST_STEPS = 2_500  # of a program, calls put in place
DEEPEST = 8  # calls in calls that are put in place
MOST_WORK = 300_000  # nodes of instructions that are visited, over and over where calls repeat them
LARGEST = 4_000  # nodes of an instruction; a larger one is left out
LONGEST = 4_000  # characters of an instruction that are compared
MOST_NUMBERS = 64  # of an instruction
LEAST_WAIT_S = 0.05  # a shorter DELAY is filler
_NOTHING = (Jump, Return, Break, Type)  # structure alone, or what only people see


class Step(NamedTuple):
    """What one instruction does."""

    name: str  # of the instruction, with its plain operands
    shape: str  # the same with its expressions, numbers left out
    exact: str  # the same with numbers
    numbers: tuple[float, ...]  # constants in it
    speed: str  # in force, for motions; "": it is no motion
    loops: int  # how deep in loops and branches it stands
    line: int  # of the file


class _Outline(NamedTuple):
    """What is asked of a program at each call."""

    loops: Sequence[int]  # how deep each instruction stands
    limits: Mapping[int, BeginFor]  # by loop
    sizes: Sequence[int]  # nodes of each instruction


class _Context(NamedTuple):
    """What is known in an activation."""

    known: Known
    depth: int
    loops: int
    path: tuple[str, ...]  # programs being executed


def steps_of(module: Module) -> tuple[Step, ...]:
    """Return the steps of a module, from the program that is executed on.

    Programs that nothing calls are left out, unless it is not known which one is executed.
    """
    entry = module.main
    programs = [entry] if entry is not None else list(module.programs)
    writer = _Writer(module, programs)
    for name in programs:
        writer.write(name)
    return tuple(writer.steps)


class _Writer:
    def __init__(self, module: Module, programs: Sequence[str]) -> None:
        self._module = module
        self.steps: list[Step] = []
        self._left = MOST_WORK
        self._outlines: dict[str, _Outline] = {}
        self._speed, self._once = "", ""
        reached = _reached(module, programs)
        flat = [one for program in reached for one in program.instructions]
        self._read = _read(flat)
        self._constants = _constants(module, flat)

    def write(self, name: str) -> None:
        known = Known(self._constants)
        self._program(name, _Context(known, 0, 0, (name,)))

    def _program(self, name: str, context: _Context) -> None:
        program = self._module.programs.get(name)
        if program is None:
            return
        if name not in self._outlines:
            self._outlines[name] = _outline(program)
        loops, limits, sizes = self._outlines[name]
        for number, (one, origin) in enumerate(
            zip(program.instructions, program.origins, strict=True)
        ):
            self._left -= min(sizes[number], LARGEST)
            if len(self.steps) >= MOST_STEPS or self._left <= 0:
                return
            if sizes[number] > LARGEST:
                continue
            inner = context._replace(loops=context.loops + loops[number])
            if isinstance(one, Call) and self._goes_in(one, inner):
                given = tuple(given_of(argument, inner.known) for argument in one.arguments)
                known = Known(self._constants, given)
                path = (*inner.path, one.program)
                self._program(one.program, _Context(known, inner.depth + 1, inner.loops, path))
                continue
            for plain in _plain(one, limits):
                self._step(plain, inner, origin.span.line)

    def _goes_in(self, call: Call, context: _Context) -> bool:
        return (
            context.depth < DEEPEST
            and call.program not in context.path
            and call.program in self._module.programs
        )

    def _step(self, one: "Instruction", context: _Context, line: int) -> None:
        if isinstance(one, SetSpeed):
            text = f"{spelled(one.value, context.known, numbers=True)}{one.unit.value}"
            if one.scope.value == "next":
                self._once = text
            else:
                self._speed = text
            return
        if self._is_filler(one, context.known):
            return
        name, shape, exact, numbers = _told(one, context.known)
        moves = isinstance(one, Move | Depart | Draw | Drive)
        speed = (self._once or self._speed or "100percent") if moves else ""
        if moves:
            self._once = ""
        self.steps.append(Step(name, shape, exact, numbers, speed, min(context.loops, 4), line))

    def _is_filler(self, one: object, known: Known) -> bool:
        if isinstance(one, _NOTHING):
            return True
        if isinstance(one, Assign):
            variable = one.place.variable
            if isinstance(variable, Slot):
                return False
            return variable.name not in self._read or (
                not one.place.subscripts and variable.name in self._constants
            )
        if isinstance(one, JumpIf):
            return constant_of(one.condition, known) is not None
        if not isinstance(one, Delay):
            return False
        waits = constant_of(one.time, known)
        return waits is not None and waits <= LEAST_WAIT_S


def _reached(module: Module, programs: Sequence[str]) -> list[Program]:
    """Return programs and all that they name."""
    found: dict[str, Program] = {}
    left = list(programs)
    while left:
        name = left.pop()
        if name in found or name not in module.programs:
            continue
        found[name] = module.programs[name]
        for one in found[name].instructions:
            named = getattr(one, "program", None)
            if isinstance(named, str):
                left.append(named)
    return list(found.values())


def _read(flat: Sequence[Instruction]) -> frozenset[str]:
    """Return the variables whose values reach anything but other variables, and what is typed."""
    live: set[str] = set()
    feeds: defaultdict[str, set[str]] = defaultdict(set)  # what each variable is made of
    for one in flat:
        if isinstance(one, Type):
            continue
        if isinstance(one, Assign) and not isinstance(one.place.variable, Slot):
            feeds[one.place.variable.name] |= _read_by(one)
        else:
            live |= _read_by(one)
    left = list(live)
    while left:
        new = feeds.pop(left.pop(), set[str]()) - live
        live |= new
        left += new
    return frozenset(live)


def _read_by(one: Instruction) -> frozenset[str]:
    if isinstance(one, Assign):
        return variables_in((*one.place.subscripts, one.value))
    if isinstance(one, BeginFor | NextFor):
        return frozenset[str]().union(*(variables_in(x) for x in one[1:] if isinstance(x, tuple)))
    if isinstance(one, Prompt):
        return frozenset()
    return frozenset[str]().union(*(variables_in(part) for part in one if isinstance(part, tuple)))


def _constants(module: Module, flat: Sequence[Instruction]) -> dict[str, float]:
    """Return the reals that have one value for ever."""
    values: dict[str, set[float | None]] = {}
    for datum in module.data:
        if not datum.subscripts and isinstance(datum.value, float):
            values.setdefault(datum.name, set()).add(datum.value)
    for one in flat:
        for part in one:
            if not isinstance(part, Place) or isinstance(part.variable, Slot):
                continue
            value = one.value if isinstance(one, Assign) else None
            known = value.value if isinstance(value, Constant) else None
            number = known if isinstance(known, float) and not part.subscripts else None
            values.setdefault(part.variable.name, set()).add(number)
        if isinstance(one, Prompt):
            for place in one.places:
                if not isinstance(place.variable, Slot):
                    values.setdefault(place.variable.name, set()).add(None)
    found: dict[str, float] = {}
    for name, numbers in values.items():
        (one, *more) = numbers
        if one is not None and not more:
            found[name] = one
    return found


def _outline(program: Program) -> _Outline:
    limits = _limits(program)
    sizes = [
        _size(one) + (_size(limits[one.loop]) if isinstance(one, TestFor | NextFor) else 0)
        for one in program.instructions
    ]
    return _Outline(_loops(program), limits, sizes)


def _size(one: Instruction) -> int:
    """Return how many nodes an instruction has."""
    count = 0
    left: list[object] = [one]
    while left:
        node = left.pop()
        count += 1
        if isinstance(node, tuple):
            left.extend(cast("tuple[object, ...]", node))
    return count


def _loops(program: Program) -> list[int]:
    """Return how many jumps, back or over it, each instruction stands between."""
    change = [0] * (len(program.instructions) + 1)
    for number, one in enumerate(program.instructions):
        target = None
        if isinstance(one, JumpIf):
            target = one.target
        elif isinstance(one, TestFor):
            target = one.leave
        elif isinstance(one, TestCase):
            target = one.otherwise
        if target is not None and target > number:
            change[number + 1] += 1
            change[min(target, len(change) - 1)] -= 1
    found: list[int] = []
    depth = 0
    for step in change[:-1]:
        depth += step
        found.append(depth)
    return found


def _limits(program: Program) -> dict[int, BeginFor]:
    return {one.loop: one for one in program.instructions if isinstance(one, BeginFor)}


def _plain(one: Instruction, loops: Mapping[int, BeginFor]) -> Iterator[Instruction]:
    """Yield an instruction, or what a FOR does in the words of a WHILE."""
    match one:
        case BeginFor(place, first):
            yield Assign(place, first)
        case TestFor(place, loop):
            inside = Binary(BinaryOperator.LESS_EQUAL, Load(place), loops[loop].last)
            yield JumpIf(inside, when=False, target=0)
        case NextFor(place, loop):
            by = loops[loop].increment or Constant(1.0)
            yield Assign(place, Binary(BinaryOperator.ADD, Load(place), by))
        case _:
            yield one


def _told(one: Instruction, known: Known) -> tuple[str, str, str, tuple[float, ...]]:
    """Return name, shape, exact shape and numbers of an instruction."""
    name = type(one).__name__
    plain: list[str] = []
    shapes: list[str] = []
    exact: list[str] = []
    numbers: list[float] = []
    for field, part in zip(one._fields, one, strict=True):
        if field in ("target", "otherwise", "case", "program_span", "program") and isinstance(
            part, int | str | None
        ):
            continue
        if isinstance(part, (*EXPRESSIONS, Place)) or part is None:
            shapes.append(spelled(part, known, numbers=False))
            exact.append(spelled(part, known, numbers=True))
            value = None if part is None else constant_of(part, known)
            if value is not None:
                numbers.append(value)
        elif isinstance(part, tuple):
            for inner in part:
                if isinstance(inner, tuple) or inner is None:
                    shapes.append(spelled(inner, known, numbers=False))
                    exact.append(spelled(inner, known, numbers=True))
                    value = constant_of(inner, known)
                    if value is not None:
                        numbers.append(value)
        else:
            plain.append(str(getattr(part, "value", part)))
    head = " ".join([name, *plain])[:LONGEST]
    if isinstance(one, Move) and one.retreat is not None:
        head += " above"
    shape, spelled_out = f"{head}({';'.join(shapes)})", f"{head}({';'.join(exact)})"
    return head, shape[:LONGEST], spelled_out[:LONGEST], tuple(numbers[:MOST_NUMBERS])
