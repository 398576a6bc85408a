"""Frames of a real camera: a folder of pictures, or a video file, opened one after the other."""

import re
from collections.abc import Collection, Iterator
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
FRAME_UNREADABLE = Rule("V907", "frame-unreadable")

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


class WrongFrames(Exception):  # noqa: N818 -- names the situation
    """Frames that cannot be compared; the diagnostic says why."""

    def __init__(self, diagnostic: Diagnostic) -> None:
        """Keep the diagnostic."""
        super().__init__(diagnostic.headline)
        self.diagnostic = diagnostic


@dataclass(frozen=True, slots=True)
class Frames:
    """A sequence that can be opened again and again."""

    place: Path
    files: tuple[Path, ...]  # empty for a video
    fps: float
    count: int

    def chosen(self, wanted: Collection[int]) -> Iterator[Frame]:
        """Yield some of the frames, in their order; the others are not decoded.

        Raises:
            WrongFrames: One cannot be read.
        """
        pictures = _of_files(self.files, wanted) if self.files else _of_video(self.place, wanted)
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
        count = _counted(video)
    finally:
        video.release()
    if not count:
        return _none(place, "the video holds none that can be read")
    return Frames(place, (), fps or (told if 0.1 < told < 1000 else DEFAULT_FPS), count)


def wrong_size(frame: Frame, size: tuple[int, int]) -> Diagnostic:
    """Return what to say of a frame that is not as large as those of the calibration."""
    height, width = frame.pixels.shape[:2]
    return error(
        FRAME_SIZE,
        f"frame {frame.number} is {width} x {height} pixels, the camera's {size[0]} x {size[1]}",
        help=("calibrate with pictures of the same size: `size_px` of the calibration file",),
    )


def _of_files(files: tuple[Path, ...], wanted: Collection[int]) -> Iterator[tuple[int, Pixels]]:
    for number in sorted(wanted):
        file = files[number]
        data = np.frombuffer(file.read_bytes()[: MOST_BYTES + 1], np.uint8)
        fits = 0 < len(data) <= MOST_BYTES
        pixels = cv2.imdecode(data, cv2.IMREAD_COLOR) if fits else None
        if pixels is None:
            raise WrongFrames(_unreadable(f"`{file.name}`"))
        yield number, np.asarray(pixels, np.uint8)


def _of_video(place: Path, wanted: Collection[int]) -> Iterator[tuple[int, Pixels]]:
    video = cv2.VideoCapture(str(place))
    try:
        for number in range(max(wanted, default=-1) + 1):
            if not video.grab():
                raise WrongFrames(_unreadable(f"frame {number} of `{place.name}`"))
            if number in wanted:
                _, pixels = video.retrieve()
                yield number, np.asarray(pixels, np.uint8)
    finally:
        video.release()


def _counted(video: cv2.VideoCapture) -> int:
    """Return how many frames a video really has, which files tell wrongly or not at all."""
    count = 0
    while count < MOST_FRAMES and video.grab():
        count += 1
    return count


def _unreadable(what: str) -> Diagnostic:
    return error(
        FRAME_UNREADABLE,
        f"{what} cannot be read as a picture",
        help=("copy it again: frames are matched to the run by their numbers",),
    )


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
