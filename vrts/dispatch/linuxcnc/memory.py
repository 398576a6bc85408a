"""Where variables are kept: locations and arrays in numbered parameters, the rest by name.

A pose takes twelve numbers (its rotation row by row, then x, y, z in mm), six joints take six
(in degrees). Their addresses have names, so that a line reads `o<v_moves> call [#<_at_pick>]`.
"""

from typing import NamedTuple

from vrts.dispatch.saying.arrays import largest_subscripts
from vrts.dispatch.saying.cannot import CannotSay
from vrts.dispatch.saying.names import plain
from vrts.ir.expressions import Global, Place
from vrts.ir.module import Module
from vrts.ir.values import Type

FIRST, LAST = 1000, 4999  # numbered parameters; those below are the library's
WIDTH = {Type.POSE: 12, Type.JOINTS: 6, Type.REAL: 1}


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
        largest = largest_subscripts(module)
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
