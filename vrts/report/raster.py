"""Triangles to pixels: a depth buffer in numpy, for pictures on machines without a GPU.

All triangles become rows of pixels at once, all rows become pixels at once, and one `maximum.at`
leaves the nearest triangle of each pixel. Nothing is shaded here.
"""

from typing import NamedTuple, TypeAlias

import numpy as np
import numpy.typing as npt

Array: TypeAlias = npt.NDArray[np.float64]
Array32: TypeAlias = npt.NDArray[np.float32]
Indices: TypeAlias = npt.NDArray[np.int64]

NOTHING = 0  # depth key of an empty pixel


class Visible(NamedTuple):
    """The pixels that show a triangle, in row-major order."""

    pixel: Indices  # (k,) row * width + column
    triangle: Indices  # (k,) index of the nearest triangle
    nearness: Array32  # (k,) the interpolated `near` value there


def rasterise(points: Array, near: Array, width: int, height: int) -> Visible:
    """Return the nearest triangle of every pixel.

    Args:
        points: Corners on the screen, shape (m, 3, 2): column, row, in pixels; pixel (r, c) covers
            [c, c + 1) x [r, r + 1) and is hit when its centre lies in the triangle.
        near: What grows towards the eye and is linear on the screen (1/depth for a perspective),
            shape (m, 3), positive.
        width: Of the screen in pixels.
        height: Of the screen in pixels.
    """
    edges = _edges(points)
    nearness = _plane(points, near)
    low = np.ceil(points[:, :, 1].min(1) - 0.5).clip(0, height).astype(np.int64)
    high = np.floor(points[:, :, 1].max(1) - 0.5).clip(-1, height - 1).astype(np.int64)
    triangle, row = _expand(low, np.maximum(high - low + 1, 0))
    y = row + 0.5
    left = np.full(len(row), 0.5)
    right = np.full(len(row), width - 0.5)
    for edge in range(3):  # a x + b y + c >= 0 inside
        a, b, c = edges[triangle, edge].T
        with np.errstate(divide="ignore", invalid="ignore"):
            x = -(b * y + c) / a
        left = np.where(a > 0, np.maximum(left, x), left)
        right = np.where(a < 0, np.minimum(right, x), right)
        right = np.where((a == 0) & (b * y + c < 0), -1.0, right)
    start = np.ceil(left - 0.5).astype(np.int64)
    count = np.maximum(np.floor(right - 0.5).astype(np.int64) - start + 1, 0)
    span, column = _expand(start, count)
    of_span = triangle[span].astype(np.int64)
    slope = nearness[triangle]
    value = (slope[:, 1] * y + slope[:, 2])[span] + slope[:, 0][span] * (column + 0.5)
    bits = np.maximum(value, 1e-30).astype(np.float32).view(np.int32).astype(np.int64)
    buffer = np.full(width * height, NOTHING, np.int64)
    np.maximum.at(buffer, (row * width)[span] + column, (bits << 32) | of_span)
    pixel = np.flatnonzero(buffer)
    keys = buffer[pixel]
    depth = (keys >> 32).astype(np.int32).view(np.float32)
    return Visible(pixel, keys & 0xFFFFFFFF, depth)


def on_screen(points: Array, values: Array) -> Array32:
    """Return per triangle the planes through values at its corners.

    Args:
        points: Shape (m, 3, 2), pixels.
        values: Shape (m, 3, k).

    Returns:
        Shape (m, 3, k): coefficients of column, row and 1.
    """
    planes = [_plane(points, values[:, :, k]) for k in range(values.shape[2])]
    return np.stack(planes, axis=2).astype(np.float32)


def signed_area(points: Array) -> Array:
    """Return twice the area on the screen, shape (m,): positive when clockwise with rows down."""
    a, b, c = points[:, 0], points[:, 1], points[:, 2]
    return (b[:, 0] - a[:, 0]) * (c[:, 1] - a[:, 1]) - (b[:, 1] - a[:, 1]) * (c[:, 0] - a[:, 0])


def _edges(points: Array) -> Array:
    """Return (m, 3 edges, 3) coefficients, positive inside whatever the winding."""
    ahead = np.roll(points, -1, axis=1)
    a = points[:, :, 1] - ahead[:, :, 1]
    b = ahead[:, :, 0] - points[:, :, 0]
    c = -(a * points[:, :, 0] + b * points[:, :, 1])
    sign = np.where(signed_area(points) < 0, -1.0, 1.0)[:, None, None]
    return np.stack([a, b, c], axis=2) * sign


def _plane(points: Array, values: Array) -> Array:
    """Return (m, 3): coefficients of x, y and 1 of the plane through three values."""
    a, b, c = points[:, 0], points[:, 1], points[:, 2]
    area = signed_area(points)
    area = np.where(np.abs(area) < 1e-12, 1e-12, area)
    first = values[:, 1] - values[:, 0]
    second = values[:, 2] - values[:, 0]
    gx = (first * (c[:, 1] - a[:, 1]) - second * (b[:, 1] - a[:, 1])) / area
    gy = (second * (b[:, 0] - a[:, 0]) - first * (c[:, 0] - a[:, 0])) / area
    return np.stack([gx, gy, values[:, 0] - gx * a[:, 0] - gy * a[:, 1]], axis=1)


def _expand(start: Indices, count: Indices) -> tuple[Indices, Indices]:
    """Return for each i the values start[i], start[i] + 1, ... count[i] times, with their i."""
    owner = np.repeat(np.arange(len(start)), count)
    first = np.cumsum(count) - count
    return owner, np.arange(len(owner)) - (first - start)[owner]
