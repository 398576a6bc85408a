"""Triangles as a camera sees them: on its screen, without what lies behind it or looks away."""

import math
from typing import NamedTuple

import numpy as np

from vrts.report.picture.camera import Camera
from vrts.report.picture.lighting import SUN_FRAME
from vrts.report.picture.placing import Placed
from vrts.report.picture.raster import Array, Array32, Indices, Numbers, plane, signed_area

NEAR = 0.02  # [m] nothing nearer to the eye is drawn
NO_SOLID = -1  # of the triangle NOTHING


class Projected(NamedTuple):
    """Triangles on a screen."""

    screen: Array  # (m, 3, 2) column and row of each corner, pixels
    near: Array  # (m, 3) 1/depth of each corner [1/m]
    planes: Array32  # (4, 3, 1 + m): normal in the sun's frame and 1/depth; of column, row, 1
    solid: Numbers  # (1 + m,), by number; NO_SOLID for NOTHING


def project(placed: Placed, camera: Camera, width: int, height: int) -> Projected:
    """Return the triangles on a screen of a width and height in pixels."""
    focal = focal_length(camera, height)
    local = (placed.corners - np.array(camera.eye)) @ camera.axes().T
    local, normals, solid = _clipped(local, placed.normals, placed.solid)
    depth = local[:, :, 2]
    screen = local[:, :, :2] / depth[:, :, None] * focal + (width / 2, height / 2)
    shown = signed_area(screen) < -1e-9
    for along, end in enumerate((width, height)):
        a, b, c = (screen[:, k, along] for k in range(3))
        shown &= (np.maximum(np.maximum(a, b), c) > 0) & (np.minimum(np.minimum(a, b), c) < end)
    screen, depth, normals, solid = screen[shown], depth[shown], normals[shown], solid[shown]
    near = 1 / depth
    turned = normals @ SUN_FRAME.T
    planes = np.zeros((4, 3, 1 + len(screen)), np.float32)
    for k, value in enumerate([*(turned[:, :, k] * near for k in range(3)), near]):
        planes[k, :, 1:] = plane(screen, value).T
    return Projected(screen, near, planes, np.append(NO_SOLID, solid).astype(np.int32))


def focal_length(camera: Camera, height: int) -> float:
    """Return the distance of a screen from the eye, in its pixels."""
    return height / 2 / math.tan(camera.field_of_view / 2)


def joined(one: Projected, other: Projected, solids: int) -> Projected:
    """Return both, numbered through; the first has a number of solids."""
    return Projected(
        np.concatenate([one.screen, other.screen]),
        np.concatenate([one.near, other.near]),
        np.concatenate([one.planes, other.planes[:, :, 1:]], axis=2),
        np.concatenate([one.solid, other.solid[1:] + solids]),
    )


def _clipped(corners: Array, normals: Array, solid: Indices) -> tuple[Array, Array, Indices]:
    """Return triangles with what lies behind the near plane cut off; depth is the third column."""
    behind = corners[:, :, 2] < NEAR
    count = behind.sum(1)
    if not count.any():
        return corners, normals, solid
    parts = [(corners[count == 0], normals[count == 0], solid[count == 0])]
    for number in (1, 2):
        for odd in range(3):  # the corner that is alone on its side
            chosen = (count == number) & (behind[:, odd] == (number == 1))
            if not chosen.any():
                continue
            turn = [odd, (odd + 1) % 3, (odd + 2) % 3]
            p, n, s = corners[chosen][:, turn], normals[chosen][:, turn], solid[chosen]
            share = (NEAR - p[:, :1, 2]) / (p[:, 1:, 2] - p[:, :1, 2])
            cut_p = p[:, :1] + share[:, :, None] * (p[:, 1:] - p[:, :1])
            cut_n = n[:, :1] + share[:, :, None] * (n[:, 1:] - n[:, :1])
            if number == 2:
                parts.append((_fan(p[:, 0], *_pair(cut_p)), _fan(n[:, 0], *_pair(cut_n)), s))
            else:
                b, c = _pair(cut_p)
                nb, nc = _pair(cut_n)
                parts.append((_fan(b, p[:, 1], p[:, 2]), _fan(nb, n[:, 1], n[:, 2]), s))
                parts.append((_fan(b, p[:, 2], c), _fan(nb, n[:, 2], nc), s))
    return (
        np.concatenate([part[0] for part in parts]),
        np.concatenate([part[1] for part in parts]),
        np.concatenate([part[2] for part in parts]),
    )


def _pair(ends: Array) -> tuple[Array, Array]:
    return ends[:, 0], ends[:, 1]


def _fan(a: Array, b: Array, c: Array) -> Array:
    return np.stack([a, b, c], axis=1)
