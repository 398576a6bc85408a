"""Numbers that stand for values of many numbers: each value is compared and kept once."""

import math
from collections.abc import Hashable, Sequence
from itertools import chain
from typing import TypeAlias, cast

import numpy as np
from numpy.typing import NDArray

from vrts.engine.machine.states.nearly import VALUE_DIGITS, Nearly, lasts, nearly
from vrts.engine.memory.records import ArmPiece

Numbers: TypeAlias = NDArray[np.float64]

NO_FARTHER = 10.0**-VALUE_DIGITS  # lists of numbers that differ nowhere by more are the same
NOTHING = (0.0,) * 9  # coefficients
CELL = 1e-7  # of the means by which lists are found: such differences make far less of it
NOBODY = -1  # follows the last piece of a path


class NoFarther:
    """Gives numbers to lists of numbers: the same to all that differ nowhere by more than a little.

    What rounding leaves of the same polynomial may lie on either side of any border between
    rounded numbers; so lists are compared with each other.
    """

    def __init__(self) -> None:
        """Know none."""
        self._known: dict[tuple[Hashable, int], list[tuple[Numbers, int]]] = {}
        self._weights: dict[int, Numbers] = {}  # by how many numbers there are
        self._count = 0

    def number(self, kind: Hashable, values: Numbers) -> int:
        """Return the number of a list.

        Args:
            kind: What else has to be the same.
            values: The list, shape (n,).
        """
        weights = self._weights.get(len(values))
        if weights is None:
            weights = self._weights[len(values)] = _weights(len(values))
        place = float(values @ weights) / CELL
        for cell in {math.floor(place - 0.25), math.floor(place + 0.25)}:
            for other, number in self._known.get((kind, cell), ()):
                if np.abs(values - other).max() <= NO_FARTHER:
                    return number
        self._known.setdefault((kind, math.floor(place)), []).append((values, self._count))
        self._count += 1
        return self._count - 1


class Named(Nearly):
    """Gives numbers to values as they come; those of different objects mean nothing together."""

    def __init__(self) -> None:
        """Know nothing."""
        self._numbers: dict[object, int] = {}
        # by id of what is kept, lest the id comes again
        self._values: dict[int, tuple[object, int]] = {}
        self._paths: dict[int, tuple[ArmPiece, list[int]]] = {}  # by their last piece
        self._pieces = NoFarther()

    def __call__(self, value: object) -> object:
        """Return a number that stands for a tuple; other values are rounded."""
        if not isinstance(value, tuple):
            return nearly(value)
        whole = cast("tuple[object, ...]", value)
        known = self._values.get(id(whole))
        if known is None:
            number = self.number((type(whole).__name__, nearly(whole)))
            known = self._values[id(whole)] = (whole, number)
        return known[1]

    def chain(self, pieces: Sequence[ArmPiece], first: int) -> object:
        """Return what stands for the pieces of a path from one on: a number.

        A path grows and is cut at its end only: its last piece tells all those before it.
        """
        last, count = pieces[-1], len(pieces) - first
        _, known = self._paths.setdefault(id(last), (last, []))
        for piece in reversed(pieces[first : len(pieces) - len(known)]):
            known.append(self.number((self._piece(piece), known[-1] if known else NOBODY)))
        return known[count - 1]

    def number(self, part: object) -> int:
        """Return the number of a value, which is compared as it is."""
        return self._numbers.setdefault(part, len(self._numbers))

    def _piece(self, piece: ArmPiece) -> int:
        """Return the number of a piece, wherever it is in path time.

        All rows are made as long as the longest: rounding may leave one of them a highest power.
        """
        rows = piece.rows
        most = max(map(len, rows))
        whole = (row if len(row) == most else (*row, *NOTHING[len(row) : most]) for row in rows)
        values = np.fromiter(chain.from_iterable(whole), np.float64, most * len(rows))
        return self._pieces.number((most, lasts(piece)), values)


def _weights(count: int) -> Numbers:
    """Return what a mean of so many numbers is made with: no two weights are alike."""
    golden = 0.5 * (math.sqrt(5.0) - 1.0)
    return (1.0 + np.arange(count) * golden % 1.0) / count
