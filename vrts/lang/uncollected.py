"""Building large trees without the garbage collector looking at them again and again."""

import gc
from collections.abc import Generator
from contextlib import contextmanager

MANY = 20_000  # things made: fewer are looked through in less than a millisecond


@contextmanager
def uncollected() -> Generator[None]:
    """Hold the collector back: what is built inside has no cycles, and counting suffices.

    Its full passes otherwise take a third of the time of a large program, and more the longer it
    is. What was built is then handed over as old, so that the collector does not look through all
    of it as soon as it is back: its next full pass does. A collector that is off stays off.
    """
    if not gc.isenabled():
        yield
        return
    gc.disable()
    before = gc.get_count()[0]
    try:
        yield
    finally:
        # to ask whether anything is frozen takes as long as much is: so only where much was built
        if gc.get_count()[0] - before > MANY and not gc.get_freeze_count():
            gc.freeze()
            gc.unfreeze()  # into the oldest generation
        gc.enable()
