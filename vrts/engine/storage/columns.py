"""Columns of numbers: what the parts of a saved run share."""

from array import array
from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np

from vrts.engine.storage.container import Table
from vrts.engine.storage.damage import require

NONE = -1  # in a column of numbers of rows: no row


def column(values: "Sequence[Any] | array[Any]", kind: str, columns: int = 0) -> Table:
    """Return values as a table of a kind of number; 0 columns: flat."""
    found = np.asarray(values, dtype=kind)
    return found.reshape((-1, columns)) if columns else found.reshape(-1)


def firsts(lengths: Iterable[int]) -> Table:
    """Return where each of several runs of rows begins, and where the last ends."""
    return np.concatenate(([0], np.cumsum(list(lengths), dtype=np.int64))).astype("<u4")


def wholes(table: Table) -> list[int]:
    """Return the numbers of a flat column of whole numbers."""
    return table.tolist()


def reals(table: Table) -> list[float]:
    """Return the numbers of a flat column."""
    return table.tolist()


def whole_rows(table: Table) -> list[list[int]]:
    """Return the rows of a table of whole numbers."""
    return table.tolist()


def real_rows(table: Table) -> list[list[float]]:
    """Return the rows of a table."""
    return table.tolist()


def counts_of(table: Table) -> "array[int]":
    """Return a column of counts as the engine keeps it."""
    found = array("I")
    assert found.itemsize == table.dtype.itemsize
    found.frombytes(table.astype(np.uint32).tobytes())
    return found


def check_firsts(table: Table, total: int, what: str) -> list[int]:
    """Return where runs of rows begin, once it is sure that they fill a table.

    Raises:
        Damaged: They do not.
    """
    found = wholes(table)
    fills = bool(found) and found[0] == 0 and found[-1] == total
    require(fills and ascending(table), f"the rows of {what} are not told apart")
    return found


def check_below(table: Table, limit: int, what: str, least: int = 0) -> None:
    """Check that every number of a column is the number of a row.

    Raises:
        Damaged: One is not.
    """
    inside = not len(table) or (table.min() >= least and table.max() < limit)
    require(bool(inside), f"a number of {what} is out of range")


def ascending(table: Table) -> bool:
    """Return whether no number of a column is below the one before it."""
    return bool((table[1:] >= table[:-1]).all())
