"""The section `[robot]`: robots by name and by description, and every way to get it wrong."""

import os
from pathlib import Path

import pytest

from tests.places import ROOT
from vrts.base.diagnostic import Diagnostic
from vrts.base.source import SourceFile
from vrts.robots.catalog import names, robot
from vrts.robots.model import SerialArm
from vrts.robots.urdf import universal
from vrts.scene.model import Scene
from vrts.scene.reading.robot_section import MOST_URDF
from vrts.scene.reading.scene_file import read_scene

URDF_SCENE = ROOT / "scenes" / "one-can-urdf"
TEXT = (URDF_SCENE / "scene.toml").read_text("utf-8")
ARM = (URDF_SCENE / "arm.urdf").read_text("utf-8")


def read(text: str, folder: Path | None) -> tuple[Scene | None, tuple[Diagnostic, ...]]:
    return read_scene(SourceFile("scene.toml", text), folder)


def only(text: str, folder: Path | None) -> Diagnostic:
    """Return the one error of a scene."""
    scene, diagnostics = read(text, folder)
    assert scene is None
    (found,) = (diagnostic for diagnostic in diagnostics if diagnostic.is_error)
    assert found.primary is not None
    return found


def here(tmp_path: Path, urdf: str = ARM) -> Path:
    (tmp_path / "arm.urdf").write_text(urdf, "utf-8")
    return tmp_path


@pytest.mark.parametrize("name", names())
def test_every_robot_of_the_catalog_can_be_named(name: str) -> None:
    scene, diagnostics = read(f'[robot]\nname = "{name}"\n', None)
    assert diagnostics == ()
    assert scene is not None
    assert scene.robot == robot(name)
    assert scene.robot.arm.links[0].joint == 0
    floor = scene.body("floor").X_WO.translation[2]
    assert floor == -scene.robot.arm.shoulder_height


def test_a_described_robot_is_what_its_file_and_section_say() -> None:
    scene, diagnostics = read(TEXT, URDF_SCENE)
    assert diagnostics == ()
    assert scene is not None
    arm = scene.robot.arm
    assert isinstance(arm, SerialArm)
    assert (arm.name, arm.title) == ("small_arm", "A small arm with an offset wrist")
    assert arm.shoulder_height == pytest.approx(0.6)
    assert arm.linear_speed == pytest.approx(0.5)


def test_a_mark_is_for_one_robot_only(tmp_path: Path) -> None:
    first, _ = read(TEXT, here(tmp_path))
    second, _ = read(TEXT, here(tmp_path, ARM.replace('upper="2.9"', 'upper="2.8"')))
    assert first is not None
    assert second is not None
    assert first.digest != second.digest


OUTSIDE = ["../arm.urdf", "/etc/passwd", "a/../../arm.urdf", "C:\\\\arm.urdf", "~/arm.urdf", ""]


@pytest.mark.parametrize("name", OUTSIDE)
def test_names_that_lead_out_of_the_folder_are_refused(tmp_path: Path, name: str) -> None:
    (tmp_path / "arm.urdf").write_text(ARM)
    inner = tmp_path / "scene"
    inner.mkdir()
    found = only(TEXT.replace("arm.urdf", name), inner)
    assert found.rule.code == "V421"
    assert found.primary is not None
    assert "own folder" in found.primary.text


def test_links_that_lead_out_of_the_folder_are_refused(tmp_path: Path) -> None:
    (tmp_path / "secret.urdf").write_text(ARM)
    inner = tmp_path / "scene"
    inner.mkdir()
    os.symlink(tmp_path / "secret.urdf", inner / "arm.urdf")
    found = only(TEXT, inner)
    assert found.rule.code == "V421"
    assert found.primary is not None
    assert "outside" in found.primary.text


def test_missing_large_and_unknown_files_are_refused(tmp_path: Path) -> None:
    assert only(TEXT, tmp_path).rule.code == "V421"
    assert only(TEXT, None).rule.code == "V421"
    found = only(TEXT, here(tmp_path, " " * (MOST_URDF + 1)))
    assert found.rule.code == "V421"
    assert found.primary is not None
    assert "1,000,000" in found.primary.text


def test_a_description_at_fault_is_one_error_with_its_line(tmp_path: Path) -> None:
    found = only(TEXT, here(tmp_path, ARM.replace('type="revolute"', 'type="prismatic"', 1)))
    assert found.rule.code == "V422"
    assert found.primary is not None
    assert found.primary.span.text == '"arm.urdf"'
    assert "`prismatic`" in found.primary.text
    line = found.data["line"]
    assert isinstance(line, int)
    assert "joint_1" in ARM.splitlines()[line - 1]
    assert found.notes == (f"in arm.urdf, line {line}",)


def test_meshes_are_looked_for_beside_the_description(tmp_path: Path) -> None:
    box = '<box size="0.12 0.08 0.56"/>'
    mesh = '<mesh filename="package://some_arm/meshes/upper.stl"/>'
    folder = here(tmp_path, ARM.replace(box, mesh))
    found = only(TEXT, folder)
    assert found.rule.code == "V421"
    assert found.primary is not None
    assert "meshes/upper.stl" in found.primary.text
    (folder / "meshes").mkdir()
    corners = [(0, 0, 0), (0.1, 0, 0), (0, 0.1, 0), (0, 0, 0.4)]
    faces = [(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)]
    vertices = [f"vertex {' '.join(map(str, corners[k]))}" for face in faces for k in face]
    (folder / "meshes" / "upper.stl").write_text("\n".join(["solid upper", *vertices]))
    scene, diagnostics = read(TEXT, folder)
    assert diagnostics == ()
    assert scene is not None
    before, _ = read(TEXT, URDF_SCENE)
    assert before is not None
    assert scene.robot.arm.links[2].pieces != before.robot.arm.links[2].pieces


def test_two_robots_are_one_too_many() -> None:
    found = only(TEXT.replace('title = "A small', 'name = "ur5"\ntitle = "A small'), URDF_SCENE)
    assert found.rule.code == "V424"


def test_a_robot_needs_a_configuration_to_be_ready_in() -> None:
    text = TEXT.replace("ready_deg", "redy_deg")
    assert only(text, URDF_SCENE).rule.code == "V602"  # and not "missing" as well


def test_a_robot_that_is_not_installed(monkeypatch: pytest.MonkeyPatch) -> None:
    universal.robot.cache_clear()
    monkeypatch.setattr(universal, "WHEEL", "no-such-package")
    found = only('[robot]\nname = "ur5"\n', None)
    universal.robot.cache_clear()
    assert found.rule.code == "V423"
    assert found.help == ("pip install example-robot-data",)
