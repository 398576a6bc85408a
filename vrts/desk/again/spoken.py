"""What a desk and the process that marks for it say to each other."""

from typing import Final

from msgspec import Struct

LONGEST: Final = 2_000_000  # bytes of a line


class Asked(Struct, frozen=True):
    """What is to be marked."""

    folder: str
    students: tuple[str, ...] | None  # None: everybody


class Said(Struct, frozen=True):
    """How far it is."""

    done: int
    all: int
    ended: bool = False
    problem: str = ""
