"""A line of an answer that may lead somewhere."""

from typing import NamedTuple


class Listed(NamedTuple):
    """A line of an answer, and the number by which one can `go` there; None: nowhere."""

    text: str
    go: int | None = None
