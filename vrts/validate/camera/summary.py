"""What was found about a camera, as text and as JSON."""

import math
from typing import Any

import numpy as np

from vrts.base.units import DEG, MM
from vrts.validate.camera.calibrate import Calibrated
from vrts.validate.camera.model import PtzCamera, View

GOOD_PX = 0.5  # reprojection error, root mean square, of a calibration to rely on


def camera_text(found: Calibrated) -> str:
    """Return lines about a calibrated camera."""
    camera = found.camera
    x, y, z = camera.eye / MM
    forward = camera.axes(View())[2]
    azimuth = math.degrees(math.atan2(forward[1], forward[0]))
    elevation = math.degrees(math.asin(float(np.clip(forward[2], -1.0, 1.0))))
    angle = math.degrees(2 * math.atan2(camera.size_px[0] / 2, camera.focal_px))
    marks = sum(len(errors) for errors in found.errors)
    slope = f"{abs(elevation):.1f} deg {'up' if elevation > 0 else 'down'}"
    most = f"{found.largest_px:.2f} px at most"
    rows = [
        f"the camera stands at X {x:.0f}  Y {y:.0f}  Z {z:.0f} mm (± {found.uncertain_mm:.1f} mm)",
        f"at pan 0 and tilt 0 it looks to {azimuth:.1f} deg from X to Y, {slope}",
        f"focal length {camera.focal_px:.1f} px at zoom 1 ({angle:.1f} deg wide)",
        f"lens k1 {camera.distortion[0]:+.4f}  k2 {camera.distortion[1]:+.4f}",
        *_tilt(camera),
        f"reprojection error of {marks} marks: {found.rms_px:.2f} px root mean square, {most}",
    ]
    return "\n".join(rows)


def _tilt(camera: PtzCamera) -> tuple[str, ...]:
    if camera.tilt_zero == 0.0:
        return ()
    return (f"tilt is {camera.tilt_zero / DEG:+.2f} deg where its scale says 0",)


def camera_json(found: Calibrated) -> dict[str, Any]:
    """Return a calibrated camera as plain data."""
    camera = found.camera
    return {
        "eye_mm": [float(v) for v in camera.eye / MM],
        "eye_uncertain_mm": found.uncertain_mm,
        "axes_right_down_forward": _rows(camera),
        "focal_px": camera.focal_px,
        "centre_px": list(camera.centre_px),
        "distortion_k1_k2": list(camera.distortion),
        "size_px": list(camera.size_px),
        "tilt_zero_deg": camera.tilt_zero / DEG,
        "rms_px": found.rms_px,
        "largest_px": found.largest_px,
        "left_out": [
            {
                "picture": one.picture + 1,
                "point": one.name,
                "miss_px": one.miss_px,
                "exchanged_with": one.exchanged_with,
            }
            for one in found.left_out
        ],
        "errors_px": [[float(e) for e in errors] for errors in found.errors],
        "angle_of_view_deg": 2 * math.atan2(camera.size_px[0] / 2, camera.focal_px) / DEG,
    }


def _rows(camera: PtzCamera) -> list[list[float]]:
    return [[float(v) for v in row] for row in camera.mount]
