"""Arithmetic that the checker needs: rows of pairs, leaves of intervals, points in solids."""

from collections.abc import Sequence
from math import inf

import numpy as np

from vrts.check.proof.given import (
    DEEPEST,
    DIRECTION,
    EXACT,
    EXCUSED,
    KEEPS,
    NEAR,
    WITNESS,
    Apart,
    Array,
    Claims,
    Covered,
    Demand,
    Evidence,
    Flags,
    Indices,
    Leaves,
    Near,
    Points,
    Rows,
    Wrong,
)
from vrts.geometry.shapes import Box, Cylinder, Hull, Shape
from vrts.geometry.solids import Solids

LET_GO = 2e-4  # [m] nothing nearer than this has been apart
SAME = 1e-9  # [s] times that differ by less are one


def rows_of(todo: Covered, claims: Claims) -> Rows:
    """Return the pairs of solids of all demands, one demand after the other."""
    demands = todo.demands
    size = np.array([len(d.first) * len(d.second) for d in demands])
    none = [np.empty(0, dtype=np.int64)]
    first = np.concatenate(none + [np.repeat(d.first, len(d.second)) for d in demands])
    second = np.concatenate(none + [np.tile(d.second, len(d.first)) for d in demands])
    demand = np.repeat(np.arange(len(demands)), size)
    floor = -inf if claims.clearance_m is None else claims.clearance_m
    least = np.array([max(-d.tolerance, floor if d.counts else -inf) for d in demands])
    start_s, end_s = np.array([(d.start_s, d.end_s) for d in demands]).T[:, demand]
    return Rows(first, second, start_s, end_s, least[demand], demand, np.cumsum(size) - size, size)


def unions_of(todo: Covered) -> tuple[Indices, Indices, Indices]:
    """Return the solids of all unions, where each union begins, and both unions of demands."""
    number: dict[Sequence[int], int] = {}
    sides = [[number.setdefault(u, len(number)) for u in (d.first, d.second)] for d in todo.demands]
    members = [np.array(union) for union in number]
    begin = np.cumsum([0, *map(len, members[:-1])])
    return np.concatenate(members), begin, np.array(sides).T


def within(begin: Indices, size: Indices) -> tuple[Indices, Indices]:
    """Return all numbers of ranges, and which range each is of."""
    which = np.repeat(np.arange(len(size)), size)
    return begin[which] + np.arange(len(which)) - (np.cumsum(size) - size)[which], which


def check_places(by: Evidence, rows: Rows, solids: int) -> None:
    """Check that evidence is about rows, intervals and solids that there are.

    Raises:
        Wrong: It is not.
    """
    edges, x = by.edges, by.leaves
    if (np.diff(edges) <= 0).any() or not np.isin([rows.start_s, rows.end_s], edges).all():
        raise Wrong("its intervals are not those of the run")
    limits = (
        len(rows.first),
        len(edges) - 1,
        DEEPEST + 1,
        1 << x.depth.clip(0, DEEPEST),
        EXCUSED + 1,
    )
    numbers = [
        *zip(x[:5], limits, strict=True),
        (by.points.use, KEEPS + 1),
        (by.points.solids, solids),
    ]
    if any(((number < 0) | (number >= limit)).any() for number, limit in numbers):
        raise Wrong("it is about something that is not there")
    if ((x.kind == DIRECTION) != x.normal.any(axis=1)).any():
        raise Wrong("a direction is missing")
    if (by.points.use == WITNESS).sum() % 4:
        raise Wrong("four points show a contact, and some are missing")


def spans_of(leaves: Leaves, edges: Array) -> tuple[Array, Array]:
    """Return start and end of leaves [s]."""
    step = np.diff(edges)[leaves.root] / 2.0**leaves.depth
    return edges[leaves.root] + leaves.part * step, edges[leaves.root] + (leaves.part + 1) * step


