"""Arguments that come back: VAL-II passes variables themselves, other languages pass values.

A program leaves what it gave to an argument in a variable of its own, and its caller takes it from
there. That is the same only where nobody looks at the variable meanwhile; else it is refused.
"""

from vrts.dispatch.saying.cannot import CannotSay
from vrts.dispatch.saying.names import plain
from vrts.dispatch.saying.parts import parts
from vrts.ir import instructions as ir
from vrts.ir.expressions import Constant, Global, Place, Slot
from vrts.ir.module import Module, Program
from vrts.ir.values import Type

COPIED = frozenset(Type)


class Arguments:
    """Which arguments of which program come back."""

    def __init__(self, module: Module, copied: frozenset[Type] = COPIED) -> None:
        """Look through the programs of a module; `copied` are the types that go as values."""
        self.module, self.copied = module, copied
        self.changed: dict[str, set[int]] = {name: set() for name in module.programs}
        again = True
        while again:
            before = sum(map(len, self.changed.values()))
            for name, program in module.programs.items():
                self._changes(name, program)
            again = sum(map(len, self.changed.values())) > before

    def back(self, program: Program) -> list[tuple[str, Slot]]:
        """Return where a program leaves its arguments: names of variables, and formals."""
        return [
            (f"back_{plain(program.name)}_{formal.number}", formal)
            for formal in program.formals
            if formal.number in self.changed[program.name] and formal.type in self.copied
        ]

    def taken(self, call: ir.Call) -> list[tuple[Place, str]]:
        """Return what a caller takes back: variables, and where their values are.

        Raises:
            CannotSay: Somebody would look at the variable meanwhile.
        """
        program = self.module.programs[call.program]
        given = [a for a in call.arguments if isinstance(a, Place)]
        written, named = self._globals(call.program, set())
        for place in given:
            if place.variable.type not in self.copied:
                continue
            if place.variable.name in written and isinstance(place.variable, Global):
                raise CannotSay(
                    f"`{place.variable.name}` is passed to `{call.program}`, which changes it too",
                    "change the argument there",
                )
        found: list[tuple[Place, str]] = []
        for name, formal in self.back(program):
            place = call.arguments[formal.number] if formal.number < len(call.arguments) else None
            if not isinstance(place, Place):
                continue
            twice = sum(other.variable == place.variable for other in given) > 1
            known = isinstance(place.variable, Global) and place.variable.name in named
            if twice or known or not all(isinstance(s, Constant) for s in place.subscripts):
                raise CannotSay(
                    f"`{place.variable.name}` comes back, and `{call.program}` knows it twice",
                    "pass another variable",
                )
            found.append((place, name))
        return found

    def _changes(self, name: str, program: Program) -> None:
        formals = {formal.number for formal in program.formals}
        for step in program.instructions:
            places: list[object] = []
            if isinstance(step, ir.Assign | ir.AssignHere | ir.BeginFor):
                places = [step.place]
            elif isinstance(step, ir.Call) and step.program in self.changed:
                back = self.changed[step.program]
                places = [a for k, a in enumerate(step.arguments) if k in back]
            for place in places:
                if isinstance(place, Place) and isinstance(place.variable, Slot):
                    self.changed[name] |= {place.variable.number} & formals

    def _globals(self, name: str, seen: set[str]) -> tuple[set[str], set[str]]:
        """Return the global variables that a program, and all that it calls, writes and names."""
        written: set[str] = set()
        named: set[str] = set()
        if name in seen or name not in self.module.programs:
            return written, named
        seen.add(name)
        for step in self.module.programs[name].instructions:
            if isinstance(step, ir.Assign | ir.AssignHere | ir.BeginFor) and isinstance(
                step.place.variable, Global
            ):
                written.add(step.place.variable.name)
            named |= {
                part.variable.name
                for part in parts(step)
                if isinstance(part, Place) and isinstance(part.variable, Global)
            }
            if isinstance(step, ir.Call):
                for place, _ in self.taken(step):
                    if isinstance(place.variable, Global):
                        written.add(place.variable.name)
                more = self._globals(step.program, seen)
                written |= more[0]
                named |= more[1]
        return written, named
