"""Where a camera stands and how its lens sees, from marked points: Tsai's problem.

OpenCV solves each picture that has enough points for a first guess; then all pictures together give
one eye, one mount and one lens, whose pan, tilt and zoom are known, by least squares. A wrong mark
must not move the camera: guesses from few marks, a robust fit, and then a plain one without what is
far off (Huber, Robust Statistics).
"""

from collections.abc import Iterable, Iterator
from itertools import product
from typing import NamedTuple

import cv2
import numpy as np
from scipy.optimize import least_squares

from vrts.base.diagnostic import Diagnostic, Rule, error
from vrts.base.units import DEG, mm
from vrts.validate.camera.calibration_file import LEAST_POINTS, Marked, Picture
from vrts.validate.camera.model import Array, PtzCamera
from vrts.validate.camera.wrong_marks import (
    LEAST_PX,
    LeftOut,
    Mask,
    agreeing,
    enough,
    left_out,
)

NOT_FOUND = Rule("V902", "camera-not-found")

FOCALS = (0.7, 1.0, 1.5, 2.2, 3.5)  # of the width: guesses where none is given
FLAT_M = 0.01  # points within so much of a plane do not tell the focal length from the distance
PANNED = 2.0 * DEG  # pictures that differ by more in pan tell where tilt counts from
_BEHIND_PX = 1e4  # error of a point that would lie behind the camera
_SUBSETS = 40  # of six marks of a picture: some are without the wrong ones
_NEAR_PX = 5.0  # a guess knows no distortion: marks so near agree with it
_ROUNDS = 12  # of leaving marks out and taking them in again
_SEED = 1  # of the subsets: the same marks give the same camera


class Calibrated(NamedTuple):
    """A camera, and how far its marks are from where it sees the points."""

    camera: PtzCamera
    errors: tuple[Array, ...]  # (n,) of the marks kept in each picture, pixels
    uncertain_mm: float  # standard deviation of the eye, as the scatter of the marks tells
    left_out: tuple[LeftOut, ...] = ()

    @property
    def rms_px(self) -> float:
        """Root mean square distance of all marks that were kept."""
        return float(np.sqrt(np.mean(np.concatenate(self.errors) ** 2)))

    @property
    def largest_px(self) -> float:
        """Largest distance of a mark that was kept."""
        return float(np.concatenate(self.errors).max())


def calibrate(marked: Marked) -> Calibrated | Diagnostic:
    """Return the camera that sees the points nearest to their marks, or why there is none.

    Marks that are far from where all others say they belong are left out, if those are few.
    """
    best = _best(marked, marked.pictures) or _best(marked, _subsets(marked))
    if best is None:
        return _not_found(f"no picture has {LEAST_POINTS} points that are not in one plane")
    camera, spread = _refined(best, marked, None, robust=False)
    errors = _misses(camera, marked)
    kept = np.ones(len(errors), dtype=np.bool_)
    if errors.max() > LEAST_PX:
        guess = _best(marked, _subsets(marked)) or best  # a wrong mark spoils guesses from all
        found = _without_wrong(guess, marked)
        if found is not None:
            (camera, spread), kept = found
            errors = _misses(camera, marked)
    if not np.isfinite(errors).all() or errors[kept].max() >= _BEHIND_PX:
        return _not_found("some points would have to lie behind it")
    counts = np.cumsum([len(picture.names) for picture in marked.pictures])[:-1]
    each = zip(np.split(errors, counts), np.split(kept, counts), strict=True)
    return Calibrated(
        camera,
        tuple(miss[own] for miss, own in each),
        spread,
        left_out(camera, marked, np.split(kept, counts)),
    )


def _without_wrong(guess: PtzCamera, marked: Marked) -> tuple[tuple[PtzCamera, float], Mask] | None:
    """Return the camera that most marks agree on, and which those are; None: too few do."""
    robust, spread = _refined(guess, marked, None, robust=True)
    kept, found = agreeing(_misses(robust, marked)), (robust, spread)
    for _ in range(_ROUNDS):
        if not enough(kept):
            return None
        found = _refined(robust, marked, kept, robust=False)
        again = agreeing(_misses(found[0], marked), kept)
        if (again == kept).all():
            break
        kept = again
    return None if kept.all() else (found, kept)


def _best(marked: Marked, pictures: Iterable[Picture]) -> PtzCamera | None:
    """Return the guess from one picture that most marks agree with; None: no picture gives one."""
    best: tuple[float, PtzCamera] | None = None
    for picture, focal in product(pictures, _focals(marked)):
        guess = _guess(marked, picture, focal)
        if guess is None:
            continue
        cost = float(np.log1p((_misses(guess, marked) / _NEAR_PX) ** 2).mean())
        if best is None or cost < best[0]:
            best = cost, guess
    return None if best is None else best[1]


def _subsets(marked: Marked) -> Iterator[Picture]:
    """Yield pictures with only six of their marks: one without a wrong mark may be among them."""
    drawn = np.random.default_rng(_SEED)
    for picture in marked.pictures:
        for _ in range(_SUBSETS if len(picture.names) > LEAST_POINTS else 0):
            order: list[int] = drawn.permutation(len(picture.names)).tolist()
            rows = sorted(order[:LEAST_POINTS])
            names = tuple(picture.names[row] for row in rows)
            yield picture._replace(names=names, pixels=picture.pixels[rows])


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


def _refined(
    camera: PtzCamera, marked: Marked, kept: Mask | None, *, robust: bool
) -> tuple[PtzCamera, float]:
    """Return the camera with the least squared misses, and how well its eye is known [mm].

    Args:
        camera: To begin with.
        marked: What was marked.
        kept: Marks that count; None: all.
        robust: Whether a mark that is far off counts less than its square.
    """
    lens = 2 if marked.fit_distortion else 0
    centre = 2 if marked.fit_centre else 0
    pans = [picture.view.pan for picture in marked.pictures]
    tilts = 1 if max(pans) - min(pans) > PANNED else 0

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
            tilt_zero=camera.tilt_zero + float(x[-1]) if tilts else 0.0,
        )

    def misses(x: Array) -> Array:
        offsets = _offsets(of(x), marked)
        return (offsets if kept is None else offsets[kept]).ravel()

    start = np.zeros(7 + lens + centre + tilts)
    loss = "soft_l1" if robust else "linear"
    solved = least_squares(misses, start, x_scale="jac", loss=loss)
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
