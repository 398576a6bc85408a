"""A recording of a run as a real camera saw it: its frames, and the simulated robot through it."""

from collections.abc import Iterable
from pathlib import Path
from typing import NamedTuple

import numpy as np
import rerun as rr
import rerun.blueprint as rrb

from vrts.report.assessment import Assessment
from vrts.report.plain import one_line
from vrts.report.poses.sampled import coordinates, times_of
from vrts.report.recording import APPLICATION
from vrts.report.recording.blueprint import BACKGROUND
from vrts.report.recording.motion import send_motion
from vrts.report.recording.names import TIMELINE, Array
from vrts.report.recording.shapes import send_shapes

CAMERA = "world/camera"
FRAME = f"{CAMERA}/frame"
OVERLAY = "overlay"
PLANE_M = 0.6  # before the eye, where the frame stands in the scene


class SeenFrame(NamedTuple):
    """A frame without the distortion of the lens, and the camera that took it."""

    time_s: float  # of the run
    jpeg: bytes
    overlay: bytes  # JPEG: the same with the simulated robot drawn over it
    axes: Array  # (3, 3) rows right, down, forward in W
    focal_px: float
    centre_px: tuple[float, float]


def write_through_camera(
    a: Assessment,
    frames: Iterable[SeenFrame],
    eye: Array,
    size_px: tuple[int, int],
    summary: str,
    path: Path,
) -> None:
    """Write a recording of a run with the frames of a camera.

    Args:
        a: With run and scene.
        frames: In time order.
        eye: Of the camera, shape (3,), in W [m].
        size_px: Width and height of the frames.
        summary: Plain text, shown beside.
        path: The file.

    Raises:
        ValueError: There is no run to record.
    """
    if a.run is None or a.scene is None:
        raise ValueError("nothing was run")
    stream = rr.RecordingStream(
        APPLICATION, recording_id=one_line(a.identifier), send_properties=False
    )
    with stream:
        stream.save(path, default_blueprint=_blueprint())
        send_shapes(a)
        times = times_of(a.run)
        send_motion(a, times, coordinates(a.run, times)[0])
        rr.log("summary", rr.TextDocument(summary), static=True)
        _log_all(frames, eye, size_px)
    stream.disconnect()


def _log_all(frames: Iterable[SeenFrame], eye: Array, size_px: tuple[int, int]) -> None:
    """Log frames, and that nothing is seen any more as long after the last as it came late."""
    before, last = 0.0, 0.0
    for frame in frames:
        _log(frame, eye, size_px)
        before, last = last, frame.time_s
    rr.set_time(TIMELINE, duration=2 * last - before)
    for path in (FRAME, OVERLAY):
        rr.log(path, rr.Clear(recursive=True))


def _log(frame: SeenFrame, eye: Array, size_px: tuple[int, int]) -> None:
    rr.set_time(TIMELINE, duration=frame.time_s)
    pinhole = rr.Pinhole(
        focal_length=frame.focal_px,
        principal_point=frame.centre_px,
        resolution=size_px,
        camera_xyz=rr.ViewCoordinates.RDF,
        image_plane_distance=PLANE_M,
    )
    rr.log(CAMERA, rr.Transform3D(translation=eye, mat3x3=np.array(frame.axes.T)), pinhole)
    rr.log(FRAME, rr.EncodedImage(contents=frame.jpeg, media_type="image/jpeg"))
    rr.log(OVERLAY, rr.EncodedImage(contents=frame.overlay, media_type="image/jpeg"))


def _blueprint() -> rrb.Blueprint:
    return rrb.Blueprint(
        rrb.Horizontal(
            rrb.Vertical(
                rrb.Spatial2DView(
                    origin=f"/{OVERLAY}", name="Real, with the simulated robot over it"
                ),
                rrb.Spatial2DView(
                    origin=f"/{CAMERA}",
                    contents=["/world/**", f"- /{FRAME}"],
                    name="Simulated, through the same camera",
                ),
            ),
            rrb.Vertical(
                rrb.Spatial3DView(
                    origin="/world", name="Scene", background=BACKGROUND, line_grid=False
                ),
                rrb.TextDocumentView(origin="/summary", name="Summary"),
                row_shares=[3, 1],
            ),
        ),
        rrb.TimePanel(timeline=TIMELINE, state="collapsed"),
        collapse_panels=True,
    )
