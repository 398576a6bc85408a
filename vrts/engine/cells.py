"""The controller's memory: cells with their history, so that any moment can be read back."""

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


class Cell:
    """A variable or array element. History keeps its last value of every instant."""

    __slots__ = ("name", "times", "value", "values")

    def __init__(self, name: str) -> None:
        """Make a cell without a value."""
        self.name = name
        self.value: Value | Undefined = UNDEFINED
        self.times: list[float] = []
        self.values: list[Value] = []

    def assign(self, value: Value, time_s: float) -> None:
        """Give the cell a value at an instant not before the last one."""
        self.value = value
        times = self.times
        if times and times[-1] == time_s:
            self.values[-1] = value
        else:
            times.append(time_s)
            self.values.append(value)

    def at(self, time_s: float) -> Value | Undefined:
        """Return the value at an instant."""
        found = bisect_right(self.times, time_s)
        return self.values[found - 1] if found else UNDEFINED

    def copy(self) -> "Cell":
        """Return a cell with the same history that can go on by itself."""
        other = Cell(self.name)
        other.value = self.value
        other.times = self.times.copy()
        other.values = self.values.copy()
        return other


class Array:
    """An array: its elements exist once they are assigned."""

    __slots__ = ("elements", "name")

    def __init__(self, name: str) -> None:
        """Make an array without elements."""
        self.name = name
        self.elements: dict[tuple[int, ...], Cell] = {}

    def element(self, subscripts: tuple[int, ...]) -> Cell:
        """Return an element's cell, making it when it is first spoken of."""
        cell = self.elements.get(subscripts)
        if cell is None:
            listed = ",".join(str(subscript) for subscript in subscripts)
            cell = self.elements[subscripts] = Cell(f"{self.name}[{listed}]")
        return cell


Bound: TypeAlias = Cell | Array
"""What a name stands for."""


class Memory:
    """Every global variable, by number. Numbers are given when the programs are compiled."""

    __slots__ = ("bound",)

    def __init__(self, bound: list[Bound]) -> None:
        """Take the variables in the order of their numbers."""
        self.bound = bound

    def cells(self) -> list[Cell]:
        """Return every cell, array elements included."""
        found: list[Cell] = []
        for item in self.bound:
            found += item.elements.values() if isinstance(item, Array) else [item]
        return found

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
        for subscripts, cell in item.elements.items():
            element = copy_bound(cell, copies)
            assert isinstance(element, Cell)
            copied.elements[subscripts] = element
    copies[id(item)] = copied
    return copied
