"""How far apart convex shapes are, found by trying directions: it shares no code with vrts.

The signed distance of two convex shapes is the widest gap over all directions, and the gap along a
direction is exact arithmetic. So every direction bounds the distance from below, and the best of
many, moved about until it gets no better, is the distance but for the steps of the moving. Neither
simplices nor expanding polytopes are used, nor anybody's library.
"""

from itertools import product
from typing import NamedTuple, TypeAlias

import numpy as np
import numpy.typing as npt
from scipy.optimize import linprog

from vrts.geometry.shapes import Box, Cylinder, Shape

Array: TypeAlias = npt.NDArray[np.float64]

STARTS = 4  # of each question are moved about
MORE = 32  # of one that has to be right: shapes that overlap have many best directions
DENSE = 2000  # directions all round, to begin with then
WAYS = 10  # of moving, tried together
ROUNDS = 100  # of moving
SHRINK = 0.83  # of a move when none was better
WIDEST, FINEST = 0.3, 1e-9  # of a move


class Posed(NamedTuple):
    """A shape at n places in W."""

    shape: Shape
    rotation: Array  # (n, 3, 3)
    origin: Array  # (n, 3) [m]

    def at(self, rows: npt.NDArray[np.int64]) -> "Posed":
        """Return some of the places."""
        return Posed(self.shape, self.rotation[rows], self.origin[rows])


def reach(posed: Posed, ways: Array) -> Array:
    """Return how far a shape lies in directions in W, (n, d, 3) to (n, d) [m]."""
    local = ways @ posed.rotation
    along = np.einsum("ndk,nk->nd", ways, posed.origin)
    match posed.shape:
        case Box(half_extents=half):
            return along + np.abs(local) @ np.array(half)
        case Cylinder(radius=radius, half_length=half_length):
            across = np.hypot(local[..., 0], local[..., 1])
            return along + radius * across + half_length * np.abs(local[..., 2])
        case hull:
            return along + (local @ np.array(hull.points).T).max(axis=2)


def gap(a: Posed, b: Posed, ways: Array) -> Array:
    """Return the gap from A to B along unit directions, (n, d, 3) to (n, d) [m]."""
    return -reach(b, -ways) - reach(a, ways)


def rough(a: Posed, b: Posed) -> tuple[Array, Array]:
    """Return gaps along many directions, (n, d), and these, (n, d, 3): none is too wide."""
    ways = _candidates(a, b)
    return gap(a, b, ways), ways


def distance(a: Posed, b: Posed, seed: int = 0) -> tuple[Array, Array]:
    """Return signed distances, (n,) [m], from below and usually to a micrometre, and directions."""
    gaps, ways = rough(a, b)
    return _moved(a, b, gaps, ways, min(STARTS, gaps.shape[1]), seed)


def surely(a: Posed, b: Posed) -> tuple[Array, Array]:
    """Return the same from many more directions, all round: that of overlaps is the best of all."""
    gaps, ways = rough(a, b)
    round_ = np.tile(_ALL_ROUND, (len(gaps), 1, 1))
    gaps = np.concatenate([gaps, gap(a, b, round_)], axis=1)
    return _moved(a, b, gaps, np.concatenate([ways, round_], axis=1), MORE, 0)


def _moved(
    a: Posed, b: Posed, gaps: Array, ways: Array, starts: int, seed: int
) -> tuple[Array, Array]:
    """Return the widest gaps that are found by moving the best directions about, and where."""
    count = len(gaps)
    best = np.argsort(-gaps, axis=1)[:, :starts]
    way = np.take_along_axis(ways, best[..., None], axis=1).reshape(-1, 3)
    rows = np.repeat(np.arange(count), starts)
    first, second = a.at(rows), b.at(rows)
    value = np.take_along_axis(gaps, best, axis=1).ravel()
    size = np.full(len(rows), WIDEST)
    random = np.random.default_rng(seed)
    for _ in range(ROUNDS):
        turned = random.normal(size=(len(rows), WAYS, 3)) * size[:, None, None]
        tried = _unit(way[:, None, :] + turned)
        gained = gap(first, second, tried)
        k = gained.argmax(axis=1)
        top = gained[np.arange(len(rows)), k]
        better = top > value
        way[better], value[better] = tried[better, k[better]], top[better]
        size = np.where(better, size * 1.2, np.maximum(size * SHRINK, FINEST))
    table = value.reshape(count, starts)
    best_start = table.argmax(axis=1)
    each = np.arange(count)
    return table[each, best_start], way.reshape(count, starts, 3)[each, best_start]


