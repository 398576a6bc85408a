"""A camera that pans, tilts and zooms.

Its own axes are right, down and forward. It looks about one fixed point, its eye: pan turns it
about the vertical of its mount, positive to the right, then tilt about its own right axis, positive
upward. Where pan counts from is part of the mount; where tilt counts from is not, once the camera
has panned. The focal length is that at zoom 1, times the zoom. Pixels are counted from the top left
corner of the picture, whose centre of the first pixel is (0, 0), as OpenCV has it.
"""

import math
from typing import NamedTuple

import cv2
import numpy as np
import numpy.typing as npt

Array = npt.NDArray[np.float64]

NEAR_M = 0.05  # nothing nearer to the eye is seen


class View(NamedTuple):
    """Where the camera looks."""

    pan: float = 0.0  # [rad]
    tilt: float = 0.0  # [rad]
    zoom: float = 1.0


class PtzCamera(NamedTuple):
    """A camera at its place."""

    eye: Array  # (3,) in W [m]
    mount: Array  # (3, 3) rows right, down, forward at pan 0 and tilt 0, unit vectors in W
    focal_px: float  # at zoom 1
    centre_px: tuple[float, float]  # column and row on the optical axis
    distortion: tuple[float, float] = (0.0, 0.0)  # k1, k2 of the lens
    size_px: tuple[int, int] = (0, 0)  # width and height of its pictures
    tilt_zero: float = 0.0  # tilt where its scale says 0 [rad]

    def axes(self, view: View) -> Array:
        """Return rows right, down, forward in W of the camera as it looks, shape (3, 3)."""
        c, s = math.cos(view.pan), math.sin(view.pan)
        panned = np.array([[c, 0.0, s], [0.0, 1.0, 0.0], [-s, 0.0, c]])
        tilt = view.tilt + self.tilt_zero
        c, s = math.cos(tilt), math.sin(tilt)
        tilted = np.array([[1.0, 0.0, 0.0], [0.0, c, -s], [0.0, s, c]])
        return (panned @ tilted).T @ self.mount

    def matrix(self, view: View) -> Array:
        """Return the intrinsic matrix, shape (3, 3), pixels."""
        focal = self.focal_px * view.zoom
        u, v = self.centre_px
        return np.array([[focal, 0.0, u], [0.0, focal, v], [0.0, 0.0, 1.0]])

    def seen(self, points: Array, view: View) -> Array:
        """Return column and row of points in W, shapes (n, 3) and (n, 2); nan behind the camera."""
        axes = self.axes(view)
        local = (points - self.eye) @ axes.T
        lens = np.array([*self.distortion, 0.0, 0.0])
        found = np.full((len(points), 2), np.nan)
        before = local[:, 2] > NEAR_M
        if before.any():
            zero = np.zeros(3)
            pixels, _ = cv2.projectPoints(local[before], zero, zero, self.matrix(view), lens)
            found[before] = np.asarray(pixels, np.float64).reshape(-1, 2)
        return found
