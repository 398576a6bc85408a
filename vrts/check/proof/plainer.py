"""The same points in fewer bytes: as plain numbers as what they are to show allows."""

from collections.abc import Iterator

import numpy as np

from vrts.check.proof.given import Array
from vrts.check.proof.meeting_points import Met
from vrts.geometry.shapes import Hull, Shape

# bits of coordinates of points [m], and of weights, from plain to exact: few digits pack well
STEPS = ((7, 4), (10, 6), (13, 8), (17, 12), (20, 15), (22, 18))
MARGIN = 1e-7  # [m] kept for rounding


def plainer(met: Met, shapes: tuple[Shape, Shape], most_m: float) -> Met:
    """Return how one pair meets, with points that may lie elsewhere in their solids.

    Args:
        met: Of one pair.
        shapes: Of its two solids.
        most_m: The points stay at most so far apart [m].
    """
    for other, moved in variants(met, shapes):
        if float(met.apart) + moved < most_m - MARGIN:
            return other
    return met


def variants(met: Met, shapes: tuple[Shape, Shape]) -> Iterator[tuple[Met, float]]:
    """Yield the same with other points, from plain to exact, and how far these lie away [m]."""
    hulls = [isinstance(shape, Hull) for shape in shapes]
    points: Array = np.einsum("k,ski->si", met.weights, met.corners)
    for bits, bits_of_weights in STEPS:
        step_m, share = 2.0**-bits, 2.0**-bits_of_weights
        weights = _weights(met.weights, share) if any(hulls) else np.array([1.0, 0.0, 0.0, 0.0])
        corners, moved = met.corners.copy(), 0.0
        for side in (0, 1):
            if not hulls[side]:  # toward the middle, so they lie inside
                corners[side] = np.trunc(points[side] / step_m) * step_m
            moved += float(np.linalg.norm(weights @ corners[side] - points[side]))
        yield met._replace(corners=corners, weights=weights), moved


def _weights(weights: Array, share: float) -> Array:
    """Return weights that are multiples of a share; the largest takes what is left."""
    found = np.floor(weights / share) * share
    found[weights.argmax()] += 1.0 - found.sum()
    return found
