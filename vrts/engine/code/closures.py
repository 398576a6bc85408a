"""What instructions and expressions are compiled to, and how a step leaves the machine."""

from collections.abc import Callable

from vrts.engine.memory.cells import Bound, Cell
from vrts.engine.memory.records import INSTANT
from vrts.engine.programs.context import Context
from vrts.ir.values import Value

Step = Callable[[Context], int]
"""Takes the context; returns the next instruction's index, or one of the outcomes below."""

Evaluate = Callable[[Context], Value]
Real = Callable[[Context], float]
Find = Callable[[Context], Cell]
Bind = Callable[[Context], Bound]

BLOCKED = -1  # look again at `Context.wake`
SWITCHED = -2  # the innermost frame changed
CYCLE_ENDED = -3  # STOP, or RETURN of the first program
HALTED = -4
PAUSED = -5


def reached(c: Context, time_s: float) -> bool:
    """Return whether a time has come, or else set when to look again."""
    if c.now >= time_s - INSTANT:
        return True
    c.wake = time_s
    return False
