"""Where variables are kept: locations and arrays in numbered parameters, the rest by name.

A pose takes twelve numbers (its rotation row by row, then x, y, z in mm), six joints take six
(in degrees). Their addresses have names, so that a line reads `o<v_moves> call [#<_at_pick>]`.
"""

from typing import NamedTuple

from vrts.dispatch.saying.cannot import CannotSay
from vrts.dispatch.saying.names import plain
from vrts.dispatch.saying.parts import parts
from vrts.ir.expressions import Constant, Expression, Global, Place
from vrts.ir.module import Module
from vrts.ir.values import Type

FIRST, LAST = 1000, 4999  # numbered parameters; those below are the library's
WIDTH = {Type.POSE: 12, Type.JOINTS: 6, Type.REAL: 1}
UNKNOWN = 24  # elements of an array of which no subscript is a plain number


class Kept(NamedTuple):
    """A variable in numbered parameters."""

    parameter: str  # that holds its address: "_at_pick"
    address: int
    width: int  # numbers of an element
    elements: int | None  # None: no array


class Memory:
    """Addresses of all that a module keeps in numbered parameters."""

    def __init__(self, module: Module) -> None:
        """Lay out what the programs and the data name.

        Raises:
            CannotSay: There is too much of it, or two names are spelt alike.
        """
        self._next = FIRST
        self._labels = 100  # of O-words
        self.kept: dict[str, Kept] = {}
        self._spelt: dict[str, str] = {}
        largest = _subscripts(module)
        for name, (kind, subscript) in largest.items():
            if kind in WIDTH and (kind is not Type.REAL or subscript is not None):
                self._keep(name, kind, subscript)

    def of(self, place: Place) -> Kept | None:
        """Return where a global variable is kept; None: by its name."""
        return self.kept.get(place.variable.name) if isinstance(place.variable, Global) else None

    def more(self, width: int) -> int:
        """Return the address of a place for a value that has no name."""
        at = self._next
        self._next += width
        if self._next > LAST:
            raise CannotSay("the program keeps more locations than LinuxCNC has parameters")
        return at

    def label(self) -> int:
        """Return a number for an O-word that no other has."""
        self._labels += 1
        return self._labels

    def _keep(self, name: str, kind: Type, subscript: int | None) -> None:
        spelt = f"_at_j_{plain(name)}" if kind is Type.JOINTS else f"_at_{plain(name)}"
        other = self._spelt.setdefault(spelt, name)
        if other != name:
            raise CannotSay(f"`{other}` and `{name}` are one name in G-code", "rename one")
        width = WIDTH[kind]
        elements = None if subscript is None else subscript + 1
        self.kept[name] = Kept(spelt, self.more(width * (elements or 1)), width, elements)


def _subscripts(module: Module) -> dict[str, tuple[Type, int | None]]:
    """Return every global variable with its type and largest subscript; None: it is no array."""
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
