"""How near the counts of two programs are, for each pair: by how few of the class are as near.

Distances are of square roots, in which a count of any size is about as uncertain as another.
"""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from vrts.marking.similarity.weighing.nearness import SAME, nats_of_rank

Floats = NDArray[np.float64]
Counts = Sequence[tuple[str, int]]

TINY = 1e-9  # of a squared distance: rounding


def counted(counts: Sequence[Counts], own: int) -> Floats:
    """Return how near programs of a class are to each of the class and of others, in nats.

    Args:
        counts: Of each program, those of the class first: what is counted, and how often.
        own: How many are of the class.

    Returns:
        Shape (class, class + others); within the class the mean of both directions.
    """
    names = sorted({name for one in counts for name, _ in one})
    columns = {name: k for k, name in enumerate(names)}
    roots = np.zeros((len(counts), len(names)))
    for k, one in enumerate(counts):
        for name, number in one:
            roots[k, columns[name]] = number**0.5
    sizes = (roots**2).sum(axis=1)
    squares = sizes[:own, None] + sizes[None, :] - 2.0 * roots[:own] @ roots.T
    away = np.sqrt(np.where(squares < TINY * (1.0 + sizes[None, :]), 0.0, squares))
    places = np.arange(own)
    away[places, places] = np.inf
    usual = np.sort(away[:, :own], axis=1)
    rank = np.empty(away.shape, dtype=np.int64)
    for k in places:
        rank[k] = np.searchsorted(usual[k], away[k] + SAME, side="right")
    found = nats_of_rank(np.maximum(rank, 1), own)
    found[:, :own] = (found[:, :own] + found[:, :own].T) / 2.0
    found[places, places] = 0.0
    empty = sizes == 0.0
    found[empty[:own]] = 0.0
    found[:, empty] = 0.0
    return found
