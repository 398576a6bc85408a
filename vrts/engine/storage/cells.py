"""Variables with their histories as columns: which value each had from which statement on."""

from array import array
from bisect import bisect_right
from collections.abc import Mapping, Sequence
from typing import TypeVar

import numpy as np

from vrts.base.pose import Pose
from vrts.engine.memory.cells import UNDEFINED, Array, Bound, Cell, Content
from vrts.engine.storage.columns import (
    check_below,
    check_firsts,
    column,
    firsts,
    real_rows,
    reals,
    wholes,
)
from vrts.engine.storage.container import Table
from vrts.engine.storage.damage import require
from vrts.engine.storage.plain import joints_of_numbers, pose_of_numbers
from vrts.ir.values import Joints

REAL, NOTHING, STRING, POSE, JOINTS = range(5)  # kinds of values
MOST_SUBSCRIPT = 10  # characters of one

LAYOUT: Mapping[str, tuple[str, int]] = {
    "cells.name": ("<u4", 0),  # number of a text
    "cells.first": ("<u4", 0),  # row of its first value
    "cells.since": ("<u4", 0),  # of every value: statements finished
    "cells.kind": ("|u1", 0),
    "cells.value": ("<f8", 0),  # a real, or the number of a text, pose or configuration
    "values.poses": ("<f8", 12),
    "values.joints": ("<f8", 6),
    "names.text": ("<u4", 0),  # of everything a name stands for: its own name
    "names.array": ("|u1", 0),
    "names.first": ("<u4", 0),  # row of its first cell
    "names.cells": ("<u4", 0),
}

Item = TypeVar("Item", str, Pose, Joints)


class CellWriter:
    """Gives numbers to variables and to all that they ever held."""

    def __init__(self, finished: int) -> None:
        """Take how many statements the run has: what comes later is not of this run."""
        self._finished = finished
        self._cells: dict[int, int] = {}
        self._names: dict[int, int] = {}
        self._cell_list: list[Cell] = []
        self._bounds: list[Bound] = []
        self._texts: dict[str, int] = {}
        self._poses: dict[Pose, int] = {}
        self._joints: dict[Joints, int] = {}

    def number(self, bound: Bound) -> int:
        """Return the number of what a name stands for."""
        found = self._names.get(id(bound))
        if found is None:
            found = self._names[id(bound)] = len(self._bounds)
            self._bounds.append(bound)
        return found

    def cell_number(self, cell: Cell) -> int:
        """Return the number of a cell."""
        found = self._cells.get(id(cell))
        if found is None:
            found = self._cells[id(cell)] = len(self._cell_list)
            self._cell_list.append(cell)
        return found

    def tables(self) -> dict[str, Table]:
        """Return the columns."""
        owned = [[self.cell_number(cell) for cell in _cells_of(bound)] for bound in self._bounds]
        since, kinds, values = array("I"), bytearray(), array("d")
        lengths: list[int] = []
        for cell in self._cell_list:
            kept = bisect_right(cell.since, self._finished)
            since.extend(cell.since[:kept])
            lengths.append(kept)
            if isinstance(cell.values, array):
                values.extend(cell.values[:kept])
                kinds.extend(bytes(kept))
                continue
            for content in cell.values[:kept]:
                kind, value = self._encoded(content)
                kinds.append(kind)
                values.append(value)
        return {
            "cells.name": column([_put(self._texts, cell.name) for cell in self._cell_list], "<u4"),
            "cells.first": firsts(lengths),
            "cells.since": column(since, "<u4"),
            "cells.kind": np.frombuffer(bytes(kinds), "|u1"),
            "cells.value": column(values, "<f8"),
            "values.poses": column([[*X.rotation, *X.translation] for X in self._poses], "<f8", 12),
            "values.joints": column(list(self._joints), "<f8", 6),
            "names.text": column([_put(self._texts, bound.name) for bound in self._bounds], "<u4"),
            "names.array": column([isinstance(bound, Array) for bound in self._bounds], "|u1"),
            "names.first": firsts(len(part) for part in owned),
            "names.cells": column([cell for part in owned for cell in part], "<u4"),
        }

    @property
    def texts(self) -> list[str]:
        """Every name and string, by number; complete once the columns are made."""
        return list(self._texts)

    def _encoded(self, value: Content) -> tuple[int, float]:
        if isinstance(value, float | int):
            return REAL, value
        if isinstance(value, str):
            return STRING, _put(self._texts, value)
        if isinstance(value, Pose):
            return POSE, _put(self._poses, value)
        if isinstance(value, tuple):
            return JOINTS, _put(self._joints, value)
        return NOTHING, 0.0


