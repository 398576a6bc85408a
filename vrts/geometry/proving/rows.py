"""Bounds on the distances of many pairs of placed solids at once: directions and points inside.

Both are proofs that anybody can follow. Along a unit vector n from A to B the solids are apart by

    gap(n) = n.(o_b - o_a) - reach_a(n) - reach_b(-n)

or more, whatever n is, since reach is how far a solid gets from its origin in a direction. And two
points, one in each solid, are never nearer than the solids. So where n or the points come from
matters for how good a bound is, never for whether it holds.

Rounding: with solids less than 100 m from the origin, whose points stand less than 10 m from their
own origins, a gap is a sum of fewer than 50 products of numbers below 100; each is rounded by at
most 2^-53 of its size, and n is a unit vector to 1e-12. That is less than 1e-9 m altogether.
`ROUNDING`, which every bound is lowered by, leaves room for what poses are rounded by before.
"""

from typing import NamedTuple, TypeAlias

import numpy as np
import numpy.typing as npt

from vrts.geometry.solids import Places, Solids

Array: TypeAlias = npt.NDArray[np.float64]
Indices: TypeAlias = npt.NDArray[np.int64]

ROUNDING = 2e-6  # [m] that every bound on a distance is lowered by


class Placed(NamedTuple):
    """Some of many solids, each at one place in W."""

    solid: Indices  # (m,)
    rotation: Array  # (m, 3, 3)
    origin: Array  # (m, 3) [m]

    def at(self, which: Indices) -> "Placed":
        """Return some of the rows."""
        return Placed(self.solid[which], self.rotation[which], self.origin[which])


def placed(places: Places, solid: Indices, at: Indices) -> Placed:
    """Return rows of solids at places of a table."""
    return Placed(solid, places.rotations[at], places.origins[at])


def units(way: Array) -> Array:
    """Return directions as unit vectors, shape (m, 3); NaN where there is none."""
    length = np.sqrt(np.einsum("ri,ri->r", way, way))
    good = (length > 1e-9) & (length < np.inf)
    return way / np.where(good, length, np.nan)[:, None]


def gaps(solids: Solids, a: Placed, b: Placed, normal: Array) -> Array:
    """Return how far solids are apart at least along unit vectors, shape (m,), in m.

    Args:
        solids: What the rows are of.
        a: First solids.
        b: Second solids.
        normal: From the first to the second, shape (m, 3); -inf comes of what is no unit vector.
    """
    between = np.einsum("ri,ri->r", b.origin - a.origin, normal)
    between -= solids.reach(a.solid, a.rotation, normal)
    between -= solids.reach(b.solid, b.rotation, -normal)
    length = np.einsum("ri,ri->r", normal, normal)
    return np.where(np.abs(length - 1.0) < 1e-12, between, -np.inf)


def pulled_in(solids: Solids, of: Placed, points: Array) -> Array:
    """Return points inside boxes and cylinders, near points anywhere, shape (m, 3), in m.

    NaN comes of hulls, whose faces are not known, and of points that are not finite.
    """
    local = ((points - of.origin)[:, None, :] @ of.rotation)[:, 0]
    half, radius = solids.half[of.solid], solids.radius[of.solid]
    pulled = np.clip(local, -half, half)
    across = np.hypot(local[:, 0], local[:, 1])
    share = np.minimum(1.0, radius / np.maximum(across, 1e-300))
    pulled[:, :2] += local[:, :2] * np.where(radius > 0.0, share, 0.0)[:, None]
    known = (solids.hull[of.solid] < 0) & np.isfinite(across)
    found = of.origin + (of.rotation @ pulled[:, :, None])[:, :, 0]
    return np.where(known[:, None], found, np.nan)


def depths(solids: Solids, of: Placed, points: Array) -> Array:
    """Return how deep points lie in boxes and cylinders, shape (m,); below zero: outside [m].

    -inf comes of hulls, and of points that are not finite.
    """
    local = ((points - of.origin)[:, None, :] @ of.rotation)[:, 0]
    room = solids.half[of.solid] - np.abs(local)
    radius = solids.radius[of.solid]
    across = radius - np.hypot(local[:, 0], local[:, 1])
    sides = np.where(radius > 0.0, across, np.minimum(room[:, 0], room[:, 1]))
    known = (solids.hull[of.solid] < 0) & np.isfinite(across)
    return np.where(known, np.minimum(sides, room[:, 2]), -np.inf)


def uppers(solids: Solids, a: Placed, b: Placed, first: Array, second: Array) -> Array:
    """Return signed distances that solids do not exceed, shape (m,), by points; inf: not shown.

    Args:
        solids: What the rows are of.
        a: First solids.
        b: Second solids.
        first: Points in the first ones, or near them, shape (m, 3), in m.
        second: Points in the second ones, or near them.
    """
    x, y = pulled_in(solids, a, first), pulled_in(solids, b, second)
    between = x - y
    found = np.sqrt(np.einsum("ri,ri->r", between, between))
    middle = 0.5 * (x + y)
    in_a, in_b = depths(solids, a, middle), depths(solids, b, middle)
    # a ball round a point inside both, as far as either side
    both = (in_a >= 0.0) & (in_b >= 0.0)
    found = np.where(both, -(in_a + in_b), found)
    return np.where(np.isnan(found), np.inf, found)
