"""The simulated robot drawn over a frame, as the real camera would see it."""

import cv2
import numpy as np
import numpy.typing as npt

from vrts.engine.run import Run
from vrts.report.picture.lighting import to_srgb
from vrts.report.picture.placing import Placed, place_moving
from vrts.validate.camera.frames import Pixels
from vrts.validate.camera.model import Array, PtzCamera, View

OPACITY = 0.45  # of what is simulated
EDGE = (40, 90, 255)  # blue, green, red of the outlines
EDGE_PX = 2
LIGHT = np.array([0.35, -0.5, 0.8]) / np.linalg.norm([0.35, -0.5, 0.8])  # towards it, in W
DARKEST = 0.35  # share of its colour that a face turned away from the light keeps
_SHIFT = 4  # bits of a pixel that corners are rounded to

Mask = npt.NDArray[np.uint8]


def overlay(pixels: Pixels, run: Run, time_s: float, camera: PtzCamera, view: View) -> Pixels:
    """Return a frame with arm, hand and movable objects of a run drawn over it.

    Args:
        pixels: The frame; it is not changed.
        run: The run.
        time_s: Run time that the frame shows; the arm rests before the run and after it.
        camera: The real camera.
        view: Where it looked.
    """
    drawn = pixels.copy()
    shape = simulated(drawn, run, time_s, camera, view)
    mixed = np.asarray(cv2.addWeighted(drawn, OPACITY, pixels, 1 - OPACITY, 0.0), np.uint8)
    found, _ = cv2.findContours(shape, cv2.RETR_LIST, cv2.CHAIN_APPROX_NONE)
    cv2.drawContours(mixed, found, -1, EDGE, EDGE_PX, cv2.LINE_AA)
    return mixed


def simulated(canvas: Pixels, run: Run, time_s: float, camera: PtzCamera, view: View) -> Mask:
    """Draw what moves in a run over a canvas; return its pixels, 255 where it is."""
    placed = _placed(run, time_s)
    shape = np.zeros(canvas.shape[:2], np.uint8)
    corners = placed.corners
    if not len(corners):
        return shape
    pixels = camera.seen(corners.reshape(-1, 3), view).reshape(-1, 3, 2)
    depth = (corners - camera.eye) @ camera.axes(view)[2]
    facing = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    towards = ((camera.eye - corners[:, 0]) * facing).sum(axis=1) > 0
    shown = np.flatnonzero(towards & np.isfinite(pixels).all(axis=(1, 2)) & _near(pixels, shape))
    order = shown[np.argsort(-depth[shown].mean(axis=1), kind="stable")]  # the farthest first
    colors = _colors(placed, facing)
    fixed = np.round(pixels * (1 << _SHIFT)).astype(np.int32)
    for k in map(int, order):
        cv2.fillConvexPoly(canvas, fixed[k], colors[k], cv2.LINE_8, _SHIFT)
        cv2.fillConvexPoly(shape, fixed[k], (255,), cv2.LINE_8, _SHIFT)
    return shape


def _placed(run: Run, time_s: float) -> Placed:
    state = run.at(min(max(time_s, 0.0), run.horizon_s))
    return place_moving(
        run.scene, state.configuration, hand_opening=state.hand_opening, poses=state.poses
    )


def _near(pixels: Array, shape: Mask) -> npt.NDArray[np.bool_]:
    """Whether triangles are on the picture or not far beside: farther ones overflow the raster."""
    height, width = shape.shape
    room = 4 * max(height, width)
    low, high = pixels.min(axis=1), pixels.max(axis=1)
    inside = (high[:, 0] >= 0) & (high[:, 1] >= 0) & (low[:, 0] < width) & (low[:, 1] < height)
    return inside & (low > -room).all(axis=1) & (high < room + max(height, width)).all(axis=1)


def _colors(placed: Placed, facing: Array) -> list[tuple[int, int, int]]:
    """Return blue, green, red of every triangle."""
    own = np.array([solid.color for solid in placed.solids], np.float32)[placed.solid]
    unit = facing / np.maximum(np.linalg.norm(facing, axis=1, keepdims=True), 1e-12)
    lit = DARKEST + (1 - DARKEST) * np.clip(unit @ LIGHT, 0.0, 1.0)
    srgb = to_srgb((own * lit[:, None]).astype(np.float32))
    rows: list[list[int]] = srgb.tolist()
    return [(b, g, r) for r, g, b in rows]
