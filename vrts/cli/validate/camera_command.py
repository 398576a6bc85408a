"""`vrts validate PROGRAM --camera CAMERA.toml`."""

import sys
from pathlib import Path
from typing import TYPE_CHECKING, NoReturn

import click

from vrts.cli.shared.console import (
    HOLDS,
    WRONG,
    fail,
    guarded,
    out,
    say,
    show_diagnostics,
    warn,
    write_file,
)
from vrts.cli.shared.options import (
    Language,
    color_option,
    file_option,
    form_option,
    language_options,
)
from vrts.cli.validate.shared import NOT_INSTALLED, run_of, setting_options
from vrts.pipeline.where import Where

if TYPE_CHECKING:
    from vrts.base.diagnostic import Diagnostic
    from vrts.validate.camera.calibrate import Calibrated
    from vrts.validate.camera.compare import Shown
    from vrts.validate.camera.views import Views

EPILOG = """\b
The calibration file says what was marked in one picture or more:
  [camera]
  size_px = [1280, 720]
  [points_mm]                    # in the world frame of the scene
  corner = [900, 300, -300]
  [[pictures]]
  pan_deg = 0                    # right is positive
  tilt_deg = -10                 # up is positive
  zoom = 1
  seen_px = { corner = [512.3, 301.2], ... }
Six points or more, not all in one plane. The log of --views has the columns
time_s, pan_deg, tilt_deg, zoom, as far as they change; time_s is 0 at the first frame.

\b
Examples:
  vrts validate path.v2 --scene lab --camera camera.toml --frames shots/ -o seen
  vrts validate path.v2 --scene lab --camera camera.toml --frames film.mp4 \\
      --views ptz.csv --starts 1.2 -o seen
"""


@click.command(name="camera", epilog=EPILOG)
@click.argument("program")
@file_option(
    "--camera",
    required=True,
    help="The points that you marked in calibration pictures: a TOML file.",
)
@file_option(
    "--frames",
    help="Folder of pictures, or a video; without it the camera is only calibrated.",
)
@file_option("--views", help="Log of pan, tilt and zoom.")
@click.option("--fps", type=click.FloatRange(0.01, 1000.0), help="Frames a second.")
@click.option(
    "--starts",
    type=float,
    default=0.0,
    show_default=True,
    help="Time of the run at the first frame [s].",
)
@click.option(
    "--stills", type=click.IntRange(1, 10_000), default=12, show_default=True, help="Most stills."
)
@file_option("-o", "--output", help="Folder to write into.")
@form_option("full", "json")
@setting_options
@language_options
@color_option
@guarded
def command(
    program: str,
    camera: Path,
    frames: Path | None,
    views: Path | None,
    fps: float | None,
    starts: float,
    stills: int,
    output: Path | None,
    form: str,
    where: Where,
    entry: str | None,
    language: Language,
    color: str,
) -> None:
    """Draw the simulated robot over the frames of a real camera.

    Finds where the camera stands and how its lens sees from points that were marked in
    calibration pictures. Writes stills and a recording (.rrd) in which the virtual camera stands
    where the real one does, turns and zooms with it, and runs in time with the frames. A point that
    was marked wrongly is named and left out. Exit status 1 when the others do not fit one camera.
    """
    try:
        calibrated = _calibrated(camera, color)
    except ModuleNotFoundError as missing:
        if missing.name not in ("cv2", "scipy"):
            raise
        fail(NOT_INSTALLED, status=WRONG)
    status = _show(calibrated, as_json=form == "json")
    if frames is None:
        sys.exit(status)
    if output is None:
        fail("nothing says where stills and recording go", ("give a folder to `-o`",))
    run, name = run_of(program, where, entry, language, color)
    from vrts.base.diagnostic import Diagnostic
    from vrts.validate.camera.compare import Shown
    from vrts.validate.camera.frames import open_frames

    opened = open_frames(frames, fps)
    if isinstance(opened, Diagnostic):
        _refuse(opened, color)
    shown = Shown(run, opened, _views(views, color), calibrated, starts)
    _write(shown, name, stills, output, color)
    sys.exit(status)


def _calibrated(path: Path, color: str) -> "Calibrated":
    from vrts.base.diagnostic import Diagnostic
    from vrts.pipeline.files import read_toml_source
    from vrts.validate.camera.calibrate import calibrate
    from vrts.validate.camera.calibration_file import read_marked
    from vrts.validate.camera.wrong_marks import told

    marked = read_marked(read_toml_source(path))
    found = calibrate(marked)
    if isinstance(found, Diagnostic):
        _refuse(found, color)
    show_diagnostics(told(marked, found.left_out), color)
    return found


def _views(path: Path | None, color: str) -> "Views":
    from vrts.base.diagnostic import Diagnostic
    from vrts.pipeline.files import read_bytes, shown
    from vrts.validate.camera.views import STILL, read_views

    if path is None:
        return STILL
    found = read_views(read_bytes(path), shown(path))
    if isinstance(found, Diagnostic):
        _refuse(found, color)
    return found


def _show(found: "Calibrated", *, as_json: bool) -> int:
    """Print a camera; return the exit status: whether the marks agree with it."""
    from vrts.validate.camera.summary import GOOD_PX, camera_json, camera_text

    if as_json:
        from vrts.report.formats.json_text import json_text

        out(json_text(camera_json(found)))
    else:
        out(camera_text(found))
    if found.rms_px > GOOD_PX:
        say(
            f"the marks are {found.rms_px:.2f} px off, more than {GOOD_PX} px:"
            " look for a point that was mistaken, or a sign of pan or tilt"
        )
        return WRONG
    return HOLDS


def _write(shown: "Shown", name: str, most: int, output: Path, color: str) -> None:
    from vrts.validate.camera.compare import record, stills
    from vrts.validate.camera.frames import WrongFrames
    from vrts.validate.camera.summary import camera_text

    try:
        found = stills(shown, most)
    except WrongFrames as wrong:
        _refuse(wrong.diagnostic, color)
    output.mkdir(parents=True, exist_ok=True)
    for still in found:
        write_file(output / f"frame-{still.number:04d}.png", still.png)
    say(f"wrote {len(found)} stills into {output}")
    try:
        record(shown, name, camera_text(shown.calibrated), output / "camera.rrd")
    except ModuleNotFoundError as missing:
        if missing.name != "rerun":
            raise
        warn("recordings need the package rerun-sdk, which is not installed; the stills are there")
        return
    except WrongFrames as wrong:
        _refuse(wrong.diagnostic, color)
    say(f"wrote {output / 'camera.rrd'}")


def _refuse(diagnostic: "Diagnostic", color: str) -> NoReturn:
    show_diagnostics([diagnostic], color)
    sys.exit(WRONG)
