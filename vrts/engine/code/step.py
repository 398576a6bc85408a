"""What a compiled instruction is, and what compiled instructions share."""

from collections.abc import Callable

from vrts.base.source import Span
from vrts.engine.machine.context import Context
from vrts.engine.outcomes import INSTANT
from vrts.ir.expressions import Expression, Load

Step = Callable[[Context], int]
"""Takes the context; returns the next instruction's index, or a negative outcome of `outcomes`."""


def reached(c: Context, time_s: float) -> bool:
    """Return whether a time has come, or else set when to look again."""
    if c.now >= time_s - INSTANT:
        return True
    c.wake = time_s
    return False


def place_of(expression: Expression) -> Span | None:
    """Return where an expression stands."""
    return expression.place.span if isinstance(expression, Load) else expression.span


def parameter(c: Context, name: str, otherwise: float) -> float:
    """Return a parameter of the controller, or what it is at the start."""
    cell = c.system.parameters.get(name)
    return cell.value if cell is not None and isinstance(cell.value, float) else otherwise


def look_again(c: Context) -> None:
    """Let programs that wait for the arm look again: it may arrive earlier than they know."""
    for program in (c.system.robot, c.system.process):
        program.wake = min(program.wake, c.now)
