"""What a recording holds without a time, ready to be sent: it can be made before one is opened."""

from collections.abc import Sequence, Sized
from functools import lru_cache
from typing import cast

import rerun as rr
from rerun.chunk import Chunk

KEPT = 64  # names of curves


def static_chunk(path: str, *things: rr.AsComponents, at: Sequence[rr.TimeColumn] = ()) -> Chunk:
    """Return what is so at all times at a path, or from one time on."""
    columns: list[rr.ComponentColumn] = []
    for thing in things:
        for batch in thing.as_component_batches():
            values = cast(Sized, batch.as_arrow_array())  # pyright: ignore[reportUnknownMemberType]
            name = batch.component_descriptor()
            columns.append(rr.ComponentColumn(name, batch, lengths=[len(values)]))
    return Chunk.from_columns(path, at, columns)


@lru_cache(maxsize=KEPT)
def curves(path: str, names: tuple[str, ...], color: tuple[int, int, int] | None = None) -> Chunk:
    """Return how the curves at a path are called, and the colour of all of them."""
    colors = None if color is None else [color] * len(names)
    return static_chunk(path, rr.SeriesLines(names=list(names), colors=colors))
