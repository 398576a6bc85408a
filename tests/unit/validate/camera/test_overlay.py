"""The simulated robot lies over the real one in frames of a known camera.

The frames are drawn by the stills' own renderer, which has nothing in common with the overlay.
"""

import math
import subprocess
import sys
from pathlib import Path

import cv2
import numpy as np
import numpy.typing as npt
import pytest

from tests.support_commands import Said, vrts_text
from tests.support_programs import ROOT
from tests.unit.validate.camera.test_calibrate import points
from vrts.base.diagnostic import Diagnostic
from vrts.engine.run import Run
from vrts.pipeline.assess import assess
from vrts.pipeline.request import NO_CHECKS
from vrts.pipeline.requesting import request_for
from vrts.report.picture.camera import Camera
from vrts.report.picture.placing import place_moving
from vrts.report.picture.projection import project
from vrts.report.picture.raster import rasterise
from vrts.report.picture.still import still
from vrts.validate.camera.model import PtzCamera, View
from vrts.validate.camera.overlay import simulated
from vrts.validate.camera.views import Views, read_views

SIZE = (640, 400)
EYE = (2.7, -2.2, 0.8)
HOME = (0.6, 0.0, 0.1)
FIELD = math.radians(38.0)  # at zoom 1
EXAMPLE = ROOT / "examples" / "01-cans-on-bases" / "solution.v2"
FPS = 5.0


def level_mount() -> PtzCamera:
    """Return the true camera: its mount is upright and looks level, so panning keeps it so."""
    forward = np.subtract(HOME, EYE)
    forward[2] = 0.0
    forward /= np.linalg.norm(forward)
    right = np.cross(forward, (0.0, 0.0, 1.0))
    mount = np.stack([right, np.cross(forward, right), forward])
    focal = SIZE[1] / 2 / math.tan(FIELD / 2)
    centre = ((SIZE[0] - 1) / 2, (SIZE[1] - 1) / 2)
    return PtzCamera(np.array(EYE), mount, focal, centre, (0.0, 0.0), SIZE)


TRUE = level_mount()
LOOKS = tuple(
    View(math.radians(pan), math.radians(tilt), zoom)
    for pan, tilt, zoom in ((0, -12, 1.0), (6, -15, 1.25), (-5, -9, 0.9))
)


def still_camera(view: View) -> Camera:
    """Return the camera of the stills for a view of the true one."""
    ahead = TRUE.axes(view)[2]
    height = 2 * math.atan(math.tan(FIELD / 2) / view.zoom)
    x, y, z = np.add(EYE, ahead)
    return Camera(EYE, (float(x), float(y), float(z)), height)


@pytest.fixture(scope="module")
def run() -> Run:
    found = assess(request_for(EXAMPLE, checks=NO_CHECKS)).run
    assert found is not None
    return found


def silhouette(run: Run, time_s: float, view: View) -> npt.NDArray[np.bool_]:
    """Return what the stills' rasteriser draws of what moves, True where it is."""
    state = run.at(time_s)
    placed = place_moving(
        run.scene, state.configuration, hand_opening=state.hand_opening, poses=state.poses
    )
    seen = project(placed, still_camera(view), *SIZE)
    return rasterise(seen.screen, seen.near, *SIZE) != 0


@pytest.mark.parametrize("view", LOOKS)
def test_the_overlay_covers_what_another_renderer_draws(run: Run, view: View) -> None:
    for time_s in (0.0, 3.1, 7.4):
        canvas = np.zeros((SIZE[1], SIZE[0], 3), np.uint8)
        mask = simulated(canvas, run, time_s, TRUE, view) > 0
        other = silhouette(run, time_s, view)
        assert other.sum() > 3000
        assert (mask & other).sum() / (mask | other).sum() > 0.97


def frame(run: Run, time_s: float, view: View) -> bytes:
    state = run.at(time_s)
    return still(
        run.scene,
        state.configuration,
        hand_opening=state.hand_opening,
        poses=state.poses,
        camera=still_camera(view),
        size=SIZE,
        samples=1,
    )


def write_case(run: Run, folder: Path) -> None:
    """Write frames of a camera that moves and zooms, its log, and marks in three of its views."""
    (folder / "frames").mkdir()
    rows = ["time_s;pan_deg;tilt_deg;zoom"]
    for k in range(8):
        pan, tilt, zoom = -4.0 + k, -12.0 + 0.5 * k, 1.0 + 0.05 * k
        rows.append(f"{k / FPS};{pan};{tilt};{zoom}".replace(".", ","))
        view = View(math.radians(pan), math.radians(tilt), zoom)
        (folder / "frames" / f"shot{k}.png").write_bytes(frame(run, 2.0 + k / FPS, view))
    (folder / "views.csv").write_text("\n".join(rows))
    rng = np.random.default_rng(3)
    places = points(20)
    text = [f"[camera]\nsize_px = [{SIZE[0]}, {SIZE[1]}]\nfit_distortion = false\n\n[points_mm]"]
    text += [f"{name} = [{', '.join(f'{1e3 * v:.4f}' for v in p)}]" for name, p in places.items()]
    for view in LOOKS:
        seen = TRUE.seen(np.array(list(places.values())), view) + rng.normal(0, 0.2, (20, 2))
        text.append(
            f"\n[[pictures]]\npan_deg = {math.degrees(view.pan):.6f}\n"
            f"tilt_deg = {math.degrees(view.tilt):.6f}\nzoom = {view.zoom}\n[pictures.seen_px]"
        )
        text += [f"{n} = [{u:.3f}, {v:.3f}]" for n, (u, v) in zip(places, seen, strict=True)]
    (folder / "camera.toml").write_text("\n".join(text))


