"""The same points in fewer bytes: as plain numbers as what they are to show allows."""

import numpy as np

from vrts.check.proof.given import Array
from vrts.check.proof.meeting_points import Met
from vrts.geometry.shapes import Hull, Shape

# of coordinates of points [m], and of weights, from plain to exact: few digits pack well
STEPS = ((2.0**-7, 2.0**-4), (2.0**-10, 2.0**-6), (2.0**-13, 2.0**-8), (2.0**-17, 2.0**-12))
MARGIN = 1e-7  # [m] kept for rounding


def plainer(met: Met, shapes: tuple[Shape, Shape], most_m: float) -> Met:
    """Return how one pair meets, with points that may lie elsewhere in their solids.

    Args:
        met: Of one pair.
        shapes: Of its two solids.
        most_m: The points stay at most so far apart [m].
    """
    hulls = [isinstance(shape, Hull) for shape in shapes]
    points: Array = np.einsum("k,ski->si", met.weights, met.corners)
    for step_m, share in STEPS:
        weights = _weights(met.weights, share) if any(hulls) else np.array([1.0, 0.0, 0.0, 0.0])
        corners, moved = met.corners.copy(), 0.0
        for side in (0, 1):
            if not hulls[side]:  # toward the middle, so they lie inside
                corners[side] = np.trunc(points[side] / step_m) * step_m
            moved += float(np.linalg.norm(weights @ corners[side] - points[side]))
        if float(met.apart) + moved < most_m - MARGIN:
            return met._replace(corners=corners, weights=weights)
    return met


def _weights(weights: Array, share: float) -> Array:
    """Return weights that are multiples of a share; the largest takes what is left."""
    found = np.floor(weights / share) * share
    found[weights.argmax()] += 1.0 - found.sum()
    return found