def whole(leaves: Leaves, key: Indices) -> Flags:
    """Return which leaves go on where the one before them ends.

    Args:
        leaves: In the order of their keys, then of time.
        key: Of the row and the root interval; leaves of one key fill it.
    """
    if not len(key):
        return np.empty(0, dtype=np.bool_)
    up = DEEPEST - leaves.depth
    begins, ends = leaves.part << up, (leaves.part + 1) << up
    new = np.append(True, np.diff(key) != 0)
    last = np.append(new[1:], True)
    ordered = np.append(True, np.diff(key) >= 0)
    return (
        ordered & (begins == np.where(new, 0, np.roll(ends, 1))) & (~last | (ends == 1 << DEEPEST))
    )


def inside(of: Solids, solid: Indices, corners: Array, weights: Array) -> Array:
    """Return means of points of solids, (p, 3), in the frames of the pieces.

    Args:
        of: All solids.
        solid: Which, (p,).
        corners: Points that lie in them, (p, 4, 3); of a hull each is one of its corners.
        weights: Of the points, (p, 4).

    Raises:
        Wrong: They do not lie in them, or the weights are none.
    """
    numbers: list[int] = solid.tolist()
    for one, points in zip(numbers, corners, strict=True):
        if not _holds(of.shapes[one], points):
            raise Wrong("a point does not lie in its solid", None, (of.parts[one],))
    if (weights < 0).any() or np.abs(weights.sum(axis=1) - 1).max(initial=0) > EXACT:
        raise Wrong("the weights of points are not those of a mean")
    return np.einsum("pk,pki->pi", weights, corners)


def _holds(shape: Shape, points: Array) -> bool:
    """Return whether points (4, 3) lie in a shape, as corners if it is a hull.

    A hull is its points here and in all of this room, and never its faces: how far it reaches is
    the farthest of its points, what lies in it is a mean of them. So a certificate cannot use faces
    that leave a point out. Pieces of meshes, which are proven by planes, are looked at elsewhere.
    """
    match shape:
        case Box(half_extents=half):
            return bool((np.abs(points) <= np.array(half) + EXACT).all())
        case Cylinder(radius=radius, half_length=half_length):
            out, along = np.hypot(points[:, 0], points[:, 1]), np.abs(points[:, 2])
            return bool(((out <= radius + EXACT) & (along <= half_length + EXACT)).all())
        case Hull(points=corners):
            away = np.abs(points[:, None] - np.array(corners)).max(axis=2).min(axis=1)
            return bool((away <= EXACT).all())


def depth(corners: Array) -> float:
    """Return the radius of the ball round zero that lies in a tetrahedron (4, 3)."""
    found = np.inf
    for k in range(4):
        p, q, r = np.delete(corners, k, axis=0)
        n = np.empty(3)
        n[:] = np.cross(q - p, r - p)
        n /= max(float(np.linalg.norm(n)), 1e-30)
        found = min(found, float(-(n @ p) * np.sign(n @ (corners[k] - p))))
    return found


def dot(a: Array, b: Array) -> Array:
    """Return scalar products of vectors, both (m, 3)."""
    return (a * b).sum(axis=1)


def turned(rotation: Array, vector: Array) -> Array:
    """Return vectors (m, 3) turned by rotations (m, 3, 3)."""
    return (rotation * vector[:, None, :]).sum(axis=2)


def boxes(of: Solids, solid: Indices, rotation: Array, origin: Array) -> tuple[Array, Array]:
    """Return lower and upper corners of the boxes round solids along the axes of W, (m, 3)."""
    ways = [np.tile(axis, (len(solid), 1)) for axis in np.eye(3)]
    high = [of.reach(solid, rotation, way) for way in ways]
    low = [of.reach(solid, rotation, -way) for way in ways]
    return origin - np.stack(low, axis=1), origin + np.stack(high, axis=1)


