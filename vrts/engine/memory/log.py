"""Append-only lists that versions of a machine share.

A copy costs nothing: it shares the items and remembers how many are its own. Only when two copies
go on differently does the second one to append copy what is common.
"""

from collections.abc import Iterator, Sequence
from typing import Generic, TypeVar, overload

Item = TypeVar("Item")


class Log(Sequence[Item], Generic[Item]):
    """A list that only grows."""

    __slots__ = ("_items", "_length")

    def __init__(self) -> None:
        """Start empty."""
        self._items: list[Item] = []
        self._length = 0

    def append(self, item: Item) -> None:
        """Add an item at the end."""
        if len(self._items) != self._length:
            self._items = self._items[: self._length]
        self._items.append(item)
        self._length += 1

    def copy(self) -> "Log[Item]":
        """Return a log with the same items that can go on by itself."""
        other: Log[Item] = Log()
        other._items, other._length = self._items, self._length
        return other

    def shares_with(self, other: "Log[Item]") -> bool:
        """Return whether both have the same items, as far as either goes."""
        return self._items is other._items

    def __len__(self) -> int:
        """Return the number of items."""
        return self._length

    @overload
    def __getitem__(self, index: int) -> Item: ...

    @overload
    def __getitem__(self, index: slice) -> list[Item]: ...

    def __getitem__(self, index: int | slice) -> Item | list[Item]:
        """Return an item, or a list of some."""
        if isinstance(index, slice):
            return self._items[: self._length][index]
        if index < 0:
            index += self._length
        if not 0 <= index < self._length:
            raise IndexError(index)
        return self._items[index]

    def __iter__(self) -> Iterator[Item]:
        """Go through the items."""
        return iter(self._items[: self._length])
