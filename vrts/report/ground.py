"""The floor under a picture: endless, with a grid of half metres and soft shadows."""

import math

import numpy as np

from vrts.report.camera import Camera
from vrts.report.lighting import SUN, from_srgb
from vrts.report.raster import Array, Array32, rasterise

FLOOR = np.array(from_srgb("#d3d7dc"), np.float32)
SKY = np.array(from_srgb("#eef1f5"), np.float32)
GRID_M = 0.5
LINE_M = 0.006
LINE_LIGHT = 0.80  # what a grid line leaves of the light
SHADOW_LIGHT = 0.50
TEXELS_M = 110.0  # of the shadow, in a metre
SOFT_M = 0.028  # radius of the blur, done three times
FADE_M = (3.0, 9.0)  # the floor fades into the sky between these distances from its middle


def ground(camera: Camera, size: tuple[int, int], height_m: float, corners: Array) -> Array32:
    """Return the light of floor and sky, shape (height, width, 3), linear.

    Args:
        camera: The eye.
        size: Width and height, pixels.
        height_m: Of the floor, z in W [m].
        corners: Of the triangles that throw shadows, in W, shape (m, 3, 3), m.
    """
    width, height = size
    focal = height / 2 / math.tan(camera.field_of_view / 2)
    right, down, forward = (axis.astype(np.float32) for axis in camera.axes())
    x = ((np.arange(width) + 0.5 - width / 2) / focal).astype(np.float32)
    y = ((np.arange(height) + 0.5 - height / 2) / focal).astype(np.float32)
    falling = down[2] * y[:, None] + right[2] * x[None, :] + forward[2]
    reach = np.float32(height_m - camera.eye[2]) / np.minimum(falling, np.float32(-1e-4))
    on: Array32 = np.stack(
        [
            camera.eye[axis]
            + reach * (right[axis] * x[None, :] + down[axis] * y[:, None] + forward[axis])
            for axis in (0, 1)
        ]
    ).astype(np.float32)
    light = np.ones((height, width), np.float32)
    pixel_m = reach / np.float32(focal) / np.maximum(-falling, np.float32(0.05))
    for axis in (0, 1):
        lines: Array32 = (on[axis] / np.float32(GRID_M)).astype(np.float32)
        to_line = np.abs(lines - np.rint(lines)) * GRID_M
        cover = np.clip((LINE_M / 2 + pixel_m / 2 - to_line) / np.maximum(pixel_m, LINE_M), 0, 1)
        light *= 1 - np.float32(1 - LINE_LIGHT) * cover
    spots: Array32 = on
    light *= 1 - np.float32(1 - SHADOW_LIGHT) * _shadow(spots, height_m, corners)
    away = np.hypot(on[0], on[1])
    near = np.clip((FADE_M[1] - away) / (FADE_M[1] - FADE_M[0]), 0, 1)
    near = np.where(falling < 0, near * near * (3 - 2 * near), 0).astype(np.float32)[:, :, None]
    return SKY + near * (FLOOR * light[:, :, None] - SKY)


def _shadow(on: Array32, height_m: float, corners: Array) -> Array32:
    """Return how deep in shadow points of the floor are, from 0 to 1."""
    fall = (corners[:, :, 2:] - height_m) / SUN[2]
    flat = corners[:, :, :2] - fall * SUN[:2]
    room = 4 * SOFT_M
    low = flat.reshape(-1, 2).min(0) - room
    extent = np.ceil((flat.reshape(-1, 2).max(0) + room - low) * TEXELS_M).astype(int) + 1
    columns, rows = int(extent[0]), int(extent[1])
    texels: Array = (flat - low) * TEXELS_M
    seen = rasterise(texels, np.ones((len(flat), 3)), columns, rows)
    texture = np.zeros(columns * rows, np.float32)
    texture[seen.pixel] = 1
    soft = texture.reshape(rows, columns)
    for _ in range(3):
        soft = _blurred(_blurred(soft, round(SOFT_M * TEXELS_M)).T, round(SOFT_M * TEXELS_M)).T
    at = (on - low.astype(np.float32)[:, None, None]) * np.float32(TEXELS_M) - np.float32(0.5)
    x = at[0].clip(0, columns - 2)
    y = at[1].clip(0, rows - 2)
    i, j = x.astype(np.int32), y.astype(np.int32)
    x, y = x - i, y - j
    upper = soft[j, i] * (1 - x) + soft[j, i + 1] * x
    lower = soft[j + 1, i] * (1 - x) + soft[j + 1, i + 1] * x
    return upper * (1 - y) + lower * y


def _blurred(picture: Array32, radius: int) -> Array32:
    """Return the mean of 2 radius + 1 neighbours along the rows."""
    padded = np.pad(picture, ((0, 0), (radius + 1, radius)))
    total = np.cumsum(padded, axis=1, dtype=np.float64)
    width = 2 * radius + 1
    return ((total[:, width:] - total[:, :-width]) / width).astype(np.float32)
