"""How large a share of what is rare two programs have in common, for each pair.

What two programs share counts the logarithm of how seldom others have it, in the class and in all
folders together. What a third of the class has counts nothing.
"""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float32]

BACKGROUND = 10.0  # programs that are thought to stand beside a class, of which nothing is known
COMMON = 0.34  # share of a class from which on something tells nothing
DOUBT = 30.0  # nats that two programs may share by chance
ALONE = 0.2  # what a feature that nobody shares counts in the size of a program
SMALLER = 0.7  # how much the smaller of two programs counts in the size of both
BLOCK = 4096  # features at a time
# weights are multiples of 1/512 nat: sums of a block, in single precision, are exact in whatever
# order they are made, so ranks do not depend on the machine and its threads
EXACT = 512.0


class Shares(NamedTuple):
    """What programs have in common, of one channel."""

    share: Floats  # shape (class, class + others), from 0 to 1; the diagonal means nothing
    same: Floats  # likewise, of the larger of the two, without doubt; 1 where nothing is rare
    common: Floats  # nats of what is common
    digests: NDArray[np.int64]  # of all features, sorted
    weights: NDArray[np.float64]  # nats that it counts when two share one
    owners: NDArray[np.int64]  # how many programs have it

    def weight(self, digest: int) -> tuple[float, int]:
        """Return what a feature counts when two share it, and how many have it."""
        k = int(np.searchsorted(self.digests, digest))
        if k == len(self.digests) or self.digests[k] != digest:
            return 0.0, 0
        return float(self.weights[k]), int(self.owners[k])


def shares(
    own: Sequence[Sequence[int]], others: Sequence[Sequence[int]], given: frozenset[int]
) -> Shares:
    """Return the shares of each program of a class with each of the class and of others.

    Args:
        own: Digests of the features of each program of the class, each once.
        others: The same of programs of other folders.
        given: What everybody was given.
    """
    count, total = len(own), len(own) + len(others)
    lengths = [len(digests) for digests in (*own, *others)]
    flat = np.fromiter(
        (d for digests in (*own, *others) for d in digests), dtype=np.int64, count=sum(lengths)
    )
    owner = np.repeat(np.arange(total), lengths)
    left_out = np.fromiter(sorted(given), dtype=np.int64, count=len(given))
    kept = ~np.isin(flat, left_out)
    flat, owner = flat[kept], owner[kept]
    if not len(flat):
        empty = np.zeros(0, dtype=np.int64)
        nothing = np.zeros((count, total), dtype=np.float32)
        return Shares(nothing, nothing, nothing, empty, np.zeros(0), empty)
    known, token = np.unique(flat, return_inverse=True)
    everywhere = np.bincount(token)
    inside = (owner < count).astype(np.float64)
    here: NDArray[np.float64] = np.bincount(token, inside, len(everywhere)).astype(np.float64)
    weights = _weights(here, everywhere, count, total)
    single = np.where(everywhere == 1, ALONE, 1.0) * weights
    sizes = np.bincount(owner, weights=single[token], minlength=total)
    common = _common(token, owner, weights, everywhere, here, count, total)
    less = np.minimum(sizes[:count, None], sizes[None, :])
    more = np.maximum(sizes[:count, None], sizes[None, :])
    whole = less**SMALLER * more ** (1.0 - SMALLER)
    share = np.minimum(1.0, common / (whole + DOUBT)).astype(np.float32)
    same = np.divide(common, more, out=np.ones_like(common), where=more > 0).astype(np.float32)
    return Shares(share, same, common.astype(np.float32), known, weights, everywhere)


def _weights(
    here: NDArray[np.float64], everywhere: NDArray[np.int64], count: int, total: int
) -> NDArray[np.float64]:
    """Return what it counts when two share something: minus the logarithm of how usual it is."""
    usual = np.maximum(everywhere - 2, 0) / (total + BACKGROUND)
    usual = np.maximum(usual, np.maximum(here - 2, 0) / (count + BACKGROUND))
    usual = np.maximum(usual, 1.0 / (total + BACKGROUND))
    nats = np.maximum(0.0, -np.log(usual) + np.log(COMMON))
    return np.rint(nats * EXACT) / EXACT


def _common(
    token: NDArray[np.int64],
    owner: NDArray[np.int64],
    weights: NDArray[np.float64],
    everywhere: NDArray[np.int64],
    here: NDArray[np.float64],
    count: int,
    total: int,
) -> NDArray[np.float64]:
    """Return the sum of weights of what each pair has in common."""
    useful = (everywhere > 1) & (here > 0) & (weights > 0)
    number = np.cumsum(useful) - 1
    some = useful[token]
    column, row = number[token[some]], owner[some]
    value = weights[token[some]].astype(np.float32)
    order = np.argsort(column, kind="stable")
    column, row, value = column[order], row[order], value[order]
    found = np.zeros((count, total), dtype=np.float64)
    for start in range(0, int(useful.sum()), BLOCK):
        first, last = np.searchsorted(column, (start, start + BLOCK))
        has = np.zeros((total, BLOCK), dtype=np.float32)
        has[row[first:last], column[first:last] - start] = 1.0
        weighs = np.zeros((count, BLOCK), dtype=np.float32)
        own = row[first:last] < count
        weighs[row[first:last][own], column[first:last][own] - start] = value[first:last][own]
        found += weighs @ has.T
    return found
