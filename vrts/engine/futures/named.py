"""Numbers that stand for values of many numbers: each value is compared and kept once."""

from collections.abc import Sequence
from hashlib import blake2b
from itertools import chain
from typing import cast

import numpy as np

from vrts.engine.machine.states.nearly import VALUE_DIGITS, Nearly, lasts, nearly
from vrts.engine.memory.records import ArmPiece


class Named(Nearly):
    """Gives numbers to values as they come; those of different objects mean nothing together."""

    def __init__(self) -> None:
        """Know nothing."""
        self._numbers: dict[object, int] = {}
        # by id of what is kept, lest the id comes again
        self._values: dict[int, tuple[object, int]] = {}
        self._paths: dict[int, tuple[ArmPiece, list[bytes]]] = {}  # by their last piece

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
        """Return what stands for the pieces of a path from one on: a digest of their numbers.

        A path grows and is cut at its end only: its last piece tells all those before it.
        """
        last, count = pieces[-1], len(pieces) - first
        _, known = self._paths.setdefault(id(last), (last, []))
        for piece in reversed(pieces[first : len(pieces) - len(known)]):
            known.append(_digest(piece, known[-1] if known else b""))
        return known[count - 1]

    def number(self, part: object) -> int:
        """Return the number of a value, which is compared as it is."""
        return self._numbers.setdefault(part, len(self._numbers))


def _digest(piece: ArmPiece, following: bytes) -> bytes:
    """Return what stands for a piece and all behind it."""
    sizes = [len(row) for row in piece.rows]
    numbers = np.fromiter(chain.from_iterable(piece.rows), np.float64, sum(sizes))
    rows = np.round(numbers, VALUE_DIGITS) + 0.0
    frame = np.array([*sizes, lasts(piece)])
    return blake2b(rows.tobytes() + frame.tobytes() + following, digest_size=16).digest()
