"""Room on the stack for expressions that are nested deeply."""

import sys
from collections.abc import Generator
from contextlib import contextmanager

DEPTH = 8000  # calls; an expression may be 400 levels deep, and a level takes a few calls


@contextmanager
def deep_stack() -> Generator[None]:
    """Let calls nest far enough inside, and no less than before afterwards."""
    before = sys.getrecursionlimit()
    if before >= DEPTH:
        yield
        return
    sys.setrecursionlimit(DEPTH)
    try:
        yield
    finally:
        sys.setrecursionlimit(before)
