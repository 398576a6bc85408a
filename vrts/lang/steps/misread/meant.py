"""What is told of a line that was meant otherwise than it reads."""

from typing import NamedTuple

from vrts.base.diagnostic import Rule


class Meant(NamedTuple):
    """A message about a part of a line; offsets count from the start of its text."""

    rule: Rule
    headline: str
    start: int
    end: int
    help: tuple[str, ...]
    instead: str | None = None  # what to write for that part
    sure: bool = False  # whether it is surely meant
    notes: tuple[str, ...] = ()


VARIABLE = r"\.?[$#]?[A-Za-z][\w.]*(?:[ \t]*\[[^\[\]=]*\])?"  # a name, or an element of an array
