"""Triangles to pixels: a depth buffer in numpy, for pictures on machines without a GPU.

A triangle is cut at its middle corner into two halves with one line on each side. All halves
become rows of pixels at once, all rows become pixels at once, and one `maximum.at` leaves the
nearest triangle of each pixel. Nothing is shaded here.

A pixel of the buffer is one number: how near its triangle is, above the triangle's own number. So
the greater is the nearer, whatever the order in which triangles come.
"""

from itertools import pairwise
from typing import TypeAlias

import numpy as np
import numpy.typing as npt

Array: TypeAlias = npt.NDArray[np.float64]
Array32: TypeAlias = npt.NDArray[np.float32]
Indices: TypeAlias = npt.NDArray[np.int64]
Numbers: TypeAlias = npt.NDArray[np.int32]
Mask: TypeAlias = npt.NDArray[np.bool_]

NOTHING = 0  # an empty pixel, and its number; the first triangle is number 1
FARTHEST = 1e-30  # nearness is positive
AT_ONCE = 8192  # pixels drawn: what is worked on stays near the processor


def rasterise(
    points: Array,
    near: Array,
    width: int,
    height: int,
    *,
    first: int = 1,
    onto: Indices | None = None,
    top: int = 0,
) -> Indices:
    """Return the buffer of a screen, or of some of its rows, shape (height, width).

    Args:
        points: Corners on the screen, shape (m, 3, 2): column, row, in pixels; pixel (r, c) covers
            [c, c + 1) x [r, r + 1) and is hit when its centre lies in the triangle.
        near: What grows towards the eye and is linear on the screen (1/depth for a perspective),
            shape (m, 3), positive.
        width: Of the screen in pixels.
        height: Of the screen, or how many rows of it, in pixels.
        first: Number of the first triangle, at least 1.
        onto: A buffer in which these triangles appear too; it stays as it is.
        top: The first row.
    """
    buffer = np.zeros((height, width), np.int64) if onto is None else onto.copy()
    a, b, c = (points[:, k, 1] for k in range(3))
    lowest, highest = np.maximum(np.maximum(a, b), c), np.minimum(np.minimum(a, b), c)
    there = np.flatnonzero((lowest > top) & (highest < top + height))
    if not len(there):
        return buffer
    points, near = points[there] - (0, top), near[there]
    triangle, row, left, right = _rows(points, height)
    start = np.ceil(left.clip(0, width) - 0.5).astype(np.int64)
    count = np.ceil(right.clip(0, width) - 0.5).astype(np.int64) - start
    wide = count > 0
    triangle, row, start, count = triangle[wide], row[wide], start[wide], count[wide]
    slope = plane(points, near)[triangle]
    begin = slope[:, 1] * (row + 0.5) + slope[:, 2] + slope[:, 0] * (start + 0.5)
    base = row * width + start
    number = there[triangle] + first
    slant = slope[:, 0].astype(np.float32)
    ends = np.cumsum(count)
    total = int(ends[-1]) if len(ends) else 0
    cuts = np.searchsorted(ends, np.arange(AT_ONCE, total, AT_ONCE)).tolist()
    for k, end in pairwise([0, *cuts, len(ends)]):
        part = slice(k, end)
        _draw(buffer, base[part], count[part], begin[part], slant[part], number[part])
    return buffer


def _draw(
    buffer: Indices, base: Indices, count: Indices, begin: Array, slant: Array32, number: Indices
) -> None:
    """Draw rows of pixels: the first one and how many, nearness and its slant, the triangle."""
    ends = np.cumsum(count)
    along = np.arange(ends[-1] if len(ends) else 0, dtype=np.int32)
    along -= np.repeat((ends - count).astype(np.int32), count)
    value = np.repeat(slant, count)
    value *= along
    value += np.repeat(begin.astype(np.float32), count)
    np.maximum(value, np.float32(FARTHEST), out=value)
    keys = value.view(np.int32).astype(np.int64)
    keys <<= 32
    keys |= np.repeat(number, count)
    along += np.repeat(base.astype(np.int32), count)
    np.maximum.at(buffer.reshape(-1), along, keys)


def numbers(keys: Indices) -> Numbers:
    """Return the triangles of pixels of a buffer."""
    return keys.astype(np.int32)  # the lower half


def nearness(keys: Indices) -> Array32:
    """Return the interpolated `near` value of pixels of a buffer; 0 where nothing is."""
    return (keys >> 32).astype(np.int32).view(np.float32)


def plane(points: Array, values: Array) -> Array:
    """Return (m, 3): coefficients of column, row and 1 of the plane through three values."""
    a, b, c = points[:, 0], points[:, 1], points[:, 2]
    area = signed_area(points)
    area = np.where(np.abs(area) < 1e-12, 1e-12, area)
    first = values[:, 1] - values[:, 0]
    second = values[:, 2] - values[:, 0]
    gx = (first * (c[:, 1] - a[:, 1]) - second * (b[:, 1] - a[:, 1])) / area
    gy = (second * (b[:, 0] - a[:, 0]) - first * (c[:, 0] - a[:, 0])) / area
    return np.stack([gx, gy, values[:, 0] - gx * a[:, 0] - gy * a[:, 1]], axis=1)


def signed_area(points: Array) -> Array:
    """Return twice the area on the screen, shape (m,): positive when clockwise with rows down."""
    a, b, c = points[:, 0], points[:, 1], points[:, 2]
    return (b[:, 0] - a[:, 0]) * (c[:, 1] - a[:, 1]) - (b[:, 1] - a[:, 1]) * (c[:, 0] - a[:, 0])


def _rows(points: Array, height: int) -> tuple[Indices, Indices, Array, Array]:
    """Return every row of every triangle: triangle, row, left and right end on the row's middle.

    A line has the same two ends in both triangles that share it, so no pixel between them is lost.
    """
    order = np.argsort(points[:, :, 1], axis=1, kind="stable")
    x = np.take_along_axis(points[:, :, 0], order, axis=1)
    y = np.take_along_axis(points[:, :, 1], order, axis=1)
    whole = _line(x[:, 0], y[:, 0], x[:, 2], y[:, 2])
    above = _line(x[:, 0], y[:, 0], x[:, 1], y[:, 1])
    below = _line(x[:, 1], y[:, 1], x[:, 2], y[:, 2])
    longer = np.tile(whole, 2)
    shorter = np.concatenate([above, below], axis=1)
    is_left = np.tile(whole[0] * y[:, 1] + whole[1] < x[:, 1], 2)
    rows = np.ceil(y - 0.5).clip(0, height).astype(np.int64)
    low = np.concatenate([rows[:, 0], rows[:, 1]])
    count = np.concatenate([rows[:, 1], rows[:, 2]]) - low
    half = np.repeat(np.arange(len(low)), count)
    row = np.arange(len(half)) - (np.cumsum(count) - count - low)[half]
    middle = row + 0.5
    slant, base = np.where(is_left, longer, shorter)[:, half]
    left = slant * middle + base
    slant, base = np.where(is_left, shorter, longer)[:, half]
    return half % len(points), row, left, slant * middle + base


def _line(x0: Array, y0: Array, x1: Array, y1: Array) -> Array:
    """Return slant and base, shape (2, m): the column as a linear function of the row."""
    high = y1 - y0
    slant = np.where(high > 0, (x1 - x0) / np.where(high > 0, high, 1.0), 0.0)
    return np.stack([slant, x0 - slant * y0])
