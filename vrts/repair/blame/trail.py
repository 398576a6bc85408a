"""What every executed step read, who wrote it last, and which step called it."""

from bisect import bisect_right
from collections.abc import Iterator, Mapping
from typing import NamedTuple, cast

from vrts.engine.memory.cells import Array, Bound, Cell
from vrts.engine.memory.events import Cause
from vrts.engine.memory.trace import Activation
from vrts.engine.run import Run
from vrts.engine.statements import statements
from vrts.ir.expressions import Constant, Load, Place, Slot
from vrts.ir.instructions import Instruction
from vrts.ir.motion import Align, Depart, Draw, Drive, Grasp, Move, Nest, Ready

MOTIONS = (Move, Depart, Drive, Draw, Align, Ready, Nest, Grasp)


class Executed(NamedTuple):
    """A step as it was executed by the robot program."""

    number: int  # statements finished with it
    line: int
    instruction: Instruction
    at: int  # number of the instruction among all
    activation: Activation | None


class Written(NamedTuple):
    """Where a value that a step read was written."""

    line: int | None  # of a data section
    step: int | None  # index of the executed step


class Trail:
    """The steps that a run's robot program executed, in their order."""

    def __init__(self, run: Run) -> None:
        """Look at a run."""
        history = run.history
        self.run = run
        self._globals: Mapping[str, Bound] = {b.name: b for b in history.memory.bound}
        self._data = {_element(d.name, d.subscripts): d.span.line for d in run.module.data}
        code, trace = history.code, history.robot.trace
        numbers = [s.number for s in statements(history, 0, history.finished) if not s.process]
        self.steps: list[Executed] = []
        for number, at in zip(numbers, trace.instructions, strict=False):
            k = bisect_right(code.bases, at) - 1
            program = code.programs[k]
            index = at - code.bases[k]
            line = program.origins[index].span.line
            activation = trace.activation(number - 1)
            self.steps.append(Executed(number, line, program.instructions[index], at, activation))
        self._by_number = {step.number: k for k, step in enumerate(self.steps)}
        self.motion_steps = self._motions()

    @property
    def lines(self) -> frozenset[int]:
        """Lines of steps that were executed."""
        return frozenset(step.line for step in self.steps)

    def _motions(self) -> dict[int, int]:
        """Return for each motion the executed step that asked for it."""
        found: dict[int, int] = {}
        asking = [k for k, step in enumerate(self.steps) if isinstance(step.instruction, MOTIONS)]
        at = 0
        for number, motion in enumerate(self.run.motions):
            line = motion.cause.span.line
            while at < len(asking) and self.steps[asking[at]].line != line:
                at += 1
            if at == len(asking):
                break
            found[number] = asking[at]
            at += 1
        return found

    def reads(self, k: int) -> Iterator[Written]:
        """Yield where the values were written that a step read."""
        step = self.steps[k]
        target = getattr(step.instruction, "place", None)
        for place in _places(tuple(x for x in _fields(step.instruction) if x is not target)):
            cell = self._cell(place, step)
            if cell is None:
                continue
            found = bisect_right(cell.since, step.number - 1)
            if not found:
                continue
            since = cell.since[found - 1]
            if since == 0:
                yield Written(self._data.get(cell.name), None)
            elif since in self._by_number:
                yield Written(None, self._by_number[since])

    def unknown(self, k: int) -> Iterator[str]:
        """Yield the names of variables, or their arrays, that a step read and that had no value."""
        step = self.steps[k]
        for place in _places(_fields(step.instruction)):
            cell = self._cell(place, step)
            if cell is None or not bisect_right(cell.since, step.number - 1):
                yield place.variable.name

    def writes(self, k: int) -> str | None:
        """Return the name of the variable, or its array, that a step gives a value."""
        place = getattr(self.steps[k].instruction, "place", None)
        return place.variable.name if isinstance(place, Place) else None

    def data_read(self) -> frozenset[int]:
        """Return the lines of data that any step read."""
        found: set[int] = set()
        for k in range(len(self.steps)):
            found.update(w.line for w in self.reads(k) if w.line is not None)
        return frozenset(found)

    def caller(self, k: int) -> int | None:
        """Return the executed CALL that led to a step."""
        activation = self.steps[k].activation
        if activation is None or activation.called_from is None:
            return None
        for j in range(k - 1, -1, -1):
            if self.steps[j].at == activation.called_from:
                return j
        return None

    def step_of(self, cause: Cause | None, time_s: float) -> int | None:
        """Return the last executed step of a cause that is not after a time."""
        if cause is None:
            return None
        line, last = cause.span.line, self.run.history.finished_at(time_s) + 1
        for k in range(len(self.steps) - 1, -1, -1):
            if self.steps[k].number <= last and self.steps[k].line == line:
                return k
        return None

    def motion_at(self, time_s: float) -> int:
        """Return the number of the last motion that has begun at a time."""
        found = 0
        for number, motion in enumerate(self.run.motions):
            if motion.start_s <= time_s + 1e-9:
                found = number
        return found

    def time_of(self, k: int) -> float:
        """Return when a step was executed [s]."""
        return self.run.history.time_of(self.steps[k].number)

    def _cell(self, place: Place, step: Executed) -> Cell | None:
        variable = place.variable
        bound: Bound | None
        if isinstance(variable, Slot):
            slots = step.activation.slots if step.activation else []
            bound = slots[variable.number] if variable.number < len(slots) else None
        else:
            bound = self._globals.get(variable.name)
        if not isinstance(bound, Array):
            return bound
        values = [self._value(each, step) for each in place.subscripts]
        if any(value is None for value in values):
            return None
        return bound.elements.get(tuple(round(v) for v in values if v is not None))

    def _value(self, expression: object, step: Executed) -> float | None:
        """Return the value of a subscript that is a constant or a plain variable."""
        value: object = None
        if isinstance(expression, Constant):
            value = expression.value
        elif isinstance(expression, Load):
            cell = self._cell(expression.place, step)
            value = None if cell is None else cell.at(step.number - 1)
        return value if isinstance(value, float) else None


def _element(name: str, subscripts: tuple[int, ...]) -> str:
    return f"{name}[{','.join(map(str, subscripts))}]" if subscripts else name


def _fields(instruction: Instruction) -> tuple[object, ...]:
    return cast("tuple[object, ...]", tuple(instruction))


def _places(node: object) -> Iterator[Place]:
    """Yield every place that an instruction names, those of subscripts after it."""
    if isinstance(node, Place):
        yield node
        yield from _places(node.subscripts)
    elif isinstance(node, tuple):
        for part in cast("tuple[object, ...]", node):
            yield from _places(part)
