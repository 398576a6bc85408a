"""A list whose first items may be let go: the others keep their numbers."""

from collections.abc import Iterable, Iterator, Sequence
from typing import Generic, TypeVar, overload

Item = TypeVar("Item")


class Numbered(Sequence[Item], Generic[Item]):
    """Items by number. Its length counts those that are gone; going through it leaves them out."""

    __slots__ = ("_items", "first")

    def __init__(self, items: Iterable[Item] = (), first: int = 0) -> None:
        """Take items, the first of which has a number."""
        self._items = list(items)
        self.first = first  # number of the first that is left

    def __len__(self) -> int:
        """Return the number of the item that comes next."""
        return self.first + len(self._items)

    @overload
    def __getitem__(self, index: int) -> Item: ...

    @overload
    def __getitem__(self, index: slice) -> list[Item]: ...

    def __getitem__(self, index: int | slice) -> Item | list[Item]:
        """Return an item, or those of some numbers that are left.

        Raises:
            IndexError: It is not there, or gone.
        """
        if isinstance(index, slice):
            numbers = range(*index.indices(len(self)))
            return [self._items[k - self.first] for k in numbers if k >= self.first]
        return self._items[self._at(index)]

    def __setitem__(self, index: int, item: Item) -> None:
        """Replace an item that is left."""
        self._items[self._at(index)] = item

    def __iter__(self) -> Iterator[Item]:
        """Go through the items that are left."""
        return iter(self._items)

    def __reversed__(self) -> Iterator[Item]:
        """Go through them from the last."""
        return reversed(self._items)

    def __eq__(self, other: object) -> bool:
        """Return whether the items and their numbers are the same."""
        if isinstance(other, Numbered):
            return self.first == other.first and self._items == list(other)  # pyright: ignore[reportUnknownArgumentType, reportUnknownMemberType]
        return isinstance(other, list) and self.first == 0 and self._items == other

    def __repr__(self) -> str:
        """Return what is left, and its first number."""
        return f"Numbered({self._items!r}, {self.first})"

    __hash__ = None  # type: ignore[assignment] -- it changes

    def append(self, item: Item) -> None:
        """Add an item at the end."""
        self._items.append(item)

    def pop(self) -> Item:
        """Take the last item away."""
        return self._items.pop()

    def copy(self) -> "Numbered[Item]":
        """Return an independent list."""
        return Numbered(self._items, self.first)

    def forget(self, before: int) -> None:
        """Let the items before a number go."""
        if before > self.first:
            del self._items[: before - self.first]
            self.first = before

    def _at(self, index: int) -> int:
        at = (index if index >= 0 else index + len(self)) - self.first
        if at < 0:
            raise IndexError(index)
        return at
