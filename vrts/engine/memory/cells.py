"""The controller's memory: cells with their history, so that any statement can be looked back at.

Statements are numbered through a run; an entry of a cell says from which number of finished
statements on its value holds. Copies of a cell share the history: entries beyond the number at
which a copy was made are another future's, until `cut` parts them.
"""

from array import array
from bisect import bisect_right
from typing import TypeAlias

from vrts.ir.values import Value


class Undefined:
    """The value of a variable that never received one."""

    __slots__ = ()

    def __repr__(self) -> str:
        """Return what a listing shows."""
        return "undefined"


UNDEFINED = Undefined()

Content: TypeAlias = Value | Undefined


class Cell:
    """A variable or array element with every value it ever had."""

    __slots__ = ("name", "since", "value", "values")

    def __init__(self, name: str) -> None:
        """Make a cell without a value."""
        self.name = name
        self.value: Content = UNDEFINED
        self.since = array("I")  # numbers of finished statements, ascending
        self.values: array[float] | list[Content] = array("d")  # beside `since`

    def assign(self, value: Content, since: int) -> None:
        """Give the cell a value that holds once `since` statements are finished."""
        self.value = value
        try:
            self.values.append(value)  # type: ignore[arg-type]
        except TypeError:  # the first value that is no number
            self.values = [*self.values, value]
        self.since.append(since)

    def at(self, finished: int) -> Content:
        """Return the value after a number of finished statements."""
        found = bisect_right(self.since, finished)
        return self.values[found - 1] if found else UNDEFINED

    def copy(self) -> "Cell":
        """Return a cell that shares the history."""
        other = Cell.__new__(Cell)
        other.name, other.value = self.name, self.value
        other.since, other.values = self.since, self.values
        return other

    def cut(self, finished: int) -> None:
        """Keep a history of its own, without entries after a number of finished statements."""
        kept = bisect_right(self.since, finished)
        self.since = self.since[:kept]
        self.values = self.values[:kept]


class Array:
    """An array: its elements exist once they are assigned."""

    __slots__ = ("elements", "made", "name")

    value = UNDEFINED  # of an array as a whole

    def __init__(self, name: str) -> None:
        """Make an array without elements."""
        self.name = name
        self.elements: dict[tuple[int, ...], Cell] = {}
        self.made = array("I")  # statements finished when each came about, in their order

    def element(self, subscripts: tuple[int, ...], since: int = 0) -> Cell:
        """Return an element's cell, making it when it is first spoken of: from `since` on."""
        cell = self.elements.get(subscripts)
        if cell is None:
            listed = ",".join(str(subscript) for subscript in subscripts)
            cell = self.elements[subscripts] = Cell(f"{self.name}[{listed}]")
            self.made.append(since)
        return cell


Bound: TypeAlias = Cell | Array
"""What a name stands for."""


def cells_of(item: Bound) -> list[Cell]:
    """Return the cells behind a name."""
    return list(item.elements.values()) if isinstance(item, Array) else [item]


class Memory:
    """Every global variable, by number. Numbers are given when the programs are compiled."""

    __slots__ = ("bound",)

    def __init__(self, bound: list[Bound]) -> None:
        """Take the variables in the order of their numbers."""
        self.bound = bound

    def cells(self) -> list[Cell]:
        """Return every cell, array elements included."""
        return [cell for item in self.bound for cell in cells_of(item)]

    @property
    def size(self) -> int:
        """Number of cells."""
        return sum(len(b.elements) if isinstance(b, Array) else 1 for b in self.bound)

    def copy(self, copies: dict[int, Bound]) -> "Memory":
        """Return an independent memory; `copies` maps id of the old to the new cells and arrays."""
        return Memory([copy_bound(item, copies) for item in self.bound])


def copy_bound(item: Bound, copies: dict[int, Bound]) -> Bound:
    """Return the one copy of a cell or array."""
    known = copies.get(id(item))
    if known is not None:
        return known
    if isinstance(item, Cell):
        copied: Bound = item.copy()
    else:
        copied = Array(item.name)
        copied.made = item.made[:]
        for subscripts, cell in item.elements.items():
            element = copy_bound(cell, copies)
            assert isinstance(element, Cell)
            copied.elements[subscripts] = element
    copies[id(item)] = copied
    return copied
