"""Frames of a real camera and the run of a program, synchronised: stills and a recording."""

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import NamedTuple

import cv2
import numpy as np

from vrts.base.diagnostic import Diagnostic, Rule, error
from vrts.engine.run import Run
from vrts.validate.camera.calibrate import Calibrated
from vrts.validate.camera.frames import Frame, Frames, Pixels, WrongFrames, wrong_size
from vrts.validate.camera.model import PtzCamera
from vrts.validate.camera.overlay import overlay
from vrts.validate.camera.views import Views
from vrts.validate.seen_run import assessment_of

NOTHING_SHOWN = Rule("V906", "no-frame-in-run")

QUALITY = 85  # of JPEG
MOST_RECORDED = 1500  # frames in a recording; of more, every second, third ...


class Shown(NamedTuple):
    """A sequence of frames, and what it is compared with."""

    run: Run
    frames: Frames
    views: Views
    calibrated: Calibrated
    starts_s: float  # run time of the first frame

    @property
    def camera(self) -> PtzCamera:
        """The camera that was found."""
        return self.calibrated.camera


class Still(NamedTuple):
    """A frame with the simulated robot drawn over it."""

    number: int  # of the frame, from 0
    time_s: float  # of the run
    png: bytes


def stills(s: Shown, most: int, done: Callable[[int], None] = lambda _: None) -> list[Still]:
    """Return frames with the robot drawn over them, evenly spread over the run.

    Args:
        s: What is shown.
        most: How many stills at most.
        done: Told the number of every still that is drawn.

    Raises:
        WrongFrames: A frame has another size, or none lies within the run.
    """
    inside = [n for n in range(s.frames.count) if _within(s, n / s.frames.fps)]
    spread: list[float] = np.linspace(0, len(inside) - 1, min(most, len(inside))).tolist()
    wanted = {inside[round(at)] for at in spread}
    found: list[Still] = []
    for frame in _frames(s, wanted):
        time_s = s.starts_s + frame.time_s
        view = s.views.at(frame.time_s)
        found.append(
            Still(frame.number, time_s, _png(overlay(frame.pixels, s.run, time_s, s.camera, view)))
        )
        done(frame.number)
    if not found:
        raise WrongFrames(_nothing(s))
    return found


def record(s: Shown, name: str, summary: str, path: Path) -> None:
    """Write a recording with frames and robot; see `report.recording.through_camera`."""
    from vrts.report.recording.through_camera import (  # rerun is optional
        SeenFrame,
        write_through_camera,
    )

    camera = s.camera
    inside = [n for n in range(s.frames.count) if _within(s, n / s.frames.fps)]
    step = -(-len(inside) // MOST_RECORDED) or 1

    def seen() -> Iterator[SeenFrame]:
        for frame in _frames(s, set(inside[::step])):
            time_s, view = s.starts_s + frame.time_s, s.views.at(frame.time_s)
            matrix = camera.matrix(view)
            lens = np.array([*camera.distortion, 0.0, 0.0])
            plain = np.asarray(cv2.undistort(frame.pixels, matrix, lens), np.uint8)
            drawn = overlay(plain, s.run, time_s, camera._replace(distortion=(0.0, 0.0)), view)
            axes, focal = camera.axes(view), float(matrix[0, 0])
            yield SeenFrame(time_s, _jpeg(plain), _jpeg(drawn), axes, focal, camera.centre_px)

    a = assessment_of(s.run, name, "camera")
    write_through_camera(a, seen(), camera.eye, camera.size_px, summary, path)


def _frames(s: Shown, wanted: set[int]) -> Iterator[Frame]:
    for frame in s.frames.chosen(wanted):
        height, width = frame.pixels.shape[:2]
        if (width, height) != s.camera.size_px:
            raise WrongFrames(wrong_size(frame, s.camera.size_px))
        yield frame


def _within(s: Shown, time_s: float) -> bool:
    return 0.0 <= s.starts_s + time_s <= s.run.horizon_s


def _png(pixels: Pixels) -> bytes:
    ok, png = cv2.imencode(".png", pixels)
    assert ok
    return png.tobytes()


def _jpeg(pixels: Pixels) -> bytes:
    ok, jpeg = cv2.imencode(".jpg", pixels, [cv2.IMWRITE_JPEG_QUALITY, QUALITY])
    assert ok
    return jpeg.tobytes()


def _nothing(s: Shown) -> Diagnostic:
    end = s.run.horizon_s
    until = s.starts_s + max(s.frames.count - 1, 0) / s.frames.fps
    return error(
        NOTHING_SHOWN,
        "no frame shows a time of the run",
        notes=(
            f"the frames are of {s.starts_s:.2f} to {until:.2f} s, the run of 0 to {end:.2f} s",
        ),
        help=("say when the first frame was taken: `--starts SECONDS` of the run",),
    )
