"""Contacts, near misses and the smallest clearance, measured again by the other engine.

The poses are the same, so are the shapes.

Where two code bases disagree, one of them is wrong: the verdict stands, and somebody has to look.
"""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from vrts.base.units import mm
from vrts.check.collision.pairs.arm_state import Prober
from vrts.check.collision.pairs.pairs import TOLERANCE


class Witness(NamedTuple):
    """Two solids whose distance a verdict rests on."""

    first: int
    second: int
    time_s: float


def disagreements(ours: Prober, theirs: Prober, witnesses: Sequence[Witness]) -> tuple[str, ...]:
    """Return, in words, every witness about which two engines disagree.

    Whether solids overlap is compared where they do so by more than 0.2 mm, or are farther apart
    than that; distances are compared of solids that are apart, up to the errors of both engines.
    """
    if not witnesses:
        return ()
    i = np.array([witness.first for witness in witnesses], dtype=np.int64)
    j = np.array([witness.second for witness in witnesses], dtype=np.int64)
    times = np.array([witness.time_s for witness in witnesses])
    allowed = ours.engine.error + theirs.engine.error
    found: list[str] = []
    both = zip(ours.distances(i, j, times), theirs.distances(i, j, times), strict=True)
    for k, (a, b) in enumerate(both):
        differ = abs(a) > TOLERANCE and (a < 0.0) != (b < 0.0)
        differ |= a > TOLERANCE and abs(a - b) > allowed
        if differ:
            parts = ours.solids.parts[int(i[k])], ours.solids.parts[int(j[k])]
            found.append(
                f"{parts[0]} and {parts[1]} at {times[k]:.3f} s: {ours.engine.name} measures"
                f" {mm(a):.2f} mm, {theirs.engine.name} {mm(b):.2f} mm"
            )
    return tuple(found)
