"""Where pictures are taken from."""

import math
from functools import lru_cache
from typing import NamedTuple, TypeAlias

import numpy as np
import numpy.typing as npt

from vrts.base.pose import Vector

Array: TypeAlias = npt.NDArray[np.float64]

FIELD_OF_VIEW = math.radians(28.0)  # of the height of the picture: long enough to look natural
CLOSE = 0.95  # [m] from a contact: hand, object and its neighbours are in the picture
ELEVATIONS = tuple(math.radians(angle) for angle in (24.0, 38.0, 55.0))
AZIMUTHS = tuple(math.radians(angle) for angle in (-40, 40, -75, 75, -115, 115, 0, -150, 150, 180))
BESIDE = 0.1  # [m] what is nearer to the point than this does not count as hiding it


class Camera(NamedTuple):
    """A perspective camera that keeps the vertical upright."""

    eye: Vector  # in W [m]
    look_at: Vector  # in W [m]
    field_of_view: float = FIELD_OF_VIEW  # of the height [rad]

    def axes(self) -> Array:
        """Return rows right, down, forward: unit vectors in W, shape (3, 3)."""
        return _axes_of(self)


@lru_cache(maxsize=64)
def _axes_of(camera: Camera) -> Array:
    found = axes(np.subtract(camera.look_at, camera.eye))
    found.flags.writeable = False
    return found


def axes(forward: Array) -> Array:
    """Return rows right, down and the direction itself, for any direction but straight up."""
    forward = forward / np.linalg.norm(forward)
    right = np.cross(forward, (0.0, 0.0, 1.0))
    right /= np.linalg.norm(right)
    return np.stack([right, np.cross(forward, right), forward])


def fitting(points: Array, towards: Array, size: tuple[int, int], margin: float = 0.05) -> Camera:
    """Return the nearest camera that looks in a direction and has all points in the picture.

    Args:
        points: In W, shape (n, 3), m.
        towards: Direction of view in W, not vertical.
        size: Width and height of the picture, pixels.
        margin: Share of the picture that stays free on each side.
    """
    frame = axes(towards)
    local = points @ frame.T
    high = math.tan(FIELD_OF_VIEW / 2) * (1 - 2 * margin)
    wide = high * size[0] / size[1]
    column, depth_wide = _fit(local[:, 0], local[:, 2], wide)
    row, depth_high = _fit(local[:, 1], local[:, 2], high)
    eye = np.array([column, row, min(depth_wide, depth_high)]) @ frame
    ahead = eye + frame[2]
    return Camera(_vector(eye), _vector(ahead))


def close_up(point: Vector, corners: Array, front: float, distance: float = CLOSE) -> Camera:
    """Return a camera that sees a point from near, from where the fewest things hide it.

    Args:
        point: In W [m].
        corners: The triangles of everything, in W, shape (m, 3, 3), m.
        front: The preferred azimuth of the camera, as seen from the point, rad.
        distance: From the point [m].
    """
    target = np.array(point)
    best: tuple[float, Camera] | None = None
    for elevation in ELEVATIONS:
        for azimuth in AZIMUTHS:
            angle = front + azimuth
            level = math.cos(elevation)
            away = np.array([level * math.cos(angle), level * math.sin(angle), math.sin(elevation)])
            hidden = _hidden(target, away, corners, distance)
            if best is None or hidden < best[0]:
                best = (hidden, Camera(_vector(target + distance * away), point))
            if hidden == 0:
                return best[1]
    assert best is not None
    return best[1]


def _fit(across: Array, depth: Array, slope: float) -> tuple[float, float]:
    """Return where on its axis the eye stands and how deep, so that |x - e| <= slope (z - d)."""
    right = float((across - slope * depth).max())
    left = float((-across - slope * depth).max())
    return (right - left) / 2, -(right + left) / (2 * slope)


def _hidden(origin: Array, direction: Array, corners: Array, reach: float) -> float:
    """Return how much of what lies farther than BESIDE a ray meets [Möller-Trumbore]."""
    first = corners[:, 1] - corners[:, 0]
    second = corners[:, 2] - corners[:, 0]
    across = np.cross(direction, second)
    determinant = (first * across).sum(1)
    determinant = np.where(np.abs(determinant) < 1e-12, np.inf, determinant)
    offset = origin - corners[:, 0]
    u = (offset * across).sum(1) / determinant
    turned = np.cross(offset, first)
    v = (turned @ direction) / determinant
    t = (second * turned).sum(1) / determinant
    met = (u >= 0) & (v >= 0) & (u + v <= 1) & (t > BESIDE) & (t < reach)
    return float(np.count_nonzero(met))


def bounds(low: Array, high: Array) -> Array:
    """Return the eight corners of boxes given by two of them, shapes (n, 3) and (8 n, 3)."""
    picks = np.array([(i, j, k) for i in (0, 1) for j in (0, 1) for k in (0, 1)], np.bool_)
    return np.where(picks, high[:, None], low[:, None]).reshape(-1, 3)


def _vector(values: Array) -> Vector:
    x, y, z = values
    return (float(x), float(y), float(z))
