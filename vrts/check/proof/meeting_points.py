"""Directions that part solids, and points in them that come near: proposals for a certificate.

Gilbert, Johnson and Keerthi's method for many pairs of solids at once. Nobody has to believe what
it finds: a direction counts by the gap along it, and points by lying in their solids.
"""

from dataclasses import replace
from itertools import combinations
from typing import NamedTuple

import numpy as np

from vrts.check.proof.given import Array, Flags, Indices
from vrts.geometry.solids import Solids

STEPS = 24
ENOUGH = 1e-7  # [m] between the two bounds of a distance
SMALLER = (2e-4, 2e-3)  # [m] solids that overlap are parted by directions that part smaller ones
SUBSETS = [c for size in (1, 2, 3, 4) for c in combinations(range(4), size)]


class Placed(NamedTuple):
    """Pairs of solids where they are."""

    first: Indices  # (m,)
    second: Indices
    rotation_a: Array  # (m, 3, 3) in W
    origin_a: Array  # (m, 3)
    rotation_b: Array
    origin_b: Array

    def only(self, which: Indices) -> "Placed":
        """Return some of them."""
        solids = self.first[which], self.second[which]
        a = self.rotation_a[which], self.origin_a[which]
        return Placed(*solids, *a, self.rotation_b[which], self.origin_b[which])


class Met(NamedTuple):
    """What is known of pairs."""

    gap: Array  # (m,) they are at least so far apart, or at most so deep in each other [m]
    normal: Array  # (m, 3) along this, from the first to the second
    apart: Array  # (m,) of the two points [m]
    corners: Array  # (m, 2, 4, 3) of which the points are means, in the frames of the pieces
    weights: Array  # (m, 4)


def meet(all_of: Solids, pairs: Placed, normal: Array) -> Met:
    """Return directions and points of pairs; `normal` (m, 3) is where to begin."""
    m = len(normal)
    n = normal / np.maximum(np.linalg.norm(normal, axis=1, keepdims=True), 1e-300)
    n[np.abs(np.linalg.norm(n, axis=1) - 1) > 1e-6] = (0.0, 0.0, 1.0)
    best, best_n, apart = np.full(m, -np.inf), n.copy(), np.full(m, np.inf)
    corners, weights = np.zeros((m, 2, 4, 3)), np.zeros((m, 4))
    across = np.zeros((m, 4, 3))  # corners of the difference of both solids
    live = np.arange(m)
    for _ in range(STEPS):
        some, d = pairs.only(live), n[live]
        x = _support(all_of, some.first, some.rotation_a, d)
        y = _support(all_of, some.second, some.rotation_b, -d)
        reach = some.origin_b + _turned(some.rotation_b, y) - some.origin_a
        reach -= _turned(some.rotation_a, x)
        gap = np.einsum("mi,mi->m", reach, d)
        better = gap > best[live]
        best[live[better]], best_n[live[better]] = gap[better], d[better]
        go = apart[live] - best[live] > ENOUGH
        live, x, y, reach = live[go], x[go], y[go], reach[go]
        if not len(live):
            break
        slot, used = (weights[live] > 0).argmin(axis=1), weights[live] > 0
        corners[live, 0, slot], corners[live, 1, slot], across[live, slot] = x, y, reach
        used[np.arange(len(live)), slot] = True
        found = _nearest_to_zero(across[live], used)
        v = np.einsum("mk,mki->mi", found, across[live])
        size = np.linalg.norm(v, axis=1)
        stuck = size >= apart[live] * (1 - 1e-12)
        weights[live[~stuck]], apart[live[~stuck]] = found[~stuck], size[~stuck]
        n[live] = v / np.maximum(size, 1e-300)[:, None]
        live = live[~(stuck | (found > 0).all(axis=1) | (size < 1e-10))]
    empty = weights.sum(axis=1) == 0
    weights[empty, 0] = 1.0
    some = corners[np.arange(m), :, weights.argmax(axis=1)]
    corners = np.where((weights > 0)[:, None, :, None], corners, some[:, :, None])
    return Met(best, best_n, apart, corners, weights / weights.sum(axis=1, keepdims=True))


