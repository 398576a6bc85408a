"""Building large trees without the garbage collector looking at them again and again."""

import gc
from collections.abc import Generator
from contextlib import contextmanager


@contextmanager
def uncollected() -> Generator[None]:
    """Hold the collector back: what is built inside has no cycles, and counting suffices.

    Its full passes otherwise take a third of the time of a large program, and more the longer it
    is. A collector that is off already stays off.
    """
    if not gc.isenabled():
        yield
        return
    gc.disable()
    try:
        yield
    finally:
        gc.enable()