def sharpened(a: Posed, b: Posed, row: int, way: Array) -> float:
    """Return one signed distance to a few nanometres: on ridges moving about gets stuck.

    Near the best direction the gap is the least of what pairs of support points say, and each of
    these is linear; the best direction for those known is a linear programme.

    Args:
        a: A.
        b: B.
        row: Which of their places.
        way: What moving about ended with there, (3,).
    """
    return _climbed(a.at(np.array([row])), b.at(np.array([row])), way)


def _climbed(a: Posed, b: Posed, way: Array) -> float:
    value, radius = float(gap(a, b, way[None, None])[0, 0]), 0.1
    known = [_between(a, b, way)]
    for _ in range(60):
        basis = np.linalg.svd(way[None])[2][1:]  # across the direction
        table = np.array(known)
        rows = np.column_stack([-table @ basis.T, np.ones(len(table))])
        limits = [(-radius, radius), (-radius, radius), (None, None)]
        found = linprog((0.0, 0.0, -1.0), A_ub=rows, b_ub=table @ way, bounds=limits)
        if found.x is None or -found.fun <= value + 1e-10:
            return value
        tried = _unit(way + found.x[:2] @ basis)
        known.append(_between(a, b, tried))
        gained = float(gap(a, b, tried[None, None])[0, 0])
        if gained > value + 1e-12:
            way, value = tried, gained
            radius = min(0.5, radius * 1.5)
        else:
            radius *= 0.5
        if radius < 1e-9:
            return value
    return value


def _between(a: Posed, b: Posed, way: Array) -> Array:
    """Return the way between the points of A and B that face each other along a direction."""
    return _farthest(b, -way) - _farthest(a, way)


def _farthest(posed: Posed, way: Array) -> Array:
    """Return the point of a shape, at its first place, that lies farthest in a direction."""
    local = way @ posed.rotation[0]
    match posed.shape:
        case Box(half_extents=half):
            point = np.where(local < 0.0, -1.0, 1.0) * np.array(half)
        case Cylinder(radius=radius, half_length=half_length):
            across = float(np.hypot(local[0], local[1]))
            share = radius / across if across > 0.0 else 0.0
            end = half_length if local[2] >= 0.0 else -half_length
            point = np.array([share * local[0], share * local[1], end])
        case hull:
            points = np.array(hull.points)
            point = points[(points @ local).argmax()]
    return posed.origin[0] + posed.rotation[0] @ point


def _candidates(a: Posed, b: Posed) -> Array:
    """Return directions in which shapes may be apart, both ways, (n, d, 3)."""
    count = len(a.origin)
    axes_a, axes_b = _axes(a), _axes(b)
    crossed = np.cross(axes_a[:, :, None], axes_b[:, None]).reshape(count, -1, 3)
    between = (_middle(b) - _middle(a))[:, None]
    sphere = np.broadcast_to(_SPHERE, (count, *_SPHERE.shape))
    found = np.concatenate([axes_a, axes_b, crossed, between, sphere], axis=1)
    found = _unit(found)
    return np.concatenate([found, -found], axis=1)


def _axes(posed: Posed) -> Array:
    """Return the axes of a shape's frame in W, (n, 3, 3)."""
    return np.swapaxes(posed.rotation, 1, 2)


def _middle(posed: Posed) -> Array:
    if isinstance(posed.shape, Box | Cylinder):
        return posed.origin
    middle = np.array(posed.shape.points).mean(axis=0)
    return posed.origin + posed.rotation @ middle


def _unit(vectors: Array) -> Array:
    length = np.linalg.norm(vectors, axis=-1, keepdims=True)
    fallback = np.zeros_like(vectors)
    fallback[..., 2] = 1.0
    with np.errstate(invalid="ignore", divide="ignore"):
        return np.where(length > 1e-12, vectors / length, fallback)


_SPHERE = _unit(
    np.array(
        [v for v in product((-1.0, -0.5, 0.0, 0.5, 1.0), repeat=3) if any(v) and v > (0, 0, 0)]
    )
)


def _spread(count: int) -> Array:
    """Return unit vectors all round, evenly spread along a spiral, (count, 3)."""
    height = 1.0 - (2.0 * np.arange(count) + 1.0) / count
    angle = np.pi * (1.0 + np.sqrt(5.0)) * np.arange(count)
    out = np.sqrt(1.0 - height**2)
    return np.column_stack([out * np.cos(angle), out * np.sin(angle), height])


_ALL_ROUND = _spread(DENSE)
