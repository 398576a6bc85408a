"""Light on the triangles that a picture shows: one sun with shadows, the sky, a gleam."""

from typing import NamedTuple, TypeAlias

import numpy as np
import numpy.typing as npt

from vrts.report.camera import axes
from vrts.report.raster import Array, Array32, rasterise, signed_area

Pixels: TypeAlias = npt.NDArray[np.uint8]

SUN = np.array([0.42, -0.52, 0.86]) / np.linalg.norm([0.42, -0.52, 0.86])  # towards the sun, in W
SUN_LIGHT = 0.86
SKY_LIGHT = 0.46  # on what looks up
GROUND_LIGHT = 0.20  # on what looks down
GLEAM = 0.16
GLOSS = 24.0
MAP = 1024  # side of the shadow map, texels
BIAS = 0.006  # [m] a surface does not shade itself


class ShadowMap(NamedTuple):
    """How near to the sun the nearest surface is, seen along the light."""

    frame: Array  # (3, 3) rows: right, down, away from the sun, in W
    origin: Array  # (2,) of the map on right and down [m]
    texels_m: float  # texels in a metre
    nearness: Array32  # (MAP, MAP), towards the sun [m]; -inf where nothing is

    def lit(self, points: Array32) -> Array32:
        """Return the share of the sun that reaches points, shape (n, 3) in W, softened."""
        turned = points @ self.frame.T.astype(np.float32)
        at = (turned[:, :2] - self.origin.astype(np.float32)) * np.float32(self.texels_m)
        own = np.float32(BIAS) - turned[:, 2]
        light = np.zeros(len(points), np.float32)
        for x, y in ((-1.5, -0.5), (0.5, -1.5), (1.5, 0.5), (-0.5, 1.5)):
            column = (at[:, 0] + x).astype(np.int32).clip(0, MAP - 1)
            row = (at[:, 1] + y).astype(np.int32).clip(0, MAP - 1)
            light += self.nearness[row, column] <= own
        return light * np.float32(0.25)


def shadow_map(corners: Array) -> ShadowMap:
    """Return the shadow map of triangles in W, shape (m, 3, 3), m."""
    frame = axes(-SUN)
    turned = corners @ frame.T
    low = turned[:, :, :2].reshape(-1, 2).min(0) - 0.02
    high = turned[:, :, :2].reshape(-1, 2).max(0) + 0.02
    texels = MAP / float((high - low).max())
    screen = (turned[:, :, :2] - low) * texels
    facing = signed_area(screen) < -1e-9
    farthest = float(turned[:, :, 2].max()) + 1.0
    seen = rasterise(screen[facing], farthest - turned[facing][:, :, 2], MAP, MAP)
    nearness = np.full(MAP * MAP, -np.inf, np.float32)
    nearness[seen.pixel] = seen.nearness - np.float32(farthest)
    return ShadowMap(frame, low, texels, nearness.reshape(MAP, MAP))


def shade(
    color: Array32, normals: Array32, points: Array32, eye: Array, sunlight: Array32
) -> Array32:
    """Return the linear light that surfaces send to the eye.

    Args:
        color: Of the surface, linear RGB, shape (n, 3).
        normals: Unit, in W, shape (n, 3).
        points: In W, shape (n, 3), m.
        eye: In W, shape (3,), m.
        sunlight: Share of the sun that arrives, shape (n,).
    """
    sun = SUN.astype(np.float32)
    slope = normals @ sun
    direct = np.maximum(slope, 0) * sunlight * np.float32(SUN_LIGHT)
    up = normals[:, 2] * np.float32(0.5) + np.float32(0.5)
    sky = np.float32(GROUND_LIGHT) + up * np.float32(SKY_LIGHT - GROUND_LIGHT)
    view = eye.astype(np.float32) - points
    view /= np.sqrt(np.einsum("ij,ij->i", view, view))[:, None]
    # head light: the silhouettes of round things darken, so that they look round
    head = np.abs(np.einsum("ij,ij->i", normals, view))
    half = view + sun
    half /= np.sqrt(np.einsum("ij,ij->i", half, half))[:, None]
    gleam = np.maximum(np.einsum("ij,ij->i", normals, half), 0) ** np.float32(GLOSS)
    gleam *= sunlight * np.float32(GLEAM) * (slope > 0)
    light = direct + sky * (np.float32(0.55) + np.float32(0.45) * head)
    return color * light[:, None] + gleam[:, None]


_STEPS = 4096
_linear = np.arange(_STEPS + 1) / _STEPS
_SRGB = np.where(
    _linear <= 0.0031308, 12.92 * _linear, 1.055 * np.maximum(_linear, 1e-9) ** (1 / 2.4) - 0.055
)
_BYTES = np.round(255 * _SRGB).astype(np.uint8)


def to_srgb(linear: Array32) -> Pixels:
    """Return linear light, where 1 is white, as sRGB bytes [IEC 61966-2-1]."""
    return _BYTES[(np.clip(linear, 0, 1) * np.float32(_STEPS)).astype(np.int32)]


def from_srgb(code: str) -> tuple[float, float, float]:
    """Return `#rrggbb` as linear light."""
    values = [int(code[at : at + 2], 16) / 255 for at in (1, 3, 5)]
    r, g, b = (v / 12.92 if v <= 0.04045 else ((v + 0.055) / 1.055) ** 2.4 for v in values)
    return (r, g, b)
