"""Convex pieces on the moving frames of an arm, as arrays: where they are and how far they can get.

Frames L_0 .. L_6 follow the joints; the z axis of L_k is the axis of joint k. Solids hang on one of
them, fingers slide along a direction of L_6 as well, falling bodies sink in L_0. For a solid on L_k
and another on L_l, l < k, only the joints l + 1 .. k move one against the other; and joint k does
not, where it turns a cylinder round its own axis.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import NamedTuple, TypeAlias

import numpy as np
import numpy.typing as npt

from vrts.base.pose import Pose, Vector
from vrts.geometry.shapes import Box, Cylinder, Hull, Shape

Array: TypeAlias = npt.NDArray[np.float64]
Indices: TypeAlias = npt.NDArray[np.int64]

JOINTS = 6
COAXIAL = 1e-7  # [m, 1] between the axes of a cylinder and of its joint: rounding allows for more


class Solid(NamedTuple):
    """One convex piece, the frame it hangs on, and what else moves it."""

    shape: Shape
    frame: int  # k of L_k
    X_LP: Pose  # at hand opening 0, or when the fall begins
    part: str  # what reports call it: "left finger", "can1"
    slide: Vector = (0.0, 0.0, 0.0)  # displacement in L per metre of hand opening
    falls_from_s: float | None = None  # time at which it begins to fall freely


class Frames(NamedTuple):
    """Where the frames of the arm are at n instants."""

    rotations: Array  # (7, n, 3, 3) of L_k in W
    origins: Array  # (7, n, 3) [m]


class Instants(NamedTuple):
    """The state of everything that moves, at n instants."""

    time_s: Array  # (n,)
    opening: Array  # (n,) of the hand [m]
    frames: Frames


class Places(NamedTuple):
    """Where m solids are, each at one instant."""

    rotations: Array  # (m, 3, 3) of the piece in W
    origins: Array  # (m, 3) [m]
    centres: Array  # (m, 3) of the box round it, in W [m]
    halves: Array  # (m, 3) half extents of that box along the axes of W [m]


class Motion(NamedTuple):
    """What moves in n intervals of time round an instant; sizes, not signs."""

    half_s: Array  # (n,) half length [s]
    turn: Array  # (n, 6) largest |q(t) - q(middle)| [rad]
    slide: Array  # (n,) largest change of the hand opening [m]


class Rates(NamedTuple):
    """Velocities at n instants, and bounds on the rates within intervals round them."""

    velocity: Array  # (n, 7) at the middle [rad/s], [m/s]
    speed: Array  # (n, 7) largest size
    acceleration: Array  # (n, 7) largest size


@dataclass(frozen=True, slots=True)
class Solids:
    """Many solids."""

    shapes: tuple[Shape, ...]
    parts: tuple[str, ...]
    frame: Indices  # (g,)
    rotation: Array  # (g, 3, 3) of P in L
    origin: Array  # (g, 3) of P in L [m]
    slide: Array  # (g, 3) [m/m]
    slides: Array  # (g,) length of that
    falls: npt.NDArray[np.bool_]  # (g,)
    falls_from: Array  # (g,) [s]; 0 where it does not fall
    middle: Array  # (g, 3) of the box round the shape, in P [m]
    half: Array  # (g, 3) of that box; of a cylinder's axis only [m]
    radius: Array  # (g,) of a cylinder; 0 for others [m]
    ball: Array  # (g,) radius of the ball round `middle` that holds the shape [m]
    corners: Array  # (hulls, n, 3) points of the hulls, the last repeated to fill up [m]
    hull: Indices  # (g,) index into `corners`; -1 for others
    spins: npt.NDArray[np.bool_]  # (g,) whether its own joint turns it round its own axis only

    def places(
        self, instants: Instants, solid: Indices, instant: Indices, gravity: float
    ) -> Places:
        """Return where solids are, each at one instant; both index arrays have shape (m,)."""
        frame = self.frame[solid]
        turned = instants.frames.rotations[frame, instant]
        rotations = turned @ self.rotation[solid]
        local = self.origin[solid] + self.slide[solid] * instants.opening[instant, None]
        origins = instants.frames.origins[frame, instant] + (turned @ local[:, :, None])[:, :, 0]
        falling = self.falls[solid]
        if falling.any():
            since = instants.time_s[instant[falling]] - self.falls_from[solid[falling]]
            origins[falling, 2] -= 0.5 * gravity * np.maximum(since, 0.0) ** 2
        centres = origins + (rotations @ self.middle[solid][:, :, None])[:, :, 0]
        halves = (np.abs(rotations) @ self.half[solid][:, :, None])[:, :, 0]
        across = np.sqrt(np.maximum(0.0, 1.0 - rotations[:, :, 2] ** 2))
        halves += self.radius[solid, None] * across
        return Places(rotations, origins, centres, halves)

    def travel(
        self, instants: Instants, motion: Motion, solid: Indices, instant: Indices, centres: Array
    ) -> tuple[Array, Array]:
        """Return how far any point of solids can get from where it is at the middle of an interval.

        The bound over joints l + 1 .. k adds, from the hand inwards, the turn of each joint times
        the largest distance from its axis that a point of the solid can have: that of the centre,
        plus the radius of the ball, plus what the joints further out have added. What spins is
        where it was: its own joint adds nothing.

        Args:
            instants: The middles.
            motion: What happens round them.
            solid: Indices of solids, shape (m,).
            instant: Indices of instants, shape (m,).
            centres: Of the boxes round the solids, shape (m, 3), in W.

        Returns:
            Bound against each frame L_l, shape (7, m), in m; largest distance from the axis of
            each joint, shape (6, m), in m; 0 for joints that do not move it.
        """
        count = len(solid)
        bound = np.zeros((JOINTS + 1, count))
        arms = np.zeros((JOINTS, count))
        moved = motion.slide[instant] * self.slides[solid]
        frame = self.frame[solid]
        ball = self.ball[solid]
        turn = motion.turn[instant]
        bound[JOINTS] = moved
        axis = instants.frames.rotations[1:, :, :, 2][:, instant]
        offset = centres - instants.frames.origins[1:][:, instant]
        along = np.einsum("jmi,jmi->jm", offset, axis)
        square = np.einsum("jmi,jmi->jm", offset, offset) - along * along
        away = np.sqrt(np.maximum(square, 0.0)) + ball
        idle = frame - self.spins[solid] < np.arange(1, JOINTS + 1)[:, None]
        for joint in range(JOINTS, 0, -1):
            arm = away[joint - 1] + moved
            arm[idle[joint - 1]] = 0.0
            arms[joint - 1] = arm
            moved = moved + arm * turn[:, joint - 1]
            bound[joint - 1] = moved
        return bound, arms

    def reach(self, solid: Indices, rotations: Array, direction: Array) -> Array:
        """Return how far solids reach from their origins along unit vectors of W, (m,), in m.

        Args:
            solid: Indices of solids, shape (m,).
            rotations: Of the pieces in W, shape (m, 3, 3).
            direction: Shape (m, 3).
        """
        local = (direction[:, None, :] @ rotations)[:, 0, :]
        reach = np.einsum("mi,mi->m", np.abs(local), self.half[solid])
        reach += self.radius[solid] * np.hypot(local[:, 0], local[:, 1])
        hull = self.hull[solid]
        which = np.nonzero(hull >= 0)[0]
        if len(which):
            corners = self.corners[hull[which]]
            reach[which] = (corners @ local[which][:, :, None])[:, :, 0].max(axis=1)
        return reach

    def drop(self, motion: Motion, since: Array, solid: Indices, gravity: float) -> Array:
        """Return how far falling solids get from where they are at the middle, (m,), in m.

        Args:
            motion: Half lengths of the intervals, one for each of the solids.
            since: Time from the start of the fall to the middle, shape (m,), in s.
            solid: Indices of solids, shape (m,).
            gravity: In m/s^2.
        """
        later = np.maximum(since, 0.0) + 0.5 * motion.half_s
        return np.where(self.falls[solid], gravity * motion.half_s * later, 0.0)


def solids(members: Sequence[Solid]) -> Solids:
    """Return the arrays of solids."""
    middles: list[Vector] = []
    halves: list[Vector] = []
    radii: list[float] = []
    balls: list[float] = []
    for member in members:
        middle, half, radius, ball = _round(member.shape)
        middles.append(middle)
        halves.append(half)
        radii.append(radius)
        balls.append(ball)
    hulls = [member.shape.points for member in members if isinstance(member.shape, Hull)]
    most = max(map(len, hulls), default=1)
    corners = [points + points[-1:] * (most - len(points)) for points in hulls]
    is_hull = np.array([isinstance(member.shape, Hull) for member in members], dtype=np.bool_)
    slide = np.array([member.slide for member in members]).reshape(-1, 3)
    return Solids(
        shapes=tuple(member.shape for member in members),
        parts=tuple(member.part for member in members),
        frame=np.array([member.frame for member in members], dtype=np.int64),
        rotation=np.array([m.X_LP.rotation for m in members]).reshape(-1, 3, 3),
        origin=np.array([m.X_LP.translation for m in members], dtype=np.float64).reshape(-1, 3),
        slide=slide,
        slides=np.linalg.norm(slide, axis=1),
        falls=np.array([member.falls_from_s is not None for member in members], dtype=np.bool_),
        falls_from=np.array([member.falls_from_s or 0.0 for member in members]),
        middle=np.array(middles).reshape(-1, 3),
        half=np.array(halves).reshape(-1, 3),
        radius=np.array(radii),
        ball=np.array(balls),
        corners=np.array(corners).reshape(-1, most, 3),
        hull=np.where(is_hull, np.cumsum(is_hull) - 1, -1),
        spins=np.array([_spins(member) for member in members], dtype=np.bool_),
    )


def _spins(solid: Solid) -> bool:
    """Return whether a solid is a cylinder round the z axis of its frame, that of its joint."""
    x, y, _ = solid.X_LP.translation
    tilt = math.hypot(solid.X_LP.rotation[2], solid.X_LP.rotation[5])
    round_ = isinstance(solid.shape, Cylinder) and max(math.hypot(x, y), tilt) < COAXIAL
    return round_ and solid.frame > 0 and not any(solid.slide)


@lru_cache(maxsize=4096)
def _round(shape: Shape) -> tuple[Vector, Vector, float, float]:
    """Return middle and half extents of the box, cylinder radius and ball radius of a shape."""
    match shape:
        case Box(half_extents=half):
            return (0.0, 0.0, 0.0), half, 0.0, float(np.linalg.norm(half))
        case Cylinder(radius=radius, half_length=half_length):
            ball = float(np.hypot(radius, half_length))
            return (0.0, 0.0, 0.0), (0.0, 0.0, half_length), radius, ball
        case Hull(points=points):
            corners = np.array(points)
            low, high = corners.min(axis=0), corners.max(axis=0)
            middle = 0.5 * (low + high)
            ball = float(np.linalg.norm(corners - middle, axis=1).max())
            return _vector(middle), _vector(0.5 * (high - low)), 0.0, ball


def _vector(values: Array) -> Vector:
    x, y, z = values.tolist()
    return (x, y, z)
