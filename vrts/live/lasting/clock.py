"""The two clocks of a server: one for how long, one for when. Neither goes back, neither jumps.

`steady` counts seconds from nowhere in particular; turns, leases, rates and absences go by it.
`wall` is Unix time as the machine had it when the process began, and goes on by itself from there:
whatever becomes of the machine's own clock meanwhile, the times that are shown stay in order, and
what ends at a time (log-ins, links, codes) lasts as long as it was meant to. It counts what a
machine sleeps. The machine's clock is asked again by the next process only: if it was set between
the two, what ends at a time ends so much earlier or later. Nothing can be done about that without
a clock to trust.
"""

import time
from typing import Final

_BOOT: Final = getattr(time, "CLOCK_BOOTTIME", time.CLOCK_MONOTONIC)


def steady() -> float:
    """Return the time of a clock that only goes forward; it stands while the machine sleeps [s]."""
    return time.monotonic()


def wall() -> float:
    """Return Unix time by a clock that never jumps [s]."""
    return _WALL_S + (time.clock_gettime(_BOOT) - _BOOT_S)


_WALL_S: Final = time.time()
_BOOT_S: Final = time.clock_gettime(_BOOT)
