"""Boxes along the axes round solids of an arm at many instants, and how far they can get.

The same quantities as `Solids.places` and `Solids.travel`, but of every solid at every instant: the
instants lie side by side in memory, so that numpy has long rows to work on.
"""

from typing import NamedTuple, TypeAlias

import numpy as np
import numpy.typing as npt

from vrts.geometry.solids import JOINTS, Instants, Motion, Solids

Array: TypeAlias = npt.NDArray[np.float64]
Indices: TypeAlias = npt.NDArray[np.int64]


class Boxes(NamedTuple):
    """Of m solids at n instants."""

    centre: Array  # (3, m, n) in W [m]
    half: Array  # (3, m, n) half extents along the axes of W [m]

    def of(self, solid: int) -> tuple[Array, Array]:
        """Return centre and half extents of one solid, both (3, n)."""
        return self.centre[:, solid], self.half[:, solid]


def boxes(solids: Solids, which: Indices, instants: Instants) -> Boxes:
    """Return the boxes round solids that do not fall, at all instants."""
    count = len(instants.time_s)
    centre = np.empty((3, len(which), count))
    half = np.empty((3, len(which), count))
    for frame in range(JOINTS + 1):
        mine = np.nonzero(solids.frame[which] == frame)[0]
        if not len(mine):
            continue
        solid = which[mine]
        # component a of axis b of the frame at instant n is turned[a, b, n]
        turned = np.ascontiguousarray(instants.frames.rotations[frame].transpose(1, 2, 0))
        rotation = solids.rotation[solid]
        local = solids.origin[solid] + (rotation @ solids.middle[solid][:, :, None])[:, :, 0]
        slide = solids.slide[solid]
        for a in range(3):
            centre[a, mine] = local @ turned[a]
            if slide.any():
                centre[a, mine] += (slide @ turned[a]) * instants.opening
            centre[a, mine] += instants.frames.origins[frame][:, a]
            axes = rotation.transpose(2, 0, 1) @ turned[a]  # (3, m, n): of the axes of the pieces
            size = np.sqrt(np.maximum(0.0, 1.0 - axes[2] ** 2)) * solids.radius[solid, None]
            for b in range(3):
                size += np.abs(axes[b]) * solids.half[solid, b, None]
            half[a, mine] = size
    return Boxes(centre, half)


def travels(solids: Solids, which: Indices, instants: Instants, motion: Motion, at: Boxes) -> Array:
    """Return how far any point of solids can get from where it is at the middle of an interval.

    Returns:
        Bound against each frame L_l, shape (7, m, n), in m; see `Solids.travel`.
    """
    moves = solids.frame[which] - solids.spins[which]  # the last joint that moves it
    ball = solids.ball[which][:, None]
    moved = solids.slides[which][:, None] * motion.slide
    bound = np.empty((JOINTS + 1, *moved.shape))
    bound[JOINTS] = moved
    for joint in range(JOINTS, 0, -1):
        axis = instants.frames.rotations[joint, :, :, 2].T
        origin = instants.frames.origins[joint].T
        along = np.zeros_like(moved)
        square = np.zeros_like(moved)
        for a in range(3):
            offset = at.centre[a] - origin[a]
            square += offset * offset
            offset *= axis[a]
            along += offset
        square -= along * along
        np.maximum(square, 0.0, out=square)
        arm = np.sqrt(square, out=square)
        arm += ball
        arm += moved
        arm *= motion.turn[:, joint - 1]
        arm[moves < joint] = 0.0
        moved = moved + arm
        bound[joint - 1] = moved
    return bound