def called(folder: Path, *words: str) -> Said:
    whole = ("validate", EXAMPLE, "--scene", "cans-on-bases", "--camera", folder / "camera.toml")
    return vrts_text(*whole, *words, cwd=folder)


@pytest.mark.thorough
def test_the_command_draws_the_robot_over_frames_of_a_camera_that_moves(
    run: Run, tmp_path: Path
) -> None:
    write_case(run, tmp_path)
    frames = ("--frames", str(tmp_path / "frames"), "--views", str(tmp_path / "views.csv"))
    done = called(tmp_path, *frames, "--fps", "5", "--starts", "2", "--stills", "3", "-o", "out")
    assert done.returncode == 0, done.stderr
    assert "reprojection error" in done.stdout
    out = tmp_path / "out"
    names = sorted(file.name for file in out.glob("*.png"))
    assert names == ["frame-0000.png", "frame-0004.png", "frame-0007.png"]
    rerun = Path(sys.executable).with_name("rerun")
    checked = subprocess.run([rerun, "rrd", "verify", out / "camera.rrd"], capture_output=True)
    assert checked.returncode == 0, checked.stderr
    for name in names:  # the outline lies where the robot of the frame ends
        k = int(name[6:10])
        before = cv2.imread(str(tmp_path / "frames" / f"shot{k}.png"))
        after = cv2.imread(str(out / name))
        assert before is not None
        assert after is not None
        changed = (np.abs(after.astype(int) - before).max(axis=2) > 60).sum()
        assert changed > 200


@pytest.mark.thorough
def test_frames_out_of_the_run_of_another_size_or_none_are_told(run: Run, tmp_path: Path) -> None:
    write_case(run, tmp_path)
    frames = ("--frames", str(tmp_path / "frames"))
    late = called(tmp_path, *frames, "--starts", "500", "-o", "out")
    assert (late.returncode, "V906" in late.stderr) == (1, True)
    none = called(tmp_path, "--frames", str(tmp_path / "nowhere"), "-o", "out")
    assert (none.returncode, "V904" in none.stderr) == (1, True)
    small = np.zeros((10, 10, 3), np.uint8)
    cv2.imwrite(str(tmp_path / "frames" / "shot0.png"), small)
    other = called(tmp_path, *frames, "--starts", "1", "-o", "out")
    assert (other.returncode, "V905" in other.stderr) == (1, True)
    (tmp_path / "frames" / "shot0.png").write_bytes(b"half of it")
    broken = called(tmp_path, *frames, "--starts", "1", "-o", "out")
    assert (broken.returncode, "V907" in broken.stderr) == (1, True)
    assert "`shot0.png` cannot be read" in broken.stderr
    assert not (tmp_path / "out").exists()


@pytest.mark.thorough
def test_a_video_is_read_as_pictures_are(run: Run, tmp_path: Path) -> None:
    write_case(run, tmp_path)
    codec = cv2.VideoWriter.fourcc(*"MJPG")
    video = cv2.VideoWriter(str(tmp_path / "film.avi"), codec, FPS, SIZE)
    for k in range(8):
        picture = cv2.imread(str(tmp_path / "frames" / f"shot{k}.png"))
        assert picture is not None
        video.write(picture)
    video.release()
    done = called(
        tmp_path,
        *("--frames", str(tmp_path / "film.avi"), "--views", str(tmp_path / "views.csv")),
        *("--starts", "2", "--stills", "2", "-o", "out"),
    )
    assert done.returncode == 0, done.stderr
    assert len(list((tmp_path / "out").glob("*.png"))) == 2


def test_views_between_rows_are_in_proportion_and_bad_ones_are_told() -> None:
    found = read_views(b"time_s,pan_deg,zoom\n0,0,1\n2,10,3\n", "views.csv")
    assert isinstance(found, Views)
    view = found.at(1.0)
    assert view.pan == pytest.approx(math.radians(5))
    assert (view.tilt, view.zoom) == (0.0, 2.0)
    for text in (b"pan_deg\n3\n", b"time_s,zoom\n0,1\n0,2\n", b"time_s,zoom\n0,0\n"):
        told = read_views(text, "views.csv")
        assert isinstance(told, Diagnostic)
        assert told.rule.code == "V903"
