"""The floor under a picture: endless, with a grid of half metres and soft shadows."""

from typing import NamedTuple

import numpy as np

from vrts.report.camera import Camera
from vrts.report.lighting import SUN_FRAME, ShadowMap, from_srgb
from vrts.report.projection import focal_length
from vrts.report.raster import Array32

FLOOR = np.array(from_srgb("#d3d7dc"), np.float32)
SKY = np.array(from_srgb("#eef1f5"), np.float32)
GRID_M = 0.5
LINE_M = 0.006
LINE_LIGHT = 0.80  # what a grid line leaves of the light
SHADOW_LIGHT = 0.50
FADE_M = (3.0, 9.0)  # the floor fades into the sky between these distances from its middle


class Ground(NamedTuple):
    """Floor and sky as one camera sees them, without what moves."""

    fading: Array32  # (height, width, 3) light where the floor is dark: what fades into the sky
    floor: Array32  # (height, width, 3) light of the floor without shadows, on top of that
    along: Array32  # (2, height, width) the place on the floor, in the frame of the sun [m]
    shadow: Array32  # (height, width) of what never moves, 0..1

    def seen(self, rows: slice, moving: ShadowMap) -> Array32:
        """Return the light of some rows, linear, with the shadows of what moves too."""
        deep = np.maximum(self.shadow[rows], moving.shadow(self.along[:, rows]))
        deep *= np.float32(SHADOW_LIGHT - 1)
        deep += 1
        light: Array32 = self.floor[rows] * deep[:, :, None]
        light += self.fading[rows]
        return light


def ground(camera: Camera, size: tuple[int, int], height_m: float, fixed: ShadowMap) -> Ground:
    """Return floor and sky.

    Args:
        camera: The eye.
        size: Width and height, pixels.
        height_m: Of the floor, z in W [m].
        fixed: Shadows of what never moves.
    """
    width, height = size
    focal = focal_length(camera, height)
    right, down, forward = (axis.astype(np.float32) for axis in camera.axes())
    x = ((np.arange(width) + 0.5 - width / 2) / focal).astype(np.float32)
    y = ((np.arange(height) + 0.5 - height / 2) / focal).astype(np.float32)
    falling = down[2] * y[:, None] + right[2] * x[None, :] + forward[2]
    reach = np.float32(height_m - camera.eye[2]) / np.minimum(falling, np.float32(-1e-4))
    on = [
        np.float32(camera.eye[axis])
        + reach * (right[axis] * x[None, :] + down[axis] * y[:, None] + forward[axis])
        for axis in (0, 1)
    ]
    light = np.ones((height, width), np.float32)
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
    ).astype(np.float32)
    light *= near
    fading, floor = SKY * (1 - near)[:, :, None], FLOOR * light[:, :, None]
    return Ground(fading, floor, along, fixed.shadow(along))
