"""Contacts, near misses and the smallest clearance, put to somebody else's library.

The poses are the same, so are the shapes. The verdict stands, whatever is said: where somebody
contradicts it, a person has to look.
"""

from collections.abc import Sequence
from typing import NamedTuple, TypeAlias

import numpy as np
import numpy.typing as npt

from vrts.base.units import mm
from vrts.check.collision.pairs.arm_state import Prober
from vrts.check.collision.pairs.pairs import TOLERANCE
from vrts.geometry.proposing.proposer import Proposals, Proposer

Array: TypeAlias = npt.NDArray[np.float64]

NEARER = 2e-5  # [m] a library that measures too far is none to be believed; too near it never does


class Witness(NamedTuple):
    """Two solids whose distance a verdict rests on."""

    first: int
    second: int
    time_s: float


def disagreements(ours: Prober, by: Proposer, witnesses: Sequence[Witness]) -> tuple[str, ...]:
    """Return, in words, every witness about which somebody contradicts us.

    python-fcl measures up to 36 mm too far where faces are parallel and never too near, so what it
    measures farther contradicts nothing. It contradicts where solids that we know apart by more
    than 0.2 mm are nearer to it, and where those that we know to overlap by more are apart to it
    by more than that. What it does not answer it does not contradict.
    """
    if not witnesses:
        return ()
    i = np.array([witness.first for witness in witnesses], dtype=np.int64)
    j = np.array([witness.second for witness in witnesses], dtype=np.int64)
    times = np.array([witness.time_s for witness in witnesses])
    theirs = measured(by.propose(ours.questions(i, j, times)))
    found: list[str] = []
    for k, (a, b) in enumerate(zip(ours.distances(i, j, times), theirs, strict=True)):
        too_near = a > TOLERANCE and b < a - NEARER
        too_far = a < -TOLERANCE and b > TOLERANCE
        if too_near or too_far:
            parts = ours.solids.parts[int(i[k])], ours.solids.parts[int(j[k])]
            found.append(
                f"{parts[0]} and {parts[1]} at {times[k]:.3f} s: {mm(a):.2f} mm proven,"
                f" {by.name} measures {mm(b):.2f} mm"
            )
    return tuple(found)


def measured(proposals: Proposals) -> Array:
    """Return the signed distances that proposals say, (m,) [m]; NaN where they say nothing."""
    between = proposals.second - proposals.first
    along = (between * proposals.normal).sum(axis=1)
    same = (between == 0.0).all(axis=1)  # without a direction, so they touch
    return np.where(same, 0.0, along)
