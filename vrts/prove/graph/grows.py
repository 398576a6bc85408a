"""Variables that grow round a cycle, for ever: no two rounds come to the same state.

A counter at which nothing looks, or only TYPE, is left out of the state. One that is looked at is
told once it has grown for some rounds, and is past every number that the programs know.
"""

from itertools import pairwise

from vrts.engine.code.executable import Executable
from vrts.engine.futures.keys import Key, Keys
from vrts.engine.machine.forever.idle import idle
from vrts.engine.machine.machine import Machine
from vrts.engine.memory.events import Cause
from vrts.ir import instructions as ir
from vrts.ir.expressions import (
    Binary,
    BinaryOperator,
    Global,
    Load,
    Place,
)
from vrts.ir.module import Module
from vrts.ir.values import Type
from vrts.prove.graph.compared import compared
from vrts.prove.graph.graph import Graph
from vrts.prove.proof import Variable

ROUNDS = 9  # that are compared
FEW = 32  # states that differ in nothing else before they are
FAR = 20_000  # legs that are gone back


class Grows:
    """Looks for variables that grow."""

    def __init__(self, module: Module, executable: Executable, graph: Graph) -> None:
        """Go through the programs."""
        self.idle = idle(executable, shown=True)
        self.found: dict[int, Variable] = {}  # by number
        self._graph = graph
        self._counted = _counted(module, executable)
        self._looked_at = frozenset(self._counted) - self.idle
        self._shown = frozenset(self._counted) & self.idle
        self._left_out = self._looked_at | self.idle
        self._order = sorted(self._counted)
        numbers = [datum.value for datum in module.data if isinstance(datum.value, float)]
        numbers += compared(module)
        self._least, self._most = min(numbers, default=0.0), max(numbers, default=0.0)
        self._values: list[tuple[object, ...]] = []  # by state, of all that is counted
        self._alike: dict[Key, list[int]] = {}  # states that differ in nothing else
        self._growing: set[Key] = set()

    def state(self, keys: Keys, key: Key, machine: Machine, state: int) -> bool:
        """Note a state that is new; return whether it is only one more round of what grows."""
        self._values.append(self._held(machine))
        if not self._looked_at:
            return False
        rest = keys.apart(key, machine, self._left_out)
        if rest in self._growing:
            return True
        alike = self._alike.setdefault(rest, [])
        alike.append(state)
        if len(alike) < FEW or len(alike) & (len(alike) - 1):
            return False
        growing = self._growth(frozenset(alike), state)
        for k in growing:
            self.found.setdefault(k, self._counted[k])
        if growing:
            self._growing.add(rest)
        return bool(growing)

    def met(self, machine: Machine, known: int, leg: int) -> None:
        """Note that a future has come to a known state: its own, perhaps, with higher counts."""
        if not self._shown or self._shown <= self.found.keys():
            return
        held, before = self._held(machine), self._values[known]
        for k, one, other in zip(self._order, held, before, strict=True):
            if k in self._shown and one != other and self._is_behind(known, leg):
                self.found.setdefault(k, self._counted[k])

    @property
    def looked_at(self) -> list[Variable]:
        """What grows and decides something."""
        return [self.found[k] for k in sorted(self.found) if k in self._looked_at]

    def _held(self, machine: Machine) -> tuple[object, ...]:
        bound = machine.system.memory.bound
        return tuple([bound[k].value for k in self._order])

    def _growth(self, alike: frozenset[int], state: int) -> list[int]:
        """Return what has grown round by round on the way to a state."""
        rounds = [self._values[state]]
        start = self._graph.legs[self._graph.visits[state].leg].start
        for _ in range(FAR):
            if start is None or len(rounds) == ROUNDS:
                break
            if start in alike:
                rounds.append(self._values[start])
            start = self._graph.legs[self._graph.visits[start].leg].start
        if len(rounds) < ROUNDS:
            return []
        found: list[int] = []
        for n, k in enumerate(self._order):
            steps = [values[n] for values in rounds if isinstance(values[n], float)]
            if k not in self._looked_at or len(steps) < ROUNDS:
                continue
            newest = steps[0]
            assert isinstance(newest, float)
            pairs = list(pairwise(steps))
            grows = all(a > b for a, b in pairs) and newest > self._most  # type: ignore[operator]
            falls = all(a < b for a, b in pairs) and newest < self._least  # type: ignore[operator]
            if grows or falls:
                found.append(k)
            elif any(a != b for a, b in pairs):
                return []  # something else changes, too: it may come to an end
        return found

    def _is_behind(self, state: int, leg: int) -> bool:
        """Return whether a leg comes from a state: numbers fall on the way back."""
        start = self._graph.legs[leg].start
        for _ in range(FAR):
            if start is None or start <= state:
                break
            start = self._graph.legs[self._graph.visits[start].leg].start
        return start == state


def _counted(module: Module, executable: Executable) -> dict[int, Variable]:
    """Return the global numbers of which some instruction makes more or less, by number."""
    found: dict[int, Variable] = {}
    numbers = executable.layout.numbers
    for program in module.programs.values():
        for instruction, origin in zip(program.instructions, program.origins, strict=True):
            match instruction:
                case ir.Assign(
                    place=Place(variable=Global(name=name, type=Type.REAL), subscripts=()),
                    value=Binary(
                        operator=BinaryOperator.ADD | BinaryOperator.SUBTRACT,
                        left=left,
                        right=right,
                    ),
                ) if name in numbers and any(_is(name, side) for side in (left, right)):
                    cause = Cause(program.name, origin.step, origin.span)
                    found.setdefault(numbers[name], Variable(name, program.name, cause))
                case _:
                    pass
    return found


def _is(name: str, side: object) -> bool:
    match side:
        case Load(place=Place(variable=Global(name=other), subscripts=())):
            return other == name
        case _:
            return False
