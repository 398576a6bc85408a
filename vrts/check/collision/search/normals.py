"""How far two solids can approach each other along a normal: from speed and acceleration.

|v.n| h + |n x w| r h + a h^2 / 2, with the velocities v and w of the outer solid's centre as seen
from the inner solid at the middle, its radius r, half the interval h, and a bound a on the
acceleration of any of its points.
"""

from typing import NamedTuple, TypeAlias

import numpy as np
import numpy.typing as npt

from vrts.check.collision.search.nodes import Level
from vrts.check.curves.timeline_arrays import Curves
from vrts.engine.memory.records import GRAVITY
from vrts.geometry.solids import JOINTS, Solids

Array: TypeAlias = npt.NDArray[np.float64]
Indices: TypeAlias = npt.NDArray[np.int64]


class Rows(NamedTuple):
    """Pairs of solids in nodes; all of shape (r,)."""

    node: Indices
    outer: Indices  # solid
    inner: Indices  # solid
    base: Indices  # frame of the inner solid


class Normals(NamedTuple):
    """The directions in which the pairs are separated at the middle of their nodes."""

    normal: Array  # (r, 3), unit
    at: Indices  # (r,) place of the outer solid
    arms: Array  # (6, m) [m] largest distance of each place from each joint's axis
    centre: Array  # (r, 3) [m] of the outer solid


def approach(
    curves: Curves, solids: Solids, level: Level, rows: Rows, normals: Normals, *, falls: bool
) -> Array:
    """Return the bound on the approach of each pair within its node, shape (r,), in m."""
    frames = level.state.frames
    node, outer, inner, base = rows
    normal, at, arms, centre = normals
    velocity = curves.velocities(level.middle[node])
    speed, acceleration = level.spread.speed[node], level.spread.acceleration[node]
    h = level.half[node]
    # all joints at once, shape (6, r): those that move one solid against the other
    between = base < np.arange(1, JOINTS + 1)[:, None]
    far = arms[:, at]
    arm = np.where(between, far, 0.0)
    axis = frames.rotations[1:, :, :, 2][:, node]
    offset = centre - frames.origins[1:][:, node]
    rate = np.where(between & (far > 0.0), velocity[:, :JOINTS].T, 0.0)
    turned = axis * rate[:, :, None]
    w = turned.sum(axis=0)
    v = _cross(turned, offset).sum(axis=0)
    top = np.where(between, speed[:, :JOINTS].T, 0.0)
    summed = np.cumsum(np.where(arm > 0.0, top, 0.0), axis=0)
    faster = summed[-1]  # sum of all joint speeds
    before = np.zeros_like(top)  # and of those further in
    before[1:] = summed[:-1]
    # bound on the acceleration of any point:
    # |d2x/dq_i dq_j| is at most the distance from the outer of the two axes
    curve = (arm * (acceleration[:, :JOINTS].T + top * (2.0 * before + top))).sum(axis=0)
    slides = solids.slides[outer]
    turned = (frames.rotations[6][node] @ solids.slide[outer][:, :, None])[:, :, 0]
    v += turned * velocity[:, 6, None]
    curve += slides * (acceleration[:, 6] + 2.0 * faster * speed[:, 6])
    if falls:
        for solid, sign in ((outer, 1.0), (inner, -1.0)):
            falling = solids.falls[solid]
            since = np.maximum(level.middle[node] - solids.falls_from[solid], 0.0)
            v[:, 2] -= sign * np.where(falling, GRAVITY * since, 0.0)
            curve += np.where(falling, GRAVITY, 0.0)
    along = np.abs(np.einsum("ri,ri->r", v, normal))
    turning = np.linalg.norm(_cross(normal, w), axis=1) * solids.ball[outer]
    return (along + turning) * h + 0.5 * curve * h * h


def _cross(a: Array, b: Array) -> Array:
    """Return vector products, shape (..., 3); much faster than numpy's for few vectors."""
    x, y, z = a[..., 0], a[..., 1], a[..., 2]
    u, v, w = b[..., 0], b[..., 1], b[..., 2]
    found = np.empty_like(a)
    found[..., 0] = y * w - z * v
    found[..., 1] = z * u - x * w
    found[..., 2] = x * v - y * u
    return found
