"""Where a body is while it is held, falls or lies."""

from collections.abc import Sequence
from typing import TypeAlias

import numpy as np
import numpy.typing as npt

from vrts.engine.memory.records import GRAVITY, Lie, Placement

Array: TypeAlias = npt.NDArray[np.float64]


def followed(
    track: Sequence[Placement], times: Array, flange_r: Array, flange_p: Array
) -> tuple[Array, Array]:
    """Return where a body is: rotations, shape (n, 3, 3), and origins, shape (n, 3) [m]."""
    turn, at = np.empty((len(times), 3, 3)), np.empty((len(times), 3))
    begins = [int(np.searchsorted(times, placement.start_s)) for placement in track]
    for placement, begin, end in zip(track, begins, [*begins[1:], len(times)], strict=True):
        now = slice(begin, end)
        R, p = np.array(placement.X.rotation).reshape(3, 3), np.array(placement.X.translation)
        if placement.lie is Lie.HELD:
            turn[now] = flange_r[now] @ R
            at[now] = flange_p[now] + flange_r[now] @ p
            continue
        turn[now], at[now] = R, p
        if placement.lie is Lie.FALLING:
            at[now, 2] -= 0.5 * GRAVITY * (times[now] - placement.start_s) ** 2
    return turn, at
