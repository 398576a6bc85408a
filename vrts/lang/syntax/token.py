"""What one step consists of before it is parsed."""

from typing import NamedTuple


class Token(NamedTuple):
    """A word, number, string or sign of a step."""

    kind: str  # terminal of the grammar
    text: str  # as written
    start: int
    end: int
    value: float | str | None = None  # of numbers and strings
