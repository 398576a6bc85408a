"""The parts of a closed surface that hang together, whatever way their normals point.

Where more than two triangles meet at an edge, as where two parts touch, neighbours round the edge
of opposite ways belong together: a part is closed and turned one way throughout in any case.
"""

import math
from collections.abc import Iterator
from typing import TypeAlias

import numpy as np
import numpy.typing as npt

Array: TypeAlias = npt.NDArray[np.float64]
Indices: TypeAlias = npt.NDArray[np.int64]

SAME = 1e-7  # [rad] nearer than this, triangles stand in one place
LEAST = 0.1  # of a unit vector's component that tells one way from the other


def parts_of(vertices: Array, faces: Indices) -> Indices:
    """Return the number of the part that each triangle is of, shape (m,); the first is 0.

    Args:
        vertices: Shape (n, 3).
        faces: Shape (m, 3), each edge as often one way as the other.
    """
    edges = np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]])
    owner = np.tile(np.arange(len(faces)), 3)
    low, high = edges.min(axis=1), edges.max(axis=1)
    order = np.lexsort((owner, high, low))
    key = (low * len(vertices) + high)[order]
    first = np.flatnonzero(np.concatenate([[True], key[1:] != key[:-1]]))
    count = np.diff(np.append(first, len(key)))
    plain = first[count == 2]
    joined = np.stack([owner[order[plain]], owner[order[plain + 1]]], axis=1)
    if len(first) == len(plain):
        return _joined(joined, len(faces))
    patch = _joined(joined, len(faces))
    pairs = [joined]
    for begin, size in zip(first[count > 2].tolist(), count[count > 2].tolist(), strict=True):
        some = order[begin : begin + size]
        around = _around(vertices, faces[owner[some]], edges[some], patch[owner[some]])
        forward = edges[some, 0] < edges[some, 1]
        pairs.append(owner[some[list(_matched(around, forward))]].reshape(-1, 2))
    return _joined(np.concatenate(pairs), len(faces))


def _around(vertices: Array, triangles: Indices, edges: Indices, patch: Indices) -> Indices:
    """Return the order in which triangles stand round an edge they share.

    Those in one place, as where two parts share a face, lie in layers, everywhere in one order.
    """
    start, end = vertices[edges[0].min()], vertices[edges[0].max()]
    apex = triangles.sum(axis=1) - edges.sum(axis=1)
    axis = (end - start) / np.linalg.norm(end - start)
    u = np.cross(axis, np.eye(3)[int(np.argmin(np.abs(axis)))])
    u /= np.linalg.norm(u)
    out = vertices[apex] - start
    turn = np.arctan2(out @ np.cross(axis, u), out @ u)
    turn[turn > math.pi - SAME] -= math.tau
    across = np.cross(axis, out)
    across /= np.maximum(np.linalg.norm(across, axis=1), 1e-300)[:, None]
    upward = np.take_along_axis(across, np.argmax(np.abs(across) > LEAST, axis=1)[:, None], axis=1)
    layer = np.where(upward[:, 0] > 0.0, patch, -patch)
    return np.lexsort((layer, np.round(turn / SAME))).astype(np.int64)


def _matched(order: Indices, forward: npt.NDArray[np.bool_]) -> Iterator[list[int]]:
    """Yield pairs of neighbours of opposite ways, then of those that are left, and so on."""
    waiting: list[int] = []
    for one in order.tolist():
        if waiting and bool(forward[waiting[-1]]) != bool(forward[one]):
            yield [waiting.pop(), one]
        else:
            waiting.append(one)


def _joined(pairs: Indices, count: int) -> Indices:
    """Return which of so many things pairs join, as numbers from 0."""
    label = np.arange(count)
    a, b = pairs.T
    for _ in range(2 * math.ceil(math.log2(count + 1)) + count):  # a few rounds do
        lower = np.minimum(label[a], label[b])
        new = label.copy()
        for ends in (a, b, label[a], label[b]):
            np.minimum.at(new, ends, lower)
        new = new[new]
        if bool((new == label).all()):
            break
        label = new
    return np.unique(label, return_inverse=True)[1].astype(np.int64)
