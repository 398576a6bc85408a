"""Tables of pairs made of others."""

import numpy as np

from vrts.check.collision.pairs.pairs import Pairs


def joined(a: Pairs, b: Pairs) -> Pairs:
    """Return the rows of both, those of `a` first."""
    return Pairs(
        np.concatenate([a.first, b.first]),
        np.concatenate([a.second, b.second]),
        np.concatenate([a.start_s, b.start_s]),
        np.concatenate([a.end_s, b.end_s]),
        np.concatenate([a.tolerance, b.tolerance]),
        np.concatenate([a.grazes, b.grazes]),
        np.concatenate([a.counts, b.counts]),
        np.concatenate([a.group, b.group]),
    )


def grown(pairs: Pairs, distance: float) -> Pairs:
    """Return the pairs that enter minimum clearance; they touch when nearer than a distance [m]."""
    rows = np.flatnonzero(pairs.counts)
    no = np.zeros(len(rows), dtype=np.bool_)
    return Pairs(
        pairs.first[rows],
        pairs.second[rows],
        pairs.start_s[rows],
        pairs.end_s[rows],
        np.full(len(rows), -distance),
        no,
        no,
        pairs.group[rows],
    )
