"""What a machine keeps of its own earlier states, to see that it repeats one."""

from typing import NamedTuple

from vrts.engine.code.executable import Executable
from vrts.engine.memory.cells import Cell, Content

FIRST_LOOK = 20  # ticks that are executed before a state is kept
TRIES = 8  # looks at the robot program apart from the other one, for each state that is kept


class Kept(NamedTuple):
    """The state of a machine, with times told from now on; what follows `clock_reads` is none."""

    places: tuple[object, object]  # cheap to compare: where the programs are
    robot: tuple[object, ...]
    process: tuple[object, ...]
    arm: tuple[object, ...]
    outside: tuple[object, ...]  # hand, objects, settings of the controller
    signals: frozenset[int]
    values: tuple[tuple[Content, ...], ...]  # of every global variable, by number
    clock_reads: int
    time_s: float
    finished: int  # statements of both programs


class Watcher:
    """The state that later ones are compared with, and for how long."""

    __slots__ = ("broken", "idle", "kept", "left", "power", "told", "tries", "witness")

    def __init__(self) -> None:
        """Start with nothing kept."""
        self.broken = ""  # what went wrong in the judgement, which is then given up
        self.told = False  # that it was given up
        self.idle: tuple[Executable, frozenset[int]] | None = None  # variables that decide nothing
        self.begin()

    def begin(self) -> None:
        """Forget what was kept: something has changed from outside."""
        self.kept: Kept | None = None
        self.power = FIRST_LOOK  # ticks for which a state is kept
        self.left = FIRST_LOOK  # of them, those still to come
        self.tries = TRIES
        self.witness: tuple[Cell, Content] | None = None  # a cell, and its value that is kept

    def keep(self, state: Kept) -> None:
        """Compare with this state from now on, and for twice as long as with the one before."""
        self.power *= 2
        self.left = self.power
        self.tries = TRIES
        self.kept, self.witness = state, None

    def copy(self) -> "Watcher":
        """Return an independent copy."""
        other = Watcher()
        other.kept, other.power, other.left = self.kept, self.power, self.left
        other.tries, other.idle = self.tries, self.idle
        other.broken, other.told = self.broken, self.told
        return other
