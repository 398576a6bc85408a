"""Which variables a program keeps for all programs, and how long those are that are arrays."""

from vrts.dispatch.saying.cannot import CannotSay
from vrts.dispatch.saying.parts import parts
from vrts.ir.expressions import Constant, Expression, Global, Place
from vrts.ir.module import Module
from vrts.ir.values import Type

UNKNOWN = 24  # largest subscript of an array of which one is worked out in the run


def largest_subscripts(module: Module) -> dict[str, tuple[Type, int | None]]:
    """Return every global variable with its type and largest subscript; None: it is no array.

    Raises:
        CannotSay: One has two subscripts.
    """
    found: dict[str, tuple[Type, int | None]] = {}
    programs = module.programs.values()
    places = (p for program in programs for p in parts(program.instructions))
    for place in places:
        if isinstance(place, Place) and isinstance(place.variable, Global):
            name, kind = place.variable.name, place.variable.type
            _note(found, name, kind, place.subscripts)
    for datum in module.data:
        known = found.get(datum.name)
        if known is None or not datum.subscripts:
            continue
        first, *more = datum.subscripts
        if more:
            raise CannotSay(f"`{datum.name}` has two subscripts", "use one")
        found[datum.name] = (known[0], max(known[1] or 0, first))
    return found


def _note(
    found: dict[str, tuple[Type, int | None]],
    name: str,
    kind: Type,
    subscripts: tuple[Expression, ...],
) -> None:
    if len(subscripts) > 1:
        raise CannotSay(f"`{name}` has two subscripts", "use one")
    _, before = found.get(name, (kind, None))
    if not subscripts:
        found[name] = (kind, before)
        return
    (subscript,) = subscripts
    match subscript:
        case Constant(float(number)):
            value = round(number)
        case _:
            value = UNKNOWN
    found[name] = (kind, max(before or 0, value))
