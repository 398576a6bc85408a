"""What a machine keeps of its own earlier states, to see that it repeats one."""

from typing import NamedTuple

from vrts.engine.memory.cells import Cell, Content
from vrts.robots.model import Configuration

FIRST_LOOK = 20  # ticks that are executed before a state is kept


class Arm(NamedTuple):
    """Where the arm is on its way, apart from when."""

    since_start: int  # ticks since the motion under way began; -1 at rest
    start: Configuration
    goal: Configuration
    pending: Configuration | None
    opening: float


class Kept(NamedTuple):
    """The state of a machine, apart from the time."""

    places: tuple[object, ...]  # cheap to compare: where the programs are
    arm: Arm
    values: tuple[Content, ...]
    signals: frozenset[int]
    switches: tuple[tuple[str, bool], ...]
    objects: tuple[object, ...]
    clock_reads: int
    time_s: float
    finished: int


class Watcher:
    """The state that later ones are compared with, and for how long."""

    __slots__ = ("kept", "left", "power", "witness")

    def __init__(self) -> None:
        """Start with nothing kept."""
        self.kept: Kept | None = None
        self.power = FIRST_LOOK  # ticks for which a state is kept
        self.left = FIRST_LOOK  # of them, those still to come
        self.witness: tuple[Cell, Content] | None = None  # a cell, and its value that is kept

    def copy(self) -> "Watcher":
        """Return an independent copy."""
        other = Watcher()
        other.kept, other.power, other.left = self.kept, self.power, self.left
        return other
