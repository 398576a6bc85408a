"""Elements of an array as they were at the instant at which they are asked for."""

from collections.abc import ItemsView, Mapping, ValuesView
from typing import Protocol

from vrts.engine.memory.cells import Cell


class At(Protocol):
    """Stands at an instant."""

    finished: int  # statements of both programs


class Elements(dict[tuple[int, ...], Cell]):
    """Elements of an array, as they were at the instant at which they are asked for."""

    def __init__(self, name: str, past: At) -> None:
        """Begin without elements; messages call them by the name that the expression has."""
        super().__init__()
        self._name = name
        self._past = past
        self._source: Mapping[tuple[int, ...], Cell] = {}

    def stand_for(self, source: Mapping[tuple[int, ...], Cell]) -> None:
        """Be the elements of an array with a history."""
        if source is not self._source:
            self._source = source
            self.clear()

    def get(self, key: tuple[int, ...], default: Cell | None = None) -> Cell | None:  # type: ignore[override]
        """Return an element with its value then."""
        found = self._source.get(key)
        cell = super().get(key, default)
        if found is None:
            return cell
        if cell is None:
            cell = self[key] = Cell(f"{self._name}[{','.join(map(str, key))}]")
        cell.value = found.at(self._past.finished)
        return cell

    def _all(self) -> dict[tuple[int, ...], Cell]:
        return {key: cell for key in self._source if (cell := self.get(key)) is not None}

    def items(self) -> ItemsView[tuple[int, ...], Cell]:  # type: ignore[override]
        """Return all elements."""
        return self._all().items()

    def values(self) -> ValuesView[Cell]:  # type: ignore[override]
        """Return all elements without their subscripts."""
        return self._all().values()
