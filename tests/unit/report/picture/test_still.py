"""Stills show what is there, the same with and without what is kept of earlier ones."""

import struct
import zlib
from collections.abc import Mapping

import numpy as np
import numpy.typing as npt
import pytest

from vrts.base.pose import Pose, translation
from vrts.pipeline.scenes import load_scene
from vrts.report.picture import backdrop
from vrts.report.picture.camera import Camera
from vrts.report.picture.still import still
from vrts.robots.model import Configuration
from vrts.scene.model import Scene

SIZE = (160, 120)
HIGH: Configuration = (0.2, -0.9, 2.4, 0.1, 0.4, -0.3)
LOW: Configuration = (-0.3, -0.5, 2.6, 0.0, 0.9, 0.4)
Pixels = npt.NDArray[np.uint8]


@pytest.fixture(scope="module")
def scene() -> Scene:
    return load_scene("cans-on-bases").scene


@pytest.fixture(autouse=True)
def nothing_kept() -> None:
    forget()


def forget() -> None:
    for kept in (backdrop.stage, backdrop.view, backdrop.backdrop):
        kept.cache_clear()


def pixels(png: bytes) -> Pixels:
    """Read a PNG as this program writes it."""
    width, height = struct.unpack(">II", png[16:24])
    data = b""
    at = 8
    while at < len(png):
        (length,) = struct.unpack(">I", png[at : at + 4])
        if png[at + 4 : at + 8] == b"IDAT":
            data += png[at + 8 : at + 8 + length]
        at += 12 + length
    rows = np.frombuffer(zlib.decompress(data), np.uint8).reshape(height, 1 + 3 * width)
    assert (rows[:, 0] == 1).all()
    return np.cumsum(rows[:, 1:].reshape(height, width, 3), axis=1, dtype=np.uint8)


def moments(scene: Scene) -> list[dict[str, object]]:
    X = scene.body("can1").X_WO
    moved: Mapping[str, Pose] = {"can1": translation(0.0, 0.1, 0.2) @ X}
    point = X.translation
    return [
        {"configuration": HIGH},
        {"configuration": LOW, "hand_opening": 0.05, "poses": moved},
        {"configuration": LOW, "highlight": ("can1", "base1"), "marker": point},
        {"configuration": HIGH, "highlight": ("robot",), "marker": point},
        {"configuration": HIGH},
    ]


def draw(scene: Scene, moment: dict[str, object]) -> bytes:
    return still(scene, size=SIZE, **moment)  # pyright: ignore[reportArgumentType]


def test_a_still_is_the_same_with_and_without_what_is_kept(scene: Scene) -> None:
    after_others = [draw(scene, moment) for moment in moments(scene)]
    assert backdrop.stage.cache_info().hits > 0
    assert backdrop.backdrop.cache_info().hits > 0
    alone: list[bytes] = []
    for moment in moments(scene):
        forget()
        alone.append(draw(scene, moment))
    assert after_others == alone
    assert after_others[0] == after_others[4] != after_others[1]


def test_pictures_from_near_the_same_place_share_what_never_moves(scene: Scene) -> None:
    x, y, z = scene.body("base1").X_WO.translation
    for k in range(4):
        still(scene, HIGH, size=SIZE, marker=(round(x, 1) + 0.002 * k, y, z), highlight=("base1",))
    assert backdrop.view.cache_info().misses == 1


def test_only_what_moved_and_its_shadow_change(scene: Scene) -> None:
    camera = Camera(eye=(2.6, -1.75, 0.75), look_at=(0.88, -0.16, -0.13))
    before = pixels(still(scene, HIGH, size=SIZE, camera=camera))
    X = scene.body("can2").X_WO
    poses = {"can2": translation(0.0, 0.0, 0.06) @ X}
    after = pixels(still(scene, HIGH, size=SIZE, camera=camera, poses=poses))
    changed = (before != after).any(axis=2)
    assert 0 < changed.mean() < 0.05


def test_bodies_in_contact_are_red(scene: Scene) -> None:
    point = scene.body("base1").X_WO.translation
    plain = pixels(still(scene, HIGH, size=SIZE, marker=point)).astype(int)
    alarmed = pixels(still(scene, HIGH, size=SIZE, marker=point, highlight=["base1"])).astype(int)
    redder = alarmed[:, :, 0] - alarmed[:, :, 2] > plain[:, :, 0] - plain[:, :, 2] + 40
    assert redder.mean() > 0.01


def test_a_marker_is_in_the_middle_of_its_picture(scene: Scene) -> None:
    point = scene.body("can1").X_WO.translation
    shown = pixels(still(scene, HIGH, size=(480, 360), marker=point)).astype(int)
    ring = (shown[:, :, 0] > 215) & (shown[:, :, 1] < 45) & (shown[:, :, 2] < 60)
    row, column = (float(np.mean(axis)) for axis in np.nonzero(ring))
    assert abs(row - 180) < 30
    assert abs(column - 240) < 30


def test_edges_are_smooth(scene: Scene) -> None:
    camera = Camera(eye=(3.35, -2.75, 1.2), look_at=(0.5, -0.02, 0.1))
    rough = pixels(still(scene, HIGH, size=SIZE, camera=camera, samples=1)).astype(int)
    smooth = pixels(still(scene, HIGH, size=SIZE, camera=camera)).astype(int)
    fine = pixels(still(scene, HIGH, size=(320, 240), camera=camera)).astype(float)
    mean = fine.reshape(120, 2, 160, 2, 3).mean(axis=(1, 3))
    assert np.abs(smooth - mean).mean() < 0.75 * np.abs(rough - mean).mean()


def test_what_reaches_an_edge_is_where_a_wider_picture_shows_it(scene: Scene) -> None:
    camera = Camera(eye=(1.75, -1.35, 0.45), look_at=(0.86, -0.25, -0.14))
    narrow = pixels(still(scene, HIGH, size=(120, 120), camera=camera))
    middle = pixels(still(scene, HIGH, size=(240, 120), camera=camera))[:, 60:180]
    differs = (np.abs(narrow.astype(int) - middle) > 8).any(axis=2)
    assert differs.mean() < 0.005
