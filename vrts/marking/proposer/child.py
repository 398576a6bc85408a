"""The child: asks python-fcl, and may die of it.

`python -m vrts.marking.proposer.child` reads questions and writes an answer to each at once.
"""

import os
from typing import Final

import numpy as np
import numpy.typing as npt

from vrts.geometry.fcl_engine import Pair, transform
from vrts.geometry.shapes import Shape
from vrts.marking.proposer.wire import HEAD, READY, answer_to_bytes, from_bytes

NONE: Final = (np.nan,) * 3


class Answers:
    """Everything that the child knows: shapes as they came, and pairs as they were asked about."""

    def __init__(self) -> None:
        """Know nothing."""
        self.shapes: list[Shape] = []
        self._pairs: dict[tuple[int, int], Pair | None] = {}

    def answer(self, first: int, second: int, places: npt.NDArray[np.float64]) -> bytes:
        """Return fcl's answer about two shapes, or NaN where it has none."""
        pair = self._pair(first, second)
        if pair is None:
            return answer_to_bytes(NONE, NONE, NONE)
        found = pair.nearest(
            transform(places[0:9].reshape(3, 3), places[9:12]),
            transform(places[12:21].reshape(3, 3), places[21:24]),
        )
        normal = found.normal if any(found.normal) else NONE
        return answer_to_bytes(normal, found.first, found.second)

    def _pair(self, first: int, second: int) -> Pair | None:
        key = first, second
        if key not in self._pairs:
            try:
                self._pairs[key] = Pair(self.shapes[first], self.shapes[second])
            except ValueError:  # a flat hull, which has no faces
                self._pairs[key] = None
        return self._pairs[key]


def serve(questions: int, answers: int) -> None:
    """Answer until there are no more questions.

    Args:
        questions: File descriptor to read from.
        answers: File descriptor to write to.
    """
    known = Answers()
    os.write(answers, READY)
    with os.fdopen(questions, "rb", closefd=False) as source:
        while len(head := source.read(HEAD.size)) == HEAD.size:
            length, _, _ = HEAD.unpack(head)
            body = source.read(length)
            if len(body) < length:
                return
            asked = from_bytes(head, body)
            known.shapes += asked.shapes
            rows = zip(asked.pairs.tolist(), asked.places, strict=True)
            for (first, second), places in rows:
                _write(answers, known.answer(first, second, places))


def _write(to: int, data: bytes) -> None:
    while data:
        data = data[os.write(to, data) :]


if __name__ == "__main__":
    serve(0, 1)
