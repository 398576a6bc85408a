"""Proposals by python-fcl, from a child that may die.

fcl throws through C++ where shapes touch exactly, which ends its process. The question it died of
has no answer, the others are asked again; after some deaths nobody is asked any more. All of this
costs time and changes no answer: what is proposed decides nothing.
"""

from collections.abc import Sequence
from types import TracebackType
from typing import Final, Self

import numpy as np
import numpy.typing as npt

from vrts.geometry.proposing.nobody import nothing
from vrts.geometry.proposing.proposer import Proposals, Questions
from vrts.geometry.shapes import Shape
from vrts.marking.proposer import kept as keeping
from vrts.marking.proposer.process import Process
from vrts.marking.proposer.wire import ANSWER, Asked, places_of, proposals, to_bytes

FCL: Final = "fcl"
MOST_DEATHS: Final = 8  # of one proposer
LONGEST_S: Final = 60.0  # for one batch


class ByFcl:
    """Asks the child; to be used in a `with`, which ends it."""

    name: str = FCL

    def __init__(
        self,
        *,
        most_deaths: int = MOST_DEATHS,
        longest_s: float = LONGEST_S,
        kept: str | None = None,
    ) -> None:
        """Start nothing yet.

        Args:
            most_deaths: After so many nobody is asked any more.
            longest_s: For one batch [s].
            kept: Address of a child that is kept, and asked first; None: there is none.
        """
        self.deaths = 0
        self._kept = kept
        self._most_deaths = most_deaths
        self._longest_s = longest_s
        self._process: Process | None = None
        # by who they are, and kept lest another takes the place of one that is gone
        self._numbers: dict[int, tuple[int, Shape]] = {}
        self._given_up = False

    def __enter__(self) -> Self:
        """Start the child, which loads its libraries meanwhile; not where another is kept."""
        if self._kept is None:
            self._started()
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        """End the child."""
        self._end()

    def propose(self, asked: Questions) -> Proposals:
        """Return fcl's answer to each question; NaN where it died, or has died too often."""
        count = len(asked.first)
        found = nothing(count)
        places = places_of(asked)
        done = 0 if self._kept is None else _put(found, 0, _of_kept(self._kept, asked, places))
        while done < count and not self._given_up:
            rest = slice(done, count)
            answers = self._asked(asked.first[rest], asked.second[rest], places[rest])
            done = _put(found, done, answers)
            if done < count:  # it died of this one
                done += 1
                self._bury()
        return found

    def kill(self) -> None:
        """End the child where it stands, as it may end itself; the next question finds out."""
        if self._process is not None:
            self._process.kill()

    def _asked(
        self,
        first: Sequence[Shape],
        second: Sequence[Shape],
        places: npt.NDArray[np.float64],
    ) -> bytes:
        process = self._started()
        new: list[Shape] = []
        pairs = np.array(
            [
                (self._number(a, new), self._number(b, new))
                for a, b in zip(first, second, strict=True)
            ],
            dtype=np.int32,
        )
        message = to_bytes(Asked(tuple(new), pairs, places))
        return process.ask(message, ANSWER * len(pairs), self._longest_s)

    def _number(self, shape: Shape, new: list[Shape]) -> int:
        known = self._numbers.get(id(shape))
        if known is None:
            known = self._numbers[id(shape)] = len(self._numbers), shape
            new.append(shape)
        return known[0]

    def _started(self) -> Process:
        if self._process is not None and self._process.is_of_another:
            self._end()
        if self._process is None:
            self._process = Process()
        return self._process

    def _bury(self) -> None:
        assert self._process is not None
        self.deaths += 1
        self._given_up = self.deaths >= self._most_deaths or not self._process.started
        self._end()

    def _end(self) -> None:
        if self._process is not None:
            self._process.end()
        self._process = None
        self._numbers = {}


def _put(found: Proposals, done: int, answers: bytes) -> int:
    """Put whole answers behind those there are already; return how many there are then."""
    number = len(answers) // ANSWER
    got = proposals(answers[: number * ANSWER])
    for ours, theirs in zip(found, got, strict=True):
        ours[done : done + number] = theirs
    return done + number


def _of_kept(address: str, asked: Questions, places: npt.NDArray[np.float64]) -> bytes:
    """Return the answers of a child that is kept, which knows no shape of other times."""
    shapes = {id(shape): shape for shape in (*asked.first, *asked.second)}
    numbers = {key: number for number, key in enumerate(shapes)}
    pairs = [
        (numbers[id(a)], numbers[id(b)]) for a, b in zip(asked.first, asked.second, strict=True)
    ]
    message = to_bytes(Asked(tuple(shapes.values()), np.array(pairs, dtype=np.int32), places))
    return keeping.asked(address, message, ANSWER * len(pairs))
