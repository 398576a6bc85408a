"""What a proposer is asked, and what it may answer.

A proposal decides nothing. It saves time where it is right and costs time where it is wrong, so
that a distance library may lie, fail or die, and no answer changes.
"""

from collections.abc import Sequence
from typing import TYPE_CHECKING, NamedTuple, Protocol, TypeAlias

from vrts.geometry.shapes import Shape

if TYPE_CHECKING:  # numpy is loaded with a proposer, at the first question
    import numpy as np
    import numpy.typing as npt

Array: TypeAlias = "npt.NDArray[np.float64]"


class Questions(NamedTuple):
    """Pairs of shapes, each placed in one frame W."""

    first: Sequence[Shape]  # m shapes A
    second: Sequence[Shape]  # m shapes B
    rotation_a: Array  # of X_WA, (m, 3, 3)
    origin_a: Array  # (m, 3) [m]
    rotation_b: Array  # of X_WB, (m, 3, 3)
    origin_b: Array  # (m, 3) [m]


class Proposals(NamedTuple):
    """One answer to each question; NaN where there is none."""

    normal: Array  # unit vector from A to B, (m, 3)
    first: Array  # a point of A, or near it, (m, 3) [m]
    second: Array  # a point of B, or near it, (m, 3) [m]


class Proposer(Protocol):
    """Whoever proposes: may be wrong, and says so nowhere."""

    @property
    def name(self) -> str:
        """How reports call it."""
        ...

    def propose(self, asked: Questions) -> Proposals:
        """Return a proposal for each question, at once. Never raises."""
        ...
