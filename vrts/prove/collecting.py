"""Less often looked for what nobody refers to any more, where a great deal is made and kept."""

import gc
from collections.abc import Generator
from contextlib import contextmanager

MADE = 50_000  # objects between two looks


@contextmanager
def fewer_collections() -> Generator[None]:
    """Let Python look less often for garbage inside, and as often as before afterwards."""
    before = gc.get_threshold()
    gc.set_threshold(MADE, *before[1:])
    try:
        yield
    finally:
        gc.set_threshold(*before)
