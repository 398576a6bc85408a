"""What a table can be asked about: columns with names, units, and how each is read off a row."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Generic, TypeAlias, TypeVar

from vrts.debug.near import near_words

R = TypeVar("R")
Content: TypeAlias = float | str | tuple[str, ...] | None
"""Of one column of one row; None: there is none. Several texts: a comparison is with any."""


@dataclass(frozen=True, slots=True)
class Column(Generic[R]):
    """A column of the rows of a table."""

    says: str  # what it is, as help has it
    of: Callable[[R], Content]
    unit: str = ""  # of a number: "s", "mm"
    number: bool = False  # otherwise text
    only: tuple[str, ...] = ()  # what a text may be; empty: anything


Columns: TypeAlias = Mapping[str, Column[R]]


def listed(columns: Columns[R]) -> str:
    """Return the names of columns, with their units."""
    shown = (f"{name} [{c.unit}]" if c.unit else name for name, c in columns.items())
    return ", ".join(shown)


def no_such(name: str, columns: Columns[R]) -> str:
    """Return that there is no such column, what was meant, and which there are."""
    near = near_words(name.lower(), columns)
    return f"there is no column `{name}`{near or ''}\ncolumns: {listed(columns)}"


def texts_of(content: Content) -> Sequence[str]:
    """Return the texts of a column of texts."""
    return content if isinstance(content, tuple) else (str(content),)
