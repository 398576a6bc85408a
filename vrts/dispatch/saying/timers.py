"""Which timers programs set and read."""

from vrts.dispatch.saying.cannot import CannotSay
from vrts.dispatch.saying.parts import constant, parts
from vrts.ir import instructions as ir
from vrts.ir.expressions import Apply, Function
from vrts.ir.module import Module


def timer_of(number: object) -> int:
    """Return which timer is meant.

    Raises:
        CannotSay: It is worked out in the run.
    """
    which = constant(number)
    if which is None:
        raise CannotSay("the number of a timer is worked out in the run", "write a number")
    return round(which)


def timers(module: Module) -> tuple[int, ...]:
    """Return the timers that stand in programs; one that is worked out in the run is left out."""
    found: set[int] = set()
    programs = module.programs.values()
    for part in (p for program in programs for p in parts(program.instructions)):
        number = part.number if isinstance(part, ir.SetTimer) else None
        if isinstance(part, Apply) and part.function is Function.TIMER:
            number = part.arguments[0]
        which = constant(number)
        if which is not None:
            found.add(round(which))
    return tuple(sorted(found))
