"""A small piece of a program that another program may have too."""

from collections.abc import Iterator, Sequence
from enum import Enum
from hashlib import blake2b
from math import floor
from typing import NamedTuple


class Channel(Enum):
    """A kind of evidence. They are measured apart, as one disguise seldom reaches all of them."""

    MOTION = "motion"
    STEPS = "steps"
    NUMBERS = "numbers"
    WORDS = "words"
    TEXT = "text"
    OFFSETS = "offsets"
    MANNER = "manner"
    LINES = "lines"


class Feature(NamedTuple):
    """A piece of a program."""

    channel: Channel
    kind: str
    key: tuple[object, ...]  # numbers and texts; the same for what counts as the same
    line: int  # of the file, from 1; 0: of no line

    @property
    def digest(self) -> int:
        """A number for the piece, the same in every program and on every machine."""
        text = f"{self.channel._value_}|{self.kind}|{self.key!r}".encode("utf-8", "replace")
        return int.from_bytes(blake2b(text, digest_size=8).digest(), "big", signed=True)


def counted(pieces: Sequence[Feature], most: int = 3) -> Iterator[Feature]:
    """Yield pieces, told apart by how often each came before: so a number of them counts too."""
    seen: dict[tuple[str, tuple[object, ...]], int] = {}
    for piece in pieces:
        times = seen.get((piece.kind, piece.key), 0)
        seen[piece.kind, piece.key] = times + 1
        if times < most:
            yield piece._replace(key=(*piece.key, times)) if times else piece


def cells(numbers: Sequence[float], size: float) -> tuple[tuple[int, ...], tuple[int, ...]]:
    """Return the cells of two grids, half a cell apart, in which a point lies.

    Points nearer than a fraction of the size share at least one with high probability.
    """
    one = tuple(floor(n / size) for n in numbers)
    two = tuple(floor(n / size + 0.5) for n in numbers)
    return one, two


def near(
    channel: Channel,
    kind: str,
    before: tuple[object, ...],
    numbers: Sequence[float],
    size: float,
    line: int,
) -> Iterator[Feature]:
    """Yield the features that others share whose numbers are within a tolerance."""
    for grid, cell in enumerate(cells(numbers, size)):
        yield Feature(channel, kind, (*before, size, grid, *cell), line)