def parted(all_of: Solids, pairs: Placed, normal: Array) -> Met:
    """Return the same with better directions for pairs that overlap a little."""
    found = meet(all_of, pairs, normal)
    gap, best = found.gap.copy(), found.normal.copy()
    for by in SMALLER:
        which = np.flatnonzero(gap <= 0)
        if len(which):
            some = pairs.only(which)
            n = meet(_smaller(all_of, by), some, best[which]).normal
            real = gap_along(all_of, some, n)
            better = real > gap[which]
            gap[which[better]], best[which[better]] = real[better], n[better]
    return found._replace(gap=gap, normal=best)


def gap_along(all_of: Solids, pairs: Placed, n: Array) -> Array:
    """Return the gaps of pairs along unit vectors (m, 3), in m."""
    gap = np.einsum("mi,mi->m", pairs.origin_b - pairs.origin_a, n)
    gap -= all_of.reach(pairs.first, pairs.rotation_a, n)
    return gap - all_of.reach(pairs.second, pairs.rotation_b, -n)


def _turned(rotation: Array, vector: Array) -> Array:
    return (rotation @ vector[:, :, None])[:, :, 0]


def _support(all_of: Solids, solid: Indices, rotation: Array, direction: Array) -> Array:
    """Return points of solids farthest along directions of W, (m, 3), in the pieces' frames."""
    local = (direction[:, None, :] @ rotation)[:, 0]
    point = np.where(local < 0, -1.0, 1.0) * all_of.half[solid]
    out = np.hypot(local[:, 0], local[:, 1])
    round_ = all_of.radius[solid] / np.where(out > 0, out, 1.0)
    point[:, :2] += round_[:, None] * local[:, :2]
    hull = all_of.hull[solid]
    which = np.flatnonzero(hull >= 0)
    if len(which):
        corners = all_of.corners[hull[which]]
        far = (corners @ local[which][:, :, None])[:, :, 0].argmax(axis=1)
        point[which] = corners[np.arange(len(which)), far]
    return point


def _nearest_to_zero(points: Array, used: Flags) -> Array:
    """Return weights (m, 4) of the points (m, 4, 3), of those used, that come nearest to zero."""
    best, weights = np.full(len(points), np.inf), np.zeros((len(points), 4))
    for subset in SUBSETS:
        rows = np.flatnonzero(used[:, subset].all(axis=1))
        if not len(rows):
            continue
        corners = points[rows][:, subset]
        w = _weights(corners)
        v = np.einsum("mk,mki->mi", w, corners)
        square = np.einsum("mi,mi->m", v, v)
        square[(w < 0).any(axis=1)] = np.inf
        better = square < best[rows] * (1 - 1e-12)
        rows = rows[better]
        best[rows], weights[rows] = square[better], 0.0
        for place, column in enumerate(subset):
            weights[rows, column] = w[better, place]
    return weights


def _weights(corners: Array) -> Array:
    """Return weights (m, k) of the point nearest to zero in the plane of k corners; -1: none."""
    count = corners.shape[1]
    if count == 1:
        return np.ones((len(corners), 1))
    edges = corners[:, 1:] - corners[:, :1]
    products = edges @ edges.transpose(0, 2, 1)
    right = -np.einsum("mki,mi->mk", edges, corners[:, 0])
    scale = np.prod(np.diagonal(products, axis1=1, axis2=2), axis=1)
    flat = np.linalg.det(products) <= 1e-13 * scale
    products[flat] = np.eye(count - 1)
    found = np.empty(right.shape)
    found[:] = np.linalg.solve(products, right[:, :, None])[:, :, 0]
    found[flat] = -1.0
    return np.column_stack([1.0 - found.sum(axis=1), found])


def _smaller(all_of: Solids, by: float) -> Solids:
    """Return solids that are smaller all round by about a length [m]."""
    half = all_of.half - np.minimum(by, 0.5 * all_of.half)
    radius = all_of.radius - np.minimum(by, 0.5 * all_of.radius)
    corners = all_of.corners.copy()
    for solid in np.flatnonzero(all_of.hull >= 0).tolist():
        size = 0.5 * float(all_of.half[solid].min())
        share = min(by / max(size, 1e-9), 0.5)
        hull = all_of.hull[solid]
        corners[hull] += share * (all_of.middle[solid] - corners[hull])
    return replace(all_of, half=half, radius=radius, corners=corners)
