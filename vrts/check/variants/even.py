"""How much harder one variant may be than another: `even` in `[variants]`."""

from typing import NamedTuple

from vrts.base.toml.reading import Table
from vrts.base.units import MM

KEY = "even"
LEAST, MOST = 0.01, 10.0  # of a share
LEAST_MM, MOST_MM = 0.1, 1000.0


class Even(NamedTuple):
    """How far from the median of all variants each may be."""

    time: float = 0.15  # share of the median duration of the reference
    clearance: float = 0.010  # [m] of the least certified distance of its run
    accuracy: float = 0.2  # share of the median room that a program has


USUAL = Even()


def read_even(section: Table) -> Even:
    """Return the bounds that `[variants]` sets; the usual ones where it sets none."""
    table = section.table(KEY)
    if table is None:
        return USUAL
    time = table.number("time", USUAL.time, minimum=LEAST, maximum=MOST)
    clearance = table.number(
        "clearance_mm", round(USUAL.clearance / MM, 6), minimum=LEAST_MM, maximum=MOST_MM
    )
    accuracy = table.number("accuracy", USUAL.accuracy, minimum=LEAST, maximum=MOST)
    table.finish()
    return Even(time, clearance * MM, accuracy)
