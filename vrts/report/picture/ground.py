"""The floor under a picture: endless, with a grid of half metres and soft shadows."""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from vrts.report.picture.camera import Camera
from vrts.report.picture.lighting import SUN_FRAME, ShadowMap, from_srgb
from vrts.report.picture.projection import focal_length
from vrts.report.picture.raster import Array32, Indices

FLOOR = np.array(from_srgb("#d3d7dc"), np.float32)
SKY = np.array(from_srgb("#eef1f5"), np.float32)
GRID_M = 0.5
LINE_M = 0.006
LINE_LIGHT = 0.80  # what a grid line leaves of the light
SHADOW_LIGHT = 0.50
FADE_M = (3.0, 9.0)  # the floor fades into the sky between these distances from its middle


class Ground(NamedTuple):
    """Floor and sky as pixels see them."""

    light: Array32  # (3, n) linear
    along: Array32  # (2, n) the place on the floor, in the frame of the sun [m]


def ground(
    camera: Camera,
    size: tuple[int, int],
    height_m: float,
    pixels: Indices,
    shadows: Sequence[ShadowMap],
) -> Ground:
    """Return floor and sky.

    Args:
        camera: The eye.
        size: Width and height, pixels.
        height_m: Of the floor, z in W [m].
        pixels: Row by row, shape (n,).
        shadows: Of everything that throws one.
    """
    width, height = size
    focal = focal_length(camera, height)
    right, down, forward = (axis.astype(np.float32) for axis in camera.axes())
    row, column = np.divmod(pixels, width)
    x = ((column + (0.5 - width / 2)) / focal).astype(np.float32)
    y = ((row + (0.5 - height / 2)) / focal).astype(np.float32)
    falling = down[2] * y + right[2] * x + forward[2]
    reach = np.float32(height_m - camera.eye[2]) / np.minimum(falling, np.float32(-1e-4))
    on = [
        np.float32(camera.eye[axis]) + reach * (right[axis] * x + down[axis] * y + forward[axis])
        for axis in (0, 1)
    ]
    light = np.ones(len(pixels), np.float32)
    pixel_m = reach / np.float32(focal) / np.maximum(-falling, np.float32(0.05))
    for place in on:
        lines = place / np.float32(GRID_M)
        to_line = np.abs(lines - np.rint(lines)) * np.float32(GRID_M)
        cover = np.clip((LINE_M / 2 + pixel_m / 2 - to_line) / np.maximum(pixel_m, LINE_M), 0, 1)
        light *= 1 - np.float32(1 - LINE_LIGHT) * cover
    away = np.hypot(on[0], on[1])
    near = np.clip((FADE_M[1] - away) / (FADE_M[1] - FADE_M[0]), 0, 1)
    near = np.where(falling < 0, near * near * (3 - 2 * near), 0).astype(np.float32)
    frame = SUN_FRAME.astype(np.float32)
    along = np.stack(
        [
            frame[axis, 0] * on[0] + frame[axis, 1] * on[1] + frame[axis, 2] * np.float32(height_m)
            for axis in (0, 1)
        ]
    )
    deep = np.zeros(len(pixels), np.float32)
    for one in shadows:
        np.maximum(deep, one.shadow(along), out=deep)
    light *= near
    light *= 1 + deep * np.float32(SHADOW_LIGHT - 1)
    seen: Array32 = FLOOR[:, None] * light
    seen += SKY[:, None] * (1 - near)
    return Ground(seen, along)
