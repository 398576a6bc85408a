"""From pairs to groups: those who hang together by all of their links, not by a chain of some."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

HANG_TOGETHER = 0.55  # of the strongest link of a group, that the mean of new ones must have
LEAST_LINK = 0.2  # of it, that every link must have


class Group(NamedTuple):
    """Programs that hang together, by their numbers."""

    members: tuple[int, ...]
    links: tuple[tuple[int, int], ...]  # pairs, strongest first
    expected: float  # how many as strong are expected by chance: of the strongest link


def groups_of(
    surprise: NDArray[np.float64],
    expected: NDArray[np.float64],
    compared: NDArray[np.bool_],
    most: float,
) -> list[Group]:
    """Return the groups, strongest first; each program is in one at most.

    Args:
        surprise: Of each pair, shape (class, class + others).
        expected: How many pairs as strong are expected by chance.
        compared: Which pairs are compared, each once.
        most: Links of which more than this are expected are none.
    """
    rows, columns = np.nonzero(compared & (expected <= most))
    order = np.lexsort((columns, rows, -np.round(surprise[rows, columns], 6)))
    edges = [(int(rows[k]), int(columns[k])) for k in order]
    own = len(surprise)
    cluster: dict[int, set[int]] = {}
    best: dict[int, tuple[int, int]] = {}  # of a cluster, by its first member
    home: dict[int, int] = {}
    refused: set[tuple[int, int, int, int]] = set()  # two clusters, and how large they were
    for i, j in edges:
        for one in (i, j):
            if one not in home:
                home[one] = one
                cluster[one] = {one}
        a, b = home[i], home[j]
        kept, gone = min(a, b), max(a, b)
        tried = (kept, gone, len(cluster[kept]), len(cluster[gone]))
        if a == b or tried in refused:
            continue
        between = [
            float(surprise[min(x, y), max(x, y)])
            for x in cluster[a]
            for y in cluster[b]
            if min(x, y) < own and compared[min(x, y), max(x, y)]
        ]
        tops = [best[k] for k in (kept, gone) if k in best] or [(i, j)]
        strongest = max(*between, *(float(surprise[pair]) for pair in tops))
        fits = np.mean(between) >= HANG_TOGETHER * strongest
        if not fits or min(between) < LEAST_LINK * strongest:
            refused.add(tried)
            continue
        cluster[kept] |= cluster.pop(gone)
        for one in cluster[kept]:
            home[one] = kept
        best.pop(gone, None)
        best[kept] = max(tops, key=lambda pair: (surprise[pair], -pair[0], -pair[1]))
    found = [
        Group(
            tuple(sorted(cluster[first])),
            tuple((i, j) for i, j in edges if home[i] == first == home[j]),
            float(expected[top]),
        )
        for first, top in best.items()
    ]
    return sorted(found, key=lambda one: (round(one.expected, 9), one.members))