class ReadCells:
    """The variables of a file."""

    def __init__(self, tables: Mapping[str, Table], texts: Sequence[str], finished: int) -> None:
        """Check the columns and make the variables.

        Raises:
            Damaged: The columns do not fit together.
        """
        self._tables = tables
        self._texts = list(texts)
        self._poses = [pose_of_numbers(row) for row in real_rows(tables["values.poses"])]
        self._joints = [joints_of_numbers(row) for row in real_rows(tables["values.joints"])]
        self.cells = self._read_cells(finished)
        self.bounds = self._read_names()

    def _read_cells(self, finished: int) -> list[Cell]:
        tables = self._tables
        names, since, kinds, values = (
            tables[f"cells.{part}"] for part in ("name", "since", "kind", "value")
        )
        first = check_firsts(tables["cells.first"], len(since), "variables")
        rows = len(since) == len(kinds) == len(values) and len(first) == len(names) + 1
        require(rows, "columns of variables differ in length")
        check_below(names, len(self._texts), "the names of variables")
        check_below(kinds, JOINTS + 1, "the kinds of values")
        check_below(since, finished + 1, "the statements of variables")
        self._check_values(kinds, values)
        rising = since[1:] >= since[:-1]
        rising[[row - 1 for row in first[1:-1] if 0 < row < len(since)]] = True
        require(bool(rising.all()), "values of a variable are not in order")
        plain = np.concatenate(([0], np.cumsum(kinds != REAL)))
        found: list[Cell] = []
        for name, begin, end in zip(wholes(names), first[:-1], first[1:], strict=True):
            cell = Cell(self._texts[name])
            cell.since.frombytes(since[begin:end].astype(np.uint32).tobytes())
            if plain[begin] == plain[end]:
                numbers = array("d")
                numbers.frombytes(values[begin:end].astype(np.float64).tobytes())
                cell.values = numbers
            else:
                pairs = zip(wholes(kinds[begin:end]), reals(values[begin:end]), strict=True)
                cell.values = [self._value(kind, value) for kind, value in pairs]
            if begin < end:
                cell.value = cell.values[-1]
            found.append(cell)
        return found

    def _check_values(self, kinds: Table, values: Table) -> None:
        pools = ((STRING, self._texts), (POSE, self._poses), (JOINTS, self._joints))
        for kind, pool in pools:
            numbers = values[kinds == kind]
            require(bool((numbers == np.floor(numbers)).all()), "a value has no number")
            check_below(numbers, len(pool), "the values of variables")

    def _value(self, kind: int, value: float) -> Content:
        if kind == REAL:
            return value
        if kind == NOTHING:
            return UNDEFINED
        if kind == STRING:
            return self._texts[int(value)]
        return self._poses[int(value)] if kind == POSE else self._joints[int(value)]

    def _read_names(self) -> list[Bound]:
        tables = self._tables
        texts, arrays, cells = (tables[f"names.{part}"] for part in ("text", "array", "cells"))
        first = check_firsts(tables["names.first"], len(cells), "names")
        require(
            len(first) == len(texts) + 1 == len(arrays) + 1, "columns of names differ in length"
        )
        check_below(texts, len(self._texts), "the texts of names")
        check_below(cells, len(self.cells), "the cells of names")
        numbers = wholes(cells)
        found: list[Bound] = []
        rows = zip(wholes(texts), wholes(arrays), first[:-1], first[1:], strict=True)
        for name, is_array, begin, end in rows:
            own = [self.cells[number] for number in numbers[begin:end]]
            if is_array:
                found.append(_array(self._texts[name], own))
            else:
                require(len(own) == 1, "a variable has no value, or several")
                found.append(own[0])
        return found


def _array(name: str, cells: Sequence[Cell]) -> Array:
    """Return an array of its elements, whose names tell their subscripts: `a[1,2]`."""
    found = Array(name)
    for cell in cells:
        inside = cell.name[len(name) + 1 : -1]
        parts = inside.split(",")
        named = cell.name == f"{name}[{inside}]" and all(
            part.removeprefix("-").isdecimal() and part.isascii() and len(part) <= MOST_SUBSCRIPT
            for part in parts
        )
        require(named, "an element of an array has another name")
        found.elements[tuple([int(part) for part in parts])] = cell
    return found


def _cells_of(bound: Bound) -> list[Cell]:
    return list(bound.elements.values()) if isinstance(bound, Array) else [bound]


def _put(pool: dict[Item, int], item: Item) -> int:
    """Return the number of an item, giving it one."""
    return pool.setdefault(item, len(pool))
