"""How far two solids can approach each other along a normal: from speed and acceleration.

|v.n| h + |n x w| r h + a h^2 / 2, with the velocities v and w of the outer solid's centre as seen
from the inner solid at the middle, its radius r, half the interval h, and a bound a on the
acceleration of any of its points.
"""

from dataclasses import dataclass
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


@dataclass(frozen=True, slots=True)
class Rates:
    """How fast the solids of rows move one against the other, whatever the direction."""

    velocity: Array  # (r, 3) of the outer solid's centre, at the middle [m/s]
    turning: Array  # (r, 3) angular velocity then [rad/s]
    ball: Array  # (r,) radius of the outer solid [m]
    curve: Array  # (r,) bound on the acceleration of any of its points [m/s^2]
    half: Array  # (r,) half of the interval [s]

    def approach(self, rows: Indices, normal: Array) -> Array:
        """Return how far some rows can come nearer along unit vectors, shape (m,), in m."""
        h = self.half[rows]
        along = np.abs(np.einsum("ri,ri->r", self.velocity[rows], normal))
        turn = cross(normal, self.turning[rows])
        along += np.sqrt(np.einsum("ri,ri->r", turn, turn)) * self.ball[rows]
        return (along + 0.5 * self.curve[rows] * h) * h


def rates(
    curves: Curves,
    solids: Solids,
    level: Level,
    rows: Rows,
    arms: Array,
    centre: Array,
    *,
    falls: bool,
) -> Rates:
    """Return how fast the pairs of rows move within their nodes.

    Args:
        curves: How the arm moves.
        solids: The convex pieces.
        level: The nodes.
        rows: Which pairs, in which nodes.
        arms: Largest distance of each outer solid from each joint's axis, shape (6, r), in m.
        centre: Of the outer solids, shape (r, 3), in m.
        falls: Whether anything falls.
    """
    frames = level.state.frames
    node, outer, inner, base = rows
    velocity = curves.velocities(level.middle)[node]
    speed, acceleration = level.spread.speed[node], level.spread.acceleration[node]
    # all joints at once, shape (6, r): those that move one solid against the other
    between = base < np.arange(1, JOINTS + 1)[:, None]
    arm = np.where(between, arms, 0.0)
    axis = frames.rotations[1:, :, :, 2][:, node]
    offset = centre - frames.origins[1:][:, node]
    rate = np.where(between & (arms > 0.0), velocity[:, :JOINTS].T, 0.0)
    turned = axis * rate[:, :, None]
    w = turned.sum(axis=0)
    v = cross(turned, offset).sum(axis=0)
    top = np.where(between, speed[:, :JOINTS].T, 0.0)
    summed = np.cumsum(np.where(arm > 0.0, top, 0.0), axis=0)
    faster = summed[-1]  # sum of all joint speeds
    before = np.zeros_like(top)  # and of those further in
    before[1:] = summed[:-1]
    # bound on the acceleration of any point:
    # |d2x/dq_i dq_j| is at most the distance from the outer of the two axes
    curve = (arm * (acceleration[:, :JOINTS].T + top * (2.0 * before + top))).sum(axis=0)
    slides = solids.slides[outer]
    if slides.any():
        turned = (frames.rotations[6][node] @ solids.slide[outer][:, :, None])[:, :, 0]
        v += turned * velocity[:, 6, None]
        curve += slides * (acceleration[:, 6] + 2.0 * faster * speed[:, 6])
    if falls:
        for solid, sign in ((outer, 1.0), (inner, -1.0)):
            falling = solids.falls[solid]
            since = np.maximum(level.middle[node] - solids.falls_from[solid], 0.0)
            v[:, 2] -= sign * np.where(falling, GRAVITY * since, 0.0)
            curve += np.where(falling, GRAVITY, 0.0)
    return Rates(v, w, solids.ball[outer], curve, level.half[node])


def cross(a: Array, b: Array) -> Array:
    """Return vector products, shape (..., 3); much faster than numpy's for few vectors."""
    x, y, z = a[..., 0], a[..., 1], a[..., 2]
    u, v, w = b[..., 0], b[..., 1], b[..., 2]
    found = np.empty_like(a)
    found[..., 0] = y * w - z * v
    found[..., 1] = z * u - x * w
    found[..., 2] = x * v - y * u
    return found
