"""The programs in memory, as plain data: all that is known of them but their compiled steps."""

from typing import NamedTuple

from vrts.engine.memory.cells import Array, Bound, Cell
from vrts.engine.memory.events import Cause
from vrts.engine.programs.frames import Frame
from vrts.ir.expressions import Slot
from vrts.ir.module import Program


class Loaded(NamedTuple):
    """One program."""

    program: Program
    base: int  # number of its first instruction among those of all programs
    causes: tuple[Cause, ...]  # beside its instructions


class Programs:
    """All programs in memory. Holds no state: runs share it."""

    __slots__ = ("causes", "loaded", "numbers")

    def __init__(
        self, loaded: tuple[Loaded, ...], numbers: dict[str, int], causes: list[Cause]
    ) -> None:
        """Take programs by number, their numbers by name, and the causes of all instructions."""
        self.loaded = loaded
        self.numbers = numbers
        self.causes = causes

    def copy(self) -> "Programs":
        """Return programs to which others can be added."""
        return Programs(self.loaded, dict(self.numbers), self.causes.copy())

    def room(self, number: int) -> tuple[int, int]:
        """Return the numbers of the instructions that belong to a program, whatever its size."""
        following = self.loaded[number + 1 : number + 2]
        end = following[0].base if following else len(self.causes)
        return self.loaded[number].base, end

    def frame(self, number: int, slots: list[Bound] | None = None) -> Frame:
        """Return a frame at the start of a program; without slots as called without arguments."""
        program = self.loaded[number].program
        if slots is None:
            slots = [fresh(program, slot) for slot in (*program.formals, *program.autos)]
        return Frame(number, slots, program.loops, program.cases)


def fresh(program: Program, slot: Slot) -> Bound:
    """Return the cell or array of an argument or automatic variable that nothing was given to."""
    return Array(slot.name) if slot.number in program.array_formals else Cell(slot.name)
