"""Frames of a real camera: a folder of pictures, or a video file, opened one after the other."""

import re
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import NamedTuple

import cv2
import numpy as np
import numpy.typing as npt

from vrts.base.diagnostic import Diagnostic, Rule, error

Pixels = npt.NDArray[np.uint8]  # (height, width, 3), blue, green, red as OpenCV has it

NO_FRAMES = Rule("V904", "no-frames")
FRAME_SIZE = Rule("V905", "frame-size")

SUFFIXES = frozenset({".png", ".jpg", ".jpeg", ".bmp", ".tif", ".tiff", ".webp"})
MOST_FRAMES = 50_000
MOST_BYTES = 200_000_000  # of one picture file
DEFAULT_FPS = 25.0
_DIGITS = re.compile(r"(\d+)")


class Frame(NamedTuple):
    """One picture."""

    number: int  # from 0
    time_s: float  # since the first frame
    pixels: Pixels


@dataclass(frozen=True, slots=True)
class Frames:
    """A sequence that can be opened again and again."""

    place: Path
    files: tuple[Path, ...]  # empty for a video
    fps: float
    count: int  # as far as it is known before all are read

    def __iter__(self) -> Iterator[Frame]:
        """Yield the frames; those that cannot be read are passed over."""
        pictures = _of_files(self.files) if self.files else _of_video(self.place)
        for number, pixels in pictures:
            yield Frame(number, number / self.fps, pixels)


def open_frames(place: Path, fps: float | None) -> Frames | Diagnostic:
    """Return the frames of a folder or a video, or what is wrong with it.

    Args:
        place: The folder, whose pictures are taken in the order of the numbers in their names, or
            the video.
        fps: Frames a second; None: as the video says, 25 for a folder.
    """
    if place.is_dir():
        files = tuple(sorted((f for f in place.iterdir() if _is_picture(f)), key=_by_number))
        if not files:
            return _none(place, f"no pictures with names that end in {', '.join(sorted(SUFFIXES))}")
        return Frames(place, files[:MOST_FRAMES], fps or DEFAULT_FPS, len(files[:MOST_FRAMES]))
    if not place.is_file():
        return _none(place, "there is no such folder or file")
    video = cv2.VideoCapture(str(place))
    try:
        if not video.isOpened():
            return _none(place, "OpenCV cannot read it as a video")
        told = float(video.get(cv2.CAP_PROP_FPS))
        count = int(video.get(cv2.CAP_PROP_FRAME_COUNT))
    finally:
        video.release()
    return Frames(place, (), fps or (told if 0.1 < told < 1000 else DEFAULT_FPS), max(count, 0))


def wrong_size(frame: Frame, size: tuple[int, int]) -> Diagnostic:
    """Return what to say of a frame that is not as large as those of the calibration."""
    height, width = frame.pixels.shape[:2]
    return error(
        FRAME_SIZE,
        f"frame {frame.number} is {width} x {height} pixels, the camera's {size[0]} x {size[1]}",
        help=("calibrate with pictures of the same size: `size_px` of the calibration file",),
    )


def _of_files(files: tuple[Path, ...]) -> Iterator[tuple[int, Pixels]]:
    for number, file in enumerate(files):
        if file.stat().st_size > MOST_BYTES:
            continue
        data = np.frombuffer(file.read_bytes(), np.uint8)
        pixels = cv2.imdecode(data, cv2.IMREAD_COLOR) if len(data) else None
        if pixels is not None:
            yield number, np.asarray(pixels, np.uint8)


def _of_video(place: Path) -> Iterator[tuple[int, Pixels]]:
    video = cv2.VideoCapture(str(place))
    try:
        for number in range(MOST_FRAMES):
            ok, pixels = video.read()
            if not ok:
                return
            yield number, np.asarray(pixels, np.uint8)
    finally:
        video.release()


def _is_picture(file: Path) -> bool:
    return file.suffix.lower() in SUFFIXES and file.is_file()


def _by_number(file: Path) -> list[tuple[int, int, str]]:
    """Sort `frame2.png` before `frame10.png`."""
    return [
        (1, int(part), "") if part.isdecimal() else (0, 0, part.lower())
        for part in _DIGITS.split(file.name)
    ]


def _none(place: Path, came: str) -> Diagnostic:
    return error(
        NO_FRAMES,
        f"there are no frames in `{place.name}`",
        notes=(came,),
        help=("give a folder of pictures, or a video file",),
    )
