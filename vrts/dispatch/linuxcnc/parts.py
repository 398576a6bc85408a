"""Everything that an instruction or an expression is made of."""

from collections.abc import Iterator
from typing import cast


def parts(part: object) -> Iterator[object]:
    """Return a part of the IR and all that is in it."""
    yield part
    if isinstance(part, tuple):
        for item in cast("tuple[object, ...]", part):
            yield from parts(item)
