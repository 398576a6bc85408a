"""Thin dark lines where a solid ends before another, and where it has an edge."""

import numpy as np

from vrts.report.picture.projection import Projected
from vrts.report.picture.raster import Array32, Indices, Mask, Numbers, nearness, numbers

LINE = 0.42  # how much of the light an outline keeps
CREASE_LINE = 0.80  # the same of an inner edge
SHARP = 0.8  # cosine of the angle between faces from which on there is an edge
STEP = 0.05  # share of the depth from which on a solid ends before itself


def outlines(
    buffer: Indices,
    number: Numbers,
    solid: Numbers,
    seen: Projected,
    corner: tuple[int, int],
    wanted: Mask | None = None,
) -> Array32:
    """Return how much of its light every pixel of a buffer keeps.

    Args:
        buffer: Part of a screen, shape (height, width).
        number: The triangles in it.
        solid: The solids in it.
        seen: What the screen shows.
        corner: Column and row of the first pixel on the screen.
        wanted: Which pixels are asked about; None: all.
    """
    height, width = buffer.shape
    keep = np.ones(height * width, np.float32)
    keys, solids = buffer.reshape(-1), solid.reshape(-1)
    steps = ((np.s_[:, 1:], np.s_[:, :-1], (1, 0)), (np.s_[1:], np.s_[:-1], (0, 1)))
    for ahead, behind, (right, down) in steps:
        differs = number[ahead] != number[behind]
        if wanted is not None:
            differs &= wanted[ahead] | wanted[behind]
        one = np.flatnonzero(differs)
        if right:
            one += one // (width - 1)
        next_one: Indices = one + (right + down * width)
        after, before = keys.take(next_one), keys.take(one)
        other = solids.take(next_one) != solids.take(one)
        nearer = after > before
        keep[next_one[other & nearer]] = LINE
        keep[one[other & ~nearer]] = LINE
        same = np.flatnonzero(~other)
        one, after, before = one.take(same), after.take(same), before.take(same)
        y, x = np.divmod(one, width)
        place = np.array([x + (corner[0] + 0.5), y + (corner[1] + 0.5)], np.float32)
        next_to = place + np.array([[right], [down]], np.float32)
        edge = one[_edges(seen, (after, next_to), (before, place))]
        keep[edge] = np.minimum(keep[edge], CREASE_LINE)
    return keep.reshape(height, width)


def _edges(seen: Projected, one: tuple[Indices, Array32], other: tuple[Indices, Array32]) -> Mask:
    """Return between which pixels (keys and places) of one solid there is an edge."""
    cosine = np.einsum("ij,ij->j", _normals(seen, *one), _normals(seen, *other))
    a, b = nearness(one[0]), nearness(other[0])
    return (cosine < SHARP) | (np.abs(a - b) > STEP * np.maximum(a, b))


def _normals(seen: Projected, keys: Indices, place: Array32) -> Array32:
    planes = seen.planes[:3].take(numbers(keys), axis=2)
    facing = planes[:, 0] * place[0] + planes[:, 1] * place[1] + planes[:, 2]
    facing /= np.sqrt(np.einsum("ij,ij->j", facing, facing))
    return facing
