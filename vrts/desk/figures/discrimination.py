"""How well a check tells good programs from poor ones.

The corrected item-total correlation: Pearson's correlation of the points for one check with the
points for all the others, over the programs that were checked. The check itself is not in the sum,
or it would agree with itself. Near 1: who passes it does well elsewhere, too. Near 0: it says
nothing of that. Below 0: look whether the check asks for what was meant.
"""

from collections.abc import Sequence
from math import sqrt
from typing import Final

FEWEST: Final = 5  # programs: with fewer, chance says more than the number does


def discrimination(points: Sequence[float], others: Sequence[float]) -> float | None:
    """Return the correlation of a check with the others; None where there is none.

    Args:
        points: For the check, by program.
        others: For all the others together, of the same programs.
    """
    count = len(points)
    if count < FEWEST:
        return None
    mean_p, mean_o = sum(points) / count, sum(others) / count
    from_p, from_o = [p - mean_p for p in points], [o - mean_o for o in others]
    spread = sqrt(sum(p * p for p in from_p)) * sqrt(sum(o * o for o in from_o))
    if spread < 1e-9:  # everybody got the same
        return None
    together = sum(p * o for p, o in zip(from_p, from_o, strict=True))
    return round(max(-1.0, min(1.0, together / spread)), 4)
