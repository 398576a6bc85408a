"""Proposals by coal, in this process."""

import numpy as np

from vrts.geometry.coal_engine import NAME, Pair, transform
from vrts.geometry.proposing.nobody import nothing
from vrts.geometry.proposing.proposer import Proposals, Questions
from vrts.geometry.shapes import Hull, Shape

MOST_PAIRS = 65536  # kept at a time
THINNEST = 1e-6  # hulls thinner than this share of their size end the process within coal
REFUSALS = (RuntimeError, ValueError)  # what coal raises


class ByCoal:
    """Asks coal; where it fails or refuses there is no proposal."""

    name: str = NAME

    def __init__(self) -> None:
        """Know no pair yet."""
        # Hashing a hull reads all its points, so pairs are found by who the shapes are; the
        # shapes are kept beside, lest another takes the place of one that is gone.
        self._pairs: dict[tuple[int, int], tuple[Shape, Shape, Pair | None]] = {}

    def propose(self, asked: Questions) -> Proposals:
        """Return coal's answer to each question; NaN where it has none."""
        found = nothing(len(asked.first))
        normal, first, second = found
        for k, (a, b) in enumerate(zip(asked.first, asked.second, strict=True)):
            known = self._pairs.get((id(a), id(b)))
            pair = self._known(a, b) if known is None else known[2]
            if pair is None:
                continue
            X_WA = transform(asked.rotation_a[k], asked.origin_a[k])
            X_WB = transform(asked.rotation_b[k], asked.origin_b[k])
            try:
                pair.told_into(X_WA, X_WB, normal[k], first[k], second[k])
            except REFUSALS:
                continue
        return found

    def made(self, a: Shape, b: Shape) -> Pair | None:
        """Return what asks coal about two shapes; None: they would end the process."""
        return None if _flat(a) or _flat(b) else Pair(a, b)

    def _known(self, a: Shape, b: Shape) -> Pair | None:
        if len(self._pairs) >= MOST_PAIRS:
            self._pairs.clear()
        pair = self.made(a, b)
        self._pairs[id(a), id(b)] = a, b, pair
        return pair


def _flat(shape: Shape) -> bool:
    """Return whether a shape is a hull that coal cannot bear."""
    if not isinstance(shape, Hull):
        return False
    points = np.array(shape.points)
    if len(points) < 4 or not np.isfinite(points).all():
        return True
    axes = np.linalg.svd(points - points.mean(axis=0), full_matrices=False)[2]
    extents = np.ptp(points @ axes.T, axis=0)
    return bool(extents.min() <= THINNEST * extents.max())
