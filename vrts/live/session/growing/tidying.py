"""Memory given back at moments that are chosen, so that no beat waits for a long collection.

What has survived is not looked at again: it grows with the session and is nearly all needed.
"""

import gc

PAUSE = 10.0  # [s] of session time between collections
SELDOM = 1_000_000  # collections of the middle generation before one of everything


class Tidying:
    """Collects garbage while a session goes on."""

    def __init__(self) -> None:
        """Take everything that is loaded as needed."""
        first, second, _ = gc.get_threshold()
        gc.set_threshold(first, second, SELDOM)
        tidy()
        self._last_s = 0.0

    def beat(self, time_s: float) -> None:
        """Collect, if it is time."""
        if not 0.0 <= time_s - self._last_s < PAUSE:
            self._last_s = time_s
            tidy()


def tidy() -> None:
    """Collect the garbage since the last time; what is left counts as needed from now on."""
    gc.collect()
    gc.freeze()
