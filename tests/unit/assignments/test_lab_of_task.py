"""A task in a lab: marks count there and nowhere else, and the lab is packed with the task."""

import io
import zipfile
from pathlib import Path

import pytest

from vrts.assignments.pack import read_zip, staff_zip, student_zip
from vrts.assignments.packed import setting_of
from vrts.assignments.task_folder import read_folder
from vrts.pipeline.files import CHECKOUT, CannotRead
from vrts.pipeline.refused import Refused
from vrts.pipeline.scenes import load_scene
from vrts.pipeline.settings import load_task, setting_for

TASK = """[task]
scene = "cans-on-bases"
lab = "lab.toml"
[[goal]]
object = "can1"
on = "base2"
[time]
reference_s = 10.6
"""
LAB = '[lab]\ntitle = "Room 112"\n[lab.table]\ntop_z_mm = -310\n'


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """Return the folder of a task in a lab."""
    home = tmp_path / "task"
    home.mkdir()
    (home / "task.toml").write_text(TASK)
    (home / "lab.toml").write_text(LAB)
    return home


def low(folder: Path, text: str) -> Path:
    other = folder.parent / "other.toml"
    other.write_text(text)
    return other


def stamps(folder: Path, lab: Path | None) -> list[str]:
    return [d.rule.code for d in load_task(folder, lab=lab).stamps]


def test_the_lab_of_a_task_counts(folder: Path) -> None:
    setting = load_task(folder)
    assert setting.stamps == ()
    assert setting.scene.title.endswith(", in Room 112")
    assert setting.scene.body("can1").X_WO.translation[2] == pytest.approx(-0.310)
    assert setting.task is not None
    plain = load_scene("cans-on-bases").scene
    assert setting.scene.digest != plain.digest


def test_another_lab_is_a_modified_scene_and_a_copy_is_none(folder: Path) -> None:
    other = low(folder, LAB.replace("-310", "-320"))
    assert stamps(folder, other) == ["V671"]
    (stamp,) = load_task(folder, lab=other).stamps
    assert stamp.headline == "modified scene: this mark does not count"
    assert "in Room 112" in stamp.notes[0]
    assert stamps(folder, low(folder, LAB)) == []
    (folder / "task.toml").write_text(TASK.replace('lab = "lab.toml"\n', ""))
    assert stamps(folder, folder / "lab.toml") == ["V671"]


def test_a_program_beside_the_task_is_verified_in_its_lab(folder: Path) -> None:
    found = setting_for(folder / "mine.v2")
    assert found is not None
    assert found.scene.digest == load_task(folder).scene.digest


def test_hidden_scenes_are_in_the_lab_too_and_say_when_marks_do_not_count(folder: Path) -> None:
    (folder / "staff" / "scenes").mkdir(parents=True)
    text = (CHECKOUT / "scenes" / "cans-on-bases" / "scene.toml").read_text()
    (folder / "staff" / "scenes" / "far.toml").write_text(
        text.replace("[800, -450]", "[820, -450]")
    )
    (variant,) = load_task(folder, staff=True).variants
    assert variant.scene.body("can1").X_WO.translation == pytest.approx((0.820, -0.450, -0.310))
    assert [d.rule.code for d in variant.stamps] == ["V678"]
    other = low(folder, LAB.replace("-310", "-320"))
    (variant,) = load_task(folder, staff=True, lab=other).variants
    assert [d.rule.code for d in variant.stamps] == ["V671", "V678"]


def test_the_lab_is_packed_and_a_changed_one_is_stamped(folder: Path, tmp_path: Path) -> None:
    files = read_folder(folder)
    assert (files.lab, files.scene) == ("lab.toml", "cans-on-bases/scene.toml")
    data = student_zip(files, 0)
    packed = setting_of(read_zip(data))
    assert packed.stamps == ()
    assert packed.scene.digest == load_task(folder).scene.digest
    assert setting_of(read_zip(staff_zip(files, 0))).scene.digest == packed.scene.digest
    with zipfile.ZipFile(io.BytesIO(data)) as archive:
        archive.extractall(tmp_path / "home")
    (tmp_path / "home" / "task" / "lab.toml").write_text(LAB.replace("-310", "-300"))
    assert stamps(tmp_path / "home" / "task", None) == ["V671"]


def test_a_lab_from_elsewhere_is_not_packed(folder: Path) -> None:
    low(folder, LAB)
    for named in ("../other.toml", "staff/lab.toml"):
        (folder / "staff").mkdir(exist_ok=True)
        (folder / "staff" / "lab.toml").write_text(LAB)
        (folder / "task.toml").write_text(TASK.replace('"lab.toml"', f'"{named}"'))
        with pytest.raises(CannotRead, match="lab"):
            read_folder(folder)


def test_a_packed_task_takes_no_lab_from_elsewhere(folder: Path) -> None:
    files = read_folder(folder)
    for named in ("../../other.toml", "/etc/hostname", "README.md"):
        files.public["task.toml"] = TASK.replace('"lab.toml"', f'"{named}"').encode()
        with pytest.raises(Refused) as refused:
            setting_of(read_zip(student_zip(files, 0)))
        assert [d.headline for d in refused.value.diagnostics] == [
            "the packed task has no lab of its own"
        ]


def test_a_lab_that_is_not_there_or_no_text_is_told(folder: Path) -> None:
    (folder / "lab.toml").unlink()
    with pytest.raises(CannotRead, match=r"lab\.toml"):
        load_task(folder)
    (folder / "task.toml").write_text(TASK.replace('"lab.toml"', "3"))
    with pytest.raises(Refused) as refused:
        load_task(folder)
    assert [d.rule.code for d in refused.value.diagnostics] == ["V604"]
