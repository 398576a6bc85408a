"""Fewer points with nearly the same convex hull."""

import math
from typing import TypeAlias

import numpy as np
import numpy.typing as npt

Array: TypeAlias = npt.NDArray[np.float64]

DIRECTIONS = 3000  # in which the two hulls are compared
AT_ONCE = 1000  # points, so that meshes of any size fit into memory


def thinned(points: Array, tolerance: float) -> Array:
    """Return some of the points, so that their hull reaches nearly as far in every direction.

    Greedy: the point that stands out farthest in the worst direction is added until none stands
    out by more than the tolerance. Deterministic: directions are fixed, ties go to the first point.

    Args:
        points: Shape (n, 3), in m.
        tolerance: By which points may stand out of the hull in the directions looked at, in m.

    Returns:
        Shape (m, 3), m <= n.
    """
    directions = sphere(DIRECTIONS)
    wanted = np.full(DIRECTIONS, -np.inf)
    for first in range(0, len(points), AT_ONCE):
        heights = points[first : first + AT_ONCE] @ directions.T
        wanted = np.maximum(wanted, heights.max(axis=0))
    kept = [int((points @ directions[column]).argmax()) for column in _axes(directions)]
    reached = (points[kept] @ directions.T).max(axis=0)
    while True:
        worst = int((wanted - reached).argmax())
        if wanted[worst] - reached[worst] <= tolerance:
            return points[sorted(set(kept))]
        kept.append(int((points @ directions[worst]).argmax()))
        reached = np.maximum(reached, points[kept[-1]] @ directions.T)


def sphere(count: int) -> Array:
    """Return unit vectors spread evenly (a Fibonacci spiral), shape (count, 3)."""
    number = np.arange(count)
    z = 1.0 - (2.0 * number + 1.0) / count
    turn = math.pi * (1.0 + math.sqrt(5.0)) * number
    level = np.sqrt(1.0 - z * z)
    return np.column_stack([level * np.cos(turn), level * np.sin(turn), z])


def _axes(directions: Array) -> list[int]:
    """Return which directions are nearest to both ways along x, y and z."""
    return [int((sign * directions[:, k]).argmax()) for k in range(3) for sign in (-1, 1)]