def between(low_a: Array, high_a: Array, low_b: Array, high_b: Array) -> Array:
    """Return the distances of boxes, less than zero where they overlap."""
    gap = np.maximum(low_b - high_a, low_a - high_b)
    most = np.empty(len(gap))
    most[:] = gap.max(axis=1)
    apart = np.sqrt(np.square(np.maximum(gap, 0)).sum(axis=1))
    return np.where(most > 0, apart, most)


def ordered(of: Solids, i: Indices, j: Indices) -> tuple[Indices, Indices]:
    """Return pairs of solids so that the first moves as seen from the frame of the second."""
    swap = of.frame[j] > of.frame[i]
    swap |= (of.frame[j] == of.frame[i]) & of.falls[j]
    return np.where(swap, j, i), np.where(swap, i, j)


def once(still: Flags, count: int) -> tuple[Indices, Indices, Indices]:
    """Return solids and intervals at which to place them: once what never moves.

    Returns:
        Solids and intervals, (m,), and which of the m is a solid in each interval, (s, count).
    """
    each = np.where(still, 1, count)
    first = np.cumsum(each) - each
    solid = np.repeat(np.arange(len(each)), each)
    place = first[:, None] + np.where(still[:, None], 0, np.arange(count))
    return solid, np.arange(len(solid)) - first[solid], place


def beyond_m(claims: Claims) -> float:
    """Return how far apart things count again when they come nearer; inf: no distance counts.

    Raises:
        Wrong: It is not said.
    """
    if claims.clearance_m is None:
        return inf
    if claims.near_miss_m is None:
        raise Wrong("it does not say what a near miss is")
    return max(claims.near_miss_m, LET_GO)


def looked(one: Near, t: float, points: Points) -> tuple[Flags, list[tuple[int, int]]]:
    """Return which points show how near two unions are at an instant, and all pairs of solids."""
    there = [s for x in one.stays if x.span[0] <= t <= x.span[1] for s in x.solids]
    shown = np.isin(points.solids[:, 0], one.first) & np.isin(points.solids[:, 1], there)
    shown &= (points.use == NEAR) & (np.abs(points.time_s - t) < SAME)
    return shown, [(i, j) for i in one.first for j in there]


def columns_of(
    rows: Sequence[Apart], points: Points, spots: Array
) -> tuple[Indices, Indices, Array, Array, Array]:
    """Return pairs of solids, instants, and how far apart they are to be, as columns.

    Args:
        rows: The pairs.
        points: Those that show by their directions that pairs keep apart.
        spots: Where points are, (p, 2, 3), in W.

    Returns:
        Solids, solids, times, least distances, and directions (r, 3): zero where none is shown.
    """
    ways: dict[tuple[int, int], list[tuple[float, int]]] = {}
    for k in np.flatnonzero(points.use == KEEPS).tolist():
        i, j = points.solids[k].tolist()
        ways.setdefault((i, j), []).append((float(points.time_s[k]), k))
    n = np.zeros((len(rows), 3))
    for own, row in zip(n, rows, strict=True):
        for time_s, k in ways.get((row.first, row.second), ()):
            if abs(time_s - row.time_s) < SAME:
                own[:] = spots[k, 1] - spots[k, 0]
    first, second = (np.array([row[k] for row in rows], dtype=np.int64) for k in (0, 1))
    time_s, least = (np.array([row[k] for row in rows], dtype=np.float64) for k in (2, 3))
    return first, second, time_s, least, n


def demands_of(todo: Covered, points: Points, which: Indices) -> list[Demand]:
    """Return the demands for two solids at the time of some points, if these are of the same."""
    (i, j), t = points.solids[which[0]].tolist(), float(points.time_s[which[0]])
    if (points.solids[which] != (i, j)).any() or (points.time_s[which] != t).any():
        return []
    there = (d for d in todo.demands if d.start_s <= t <= d.end_s)
    return [d for d in there if i in d.first and j in d.second]
