"""Light on the triangles that a picture shows: one sun with shadows, the sky, a gleam."""

from collections.abc import Sequence
from typing import NamedTuple, TypeAlias

import numpy as np
import numpy.typing as npt

from vrts.report.picture.camera import axes
from vrts.report.picture.raster import (
    NOTHING,
    Array,
    Array32,
    Mask,
    Numbers,
    nearness,
    rasterise,
    signed_area,
)

Pixels: TypeAlias = npt.NDArray[np.uint8]

SUN = np.array([0.42, -0.52, 0.86]) / np.linalg.norm([0.42, -0.52, 0.86])  # towards the sun, in W
SUN_FRAME = axes(-SUN)  # rows: right, down, away from the sun, in W
SUN_LIGHT = 0.86
SKY_LIGHT = 0.46  # on what looks up
GROUND_LIGHT = 0.20  # on what looks down
GLEAM = 0.16
GLOSS_SQUARINGS = 5  # of the cosine: to the 32nd power
ROOM_M = 0.02  # round what throws shadows
BIAS = 0.006  # [m] a surface does not shade itself
TAPS = ((-1, 0), (0, -1), (1, 0), (0, 1))  # texels round the one of a point: a softer edge
SOFT_TEXELS = 4  # side of a texel of the soft shadow, in texels
SOFT_M = 0.028  # radius of its blur, done three times
BAND = 192  # rows of a map that are drawn together


class ShadowMap(NamedTuple):
    """How near to the sun the nearest surface is, seen along the light."""

    origin: Array32  # (2,) of the map on right and down of the sun's frame [m]
    texels_m: float  # texels in a metre
    nearness: Array32  # (rows, columns), towards the sun [m]; -inf where nothing is
    soft: Array32  # how much is covered, blurred; a texel of it is SOFT_TEXELS wide

    def lit(self, along: Array32) -> Array32:
        """Return the share of the sun that reaches points in its frame, shape (3, ...)."""
        rows, columns = self.nearness.shape
        index = self._texel(along[1], self.origin[1], rows) * np.int32(columns)
        index += self._texel(along[0], self.origin[0], columns)
        own = np.float32(BIAS) - along[2]
        flat = self.nearness.reshape(-1)
        light = np.zeros(index.shape, np.uint8)
        for right, down in TAPS:
            light += flat.take(index + np.int32(down * columns + right)) <= own
        return light * np.float32(1 / len(TAPS))

    def _texel(self, along: Array32, origin: Array32, count: int) -> Numbers:
        at: Array32 = (along - origin) * np.float32(self.texels_m)
        np.clip(at, 1, count - 2, out=at)
        return at.astype(np.int32)

    def covers(self, along: Array32) -> Mask:
        """Return which points in its frame can lie in its shadow, shape of one row of `along`."""
        rows, columns = self.nearness.shape
        x, y = along[0] - self.origin[0], along[1] - self.origin[1]
        inside = (x > 0) & (x < np.float32(columns / self.texels_m))
        return inside & (y > 0) & (y < np.float32(rows / self.texels_m))

    def shadow(self, along: Array32) -> Array32:
        """Return how deep in a soft shadow points lie, shape (2, ...), from 0 to 1."""
        rows, columns = self.soft.shape
        scale = np.float32(self.texels_m / SOFT_TEXELS)
        x: Array32 = (along[0] - self.origin[0]) * scale - np.float32(0.5)
        y: Array32 = (along[1] - self.origin[1]) * scale - np.float32(0.5)
        np.clip(x, 0, columns - 1.01, out=x)
        np.clip(y, 0, rows - 1.01, out=y)
        column, row = x.astype(np.int32), y.astype(np.int32)
        x -= column
        y -= row
        index = row * np.int32(columns) + column
        flat = self.soft.reshape(-1)
        upper = flat.take(index) * (1 - x) + flat.take(index + 1) * x
        index += np.int32(columns)
        lower = flat.take(index) * (1 - x) + flat.take(index + 1) * x
        return (upper * (1 - y) + lower * y).astype(np.float32)


