"""Where a camera stands and how its lens sees, from marked points: Tsai's problem.

OpenCV solves each picture that has enough points for a first guess; then all pictures together give
one eye, one mount and one lens, whose pan, tilt and zoom are known, by least squares.
"""

from itertools import product
from typing import NamedTuple

import cv2
import numpy as np
from scipy.optimize import least_squares

from vrts.base.diagnostic import Diagnostic, Rule, error
from vrts.base.units import mm
from vrts.validate.camera.calibration_file import LEAST_POINTS, Marked, Picture
from vrts.validate.camera.model import Array, PtzCamera

NOT_FOUND = Rule("V902", "camera-not-found")

FOCALS = (0.7, 1.0, 1.5, 2.2, 3.5)  # of the width: guesses where none is given
FLAT_M = 0.01  # points within so much of a plane do not tell the focal length from the distance
_BEHIND_PX = 1e4  # error of a point that would lie behind the camera


class Calibrated(NamedTuple):
    """A camera, and how far its marks are from where it sees the points."""

    camera: PtzCamera
    errors: tuple[Array, ...]  # (n,) of each picture, pixels
    uncertain_mm: float  # standard deviation of the eye, as the scatter of the marks tells

    @property
    def rms_px(self) -> float:
        """Root mean square distance of all marks."""
        return float(np.sqrt(np.mean(np.concatenate(self.errors) ** 2)))

    @property
    def largest_px(self) -> float:
        """Largest distance of a mark."""
        return float(np.concatenate(self.errors).max())


def calibrate(marked: Marked) -> Calibrated | Diagnostic:
    """Return the camera that sees the points nearest to their marks, or why there is none."""
    best: tuple[float, PtzCamera] | None = None
    for picture, focal in product(marked.pictures, _focals(marked)):
        guess = _guess(marked, picture, focal)
        if guess is None:
            continue
        cost = float((_misses(guess, marked) ** 2).sum())
        if best is None or cost < best[0]:
            best = cost, guess
    if best is None:
        return _not_found(f"no picture has {LEAST_POINTS} points that are not in one plane")
    camera, spread = _refined(best[1], marked)
    errors = _misses(camera, marked)
    counts = np.cumsum([len(picture.names) for picture in marked.pictures])[:-1]
    if not np.isfinite(errors).all() or errors.max() >= _BEHIND_PX:
        return _not_found("some points would have to lie behind it")
    return Calibrated(camera, tuple(np.split(errors, counts)), spread)


def _focals(marked: Marked) -> tuple[float, ...]:
    if marked.focal_px is not None:
        return (marked.focal_px,)
    return tuple(share * marked.size_px[0] for share in FOCALS)


def _guess(marked: Marked, picture: Picture, focal: float) -> PtzCamera | None:
    """Return a camera from one picture alone, without distortion; None if it tells too little."""
    points = np.array([marked.points[name] for name in picture.names]).reshape(-1, 3)
    if len(points) < LEAST_POINTS or _thickness(points) < FLAT_M:
        return None
    centre = _middle(marked.size_px)
    K = np.array([[focal, 0, centre[0]], [0, focal, centre[1]], [0, 0, 1.0]])
    K[:2, :2] *= picture.view.zoom
    try:
        ok, turn, shift = cv2.solvePnP(points, picture.pixels, K, None, flags=cv2.SOLVEPNP_SQPNP)
    except cv2.error:
        return None
    if not ok:
        return None
    axes, _ = cv2.Rodrigues(np.asarray(turn, np.float64))
    axes = np.asarray(axes, np.float64)
    eye = -axes.T @ np.asarray(shift, np.float64).ravel()
    if (((points - eye) @ axes.T)[:, 2] <= 0).any():
        return None
    still = PtzCamera(eye, np.eye(3), focal, centre, size_px=marked.size_px)
    mount = still.axes(picture.view).T @ axes
    return still._replace(mount=mount)


def _refined(camera: PtzCamera, marked: Marked) -> tuple[PtzCamera, float]:
    """Return the camera with the least squared misses, and how well its eye is known [mm]."""
    lens = 2 if marked.fit_distortion else 0
    centre = 2 if marked.fit_centre else 0

    def of(x: Array) -> PtzCamera:
        turned, _ = cv2.Rodrigues(x[3:6])
        k = 7 + lens
        return camera._replace(
            eye=camera.eye + x[:3],
            mount=np.asarray(turned, np.float64) @ camera.mount,
            focal_px=camera.focal_px * float(np.exp(x[6])),
            distortion=(float(x[7]), float(x[8])) if lens else (0.0, 0.0),
            centre_px=(
                (camera.centre_px[0] + float(x[k]), camera.centre_px[1] + float(x[k + 1]))
                if centre
                else camera.centre_px
            ),
        )

    def misses(x: Array) -> Array:
        return _offsets(of(x), marked).ravel()

    start = np.zeros(7 + lens + centre)
    solved = least_squares(misses, start, x_scale="jac")
    free = max(len(solved.fun) - len(solved.x), 1)
    scatter = 2.0 * float(solved.cost) / free
    covariance = np.linalg.pinv(solved.jac.T @ solved.jac) * scatter
    return of(solved.x), mm(float(np.sqrt(np.trace(covariance[:3, :3]))))


def _offsets(camera: PtzCamera, marked: Marked) -> Array:
    """Return by how much every mark misses, column and row, shape (n, 2), pixels."""
    rows = [
        camera.seen(np.array([marked.points[name] for name in picture.names]), picture.view)
        - picture.pixels
        for picture in marked.pictures
        if picture.names
    ]
    return np.nan_to_num(np.concatenate(rows), nan=_BEHIND_PX)


def _misses(camera: PtzCamera, marked: Marked) -> Array:
    return np.asarray(np.linalg.norm(_offsets(camera, marked), axis=1), np.float64)


def _thickness(points: Array) -> float:
    """Return how far points lie from the plane nearest to all, root mean square [m]."""
    spread = np.linalg.svd(points - points.mean(axis=0), compute_uv=False)
    return float(spread[2] / np.sqrt(len(points)))


def _middle(size: tuple[int, int]) -> tuple[float, float]:
    return (size[0] - 1) / 2, (size[1] - 1) / 2


def _not_found(reason: str) -> Diagnostic:
    return error(
        NOT_FOUND,
        "where the camera stands cannot be told",
        notes=(reason,),
        help=(
            "mark six points or more in one picture, some of them well above the others",
            "check the signs of pan and tilt: right and up are positive",
        ),
    )
