"""Programs as they are handed in, and how they are to be read; nothing is compiled yet."""

from typing import NamedTuple


class ProgramFile(NamedTuple):
    """The bytes of a program, and its name as shown."""

    data: bytes
    name: str


class Reading(NamedTuple):
    """How programs are read."""

    dialect: str | None = "val2"  # None: as file name and content tell
    precedence: str | None = None  # "A" or "B"; None: as the dialect has it
    replace: bool = False  # a program that comes again takes the place of the first
    others: tuple[ProgramFile, ...] = ()  # compiled together with the program


STRICT = Reading()
