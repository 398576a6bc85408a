"""What a search went through."""

from typing import NamedTuple


class Counts(NamedTuple):
    """How much of each there was."""

    states: int
    decisions: int
    merged: int
    ends: int