def shadow_map(corners: Array, side: int) -> ShadowMap:
    """Return the shadow map of triangles in W, shape (m, 3, 3), m.

    Args:
        corners: Of the triangles; none throw no shadow.
        side: The longer side of the map, texels.
    """
    if not len(corners):
        nothing = np.full((4, 4), -np.inf, np.float32)
        return ShadowMap(np.zeros(2, np.float32), 1.0, nothing, np.zeros((2, 2), np.float32))
    turned = corners @ SUN_FRAME.T
    # room for the blur, and for what is looked up beside
    room = ROOM_M + 4 * SOFT_M
    low = turned[:, :, :2].reshape(-1, 2).min(0) - room
    extent = turned[:, :, :2].reshape(-1, 2).max(0) + room - low
    texels = side / float(extent.max())
    columns, rows = (int(x) // SOFT_TEXELS * SOFT_TEXELS for x in extent * texels)
    screen = (turned[:, :, :2] - low) * texels
    facing = signed_area(screen) < -1e-9
    farthest = float(turned[:, :, 2].max()) + 1.0
    screen, before = screen[facing], farthest - turned[facing][:, :, 2]
    near = np.empty((rows, columns), np.float32)
    covered = np.empty((rows, columns), np.bool_)
    for top in range(0, rows, BAND):  # what is worked on stays near the processor
        now = slice(top, top + BAND)
        seen = rasterise(screen, before, columns, len(near[now]), top=top)
        covered[now] = seen != NOTHING
        near[now] = np.where(covered[now], nearness(seen) - np.float32(farthest), -np.inf)
    blocks = covered.reshape(rows // SOFT_TEXELS, SOFT_TEXELS, columns // SOFT_TEXELS, SOFT_TEXELS)
    soft = blocks.sum(axis=(1, 3), dtype=np.uint8) * np.float32(1 / SOFT_TEXELS**2)
    radius = max(round(SOFT_M * texels / SOFT_TEXELS), 1)
    for _ in range(3):
        soft = _blurred(_blurred(soft, radius).T, radius).T
    soft = np.ascontiguousarray(soft)
    return ShadowMap(low.astype(np.float32), texels, near.astype(np.float32), soft)


def sunlight(maps: Sequence[ShadowMap], along: Array32) -> Array32:
    """Return the share of the sun that all shadows leave to points in its frame, (3, n)."""
    light = np.ones(along.shape[1:], np.float32)
    for shadows in maps:
        light *= shadows.lit(along)
    return light


def shade(color: Array32, normal: Array32, view: Array32, arriving: Array32) -> Array32:
    """Return the linear light that surfaces send to the eye, shape (3, n).

    Args:
        color: Of the surface, linear RGB, shape (3, n).
        normal: Unit, in the frame of the sun, shape (3, n).
        view: Unit, towards the eye, in the frame of the sun, shape (3, n).
        arriving: Share of the sun that arrives, shape (n,).
    """
    up = SUN_FRAME[:, 2].astype(np.float32)
    slope = -normal[2]
    light = up @ normal
    light *= np.float32(0.5 * (SKY_LIGHT - GROUND_LIGHT))
    light += np.float32(0.5 * (SKY_LIGHT + GROUND_LIGHT))
    # head light: the silhouettes of round things darken, so that they look round
    head = np.einsum("ij,ij->j", normal, view)
    light *= np.float32(0.55) + np.float32(0.45) * np.abs(head)
    # of the direction between eye and sun
    gleam = head + slope
    gleam /= np.sqrt(np.maximum(2 - 2 * view[2], np.float32(1e-6)))
    np.maximum(gleam, 0, out=gleam)
    for _ in range(GLOSS_SQUARINGS):
        gleam *= gleam
    arriving = arriving * (slope > 0)
    gleam *= arriving * np.float32(GLEAM)
    light += slope * arriving * np.float32(SUN_LIGHT)
    shaded = color * light
    shaded += gleam
    return shaded


def _blurred(picture: Array32, radius: int) -> Array32:
    """Return the mean of 2 radius + 1 neighbours along the rows."""
    padded = np.pad(picture, ((0, 0), (radius + 1, radius)))
    total = np.cumsum(padded, axis=1, dtype=np.float64)
    width = 2 * radius + 1
    return ((total[:, width:] - total[:, :-width]) / width).astype(np.float32)


_STEPS = 4096
_linear = np.arange(_STEPS + 1) / _STEPS
_SRGB = np.where(
    _linear <= 0.0031308, 12.92 * _linear, 1.055 * np.maximum(_linear, 1e-9) ** (1 / 2.4) - 0.055
)
_BYTES = np.round(255 * _SRGB).astype(np.uint8)


def to_srgb(linear: Array32) -> Pixels:
    """Return linear light, where 1 is white, as sRGB bytes [IEC 61966-2-1]."""
    steps = linear * np.float32(_STEPS)
    np.clip(steps, 0, _STEPS, out=steps)
    return _BYTES.take(steps.astype(np.int32))


def from_srgb(code: str) -> tuple[float, float, float]:
    """Return `#rrggbb` as linear light."""
    values = [int(code[at : at + 2], 16) / 255 for at in (1, 3, 5)]
    r, g, b = (v / 12.92 if v <= 0.04045 else ((v + 0.055) / 1.055) ** 2.4 for v in values)
    return (r, g, b)
