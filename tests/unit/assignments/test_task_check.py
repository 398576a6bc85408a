"""Hidden scenes: programs are run in each of them, and the lowest mark counts."""

import shutil
from pathlib import Path

import pytest

from vrts.assignments.pack import read_zip, staff_zip, student_zip
from vrts.assignments.packed import setting_of
from vrts.assignments.task_check import check_task
from vrts.assignments.task_folder import read_folder
from vrts.marking.submission.one import Order, Wanted, mark
from vrts.pipeline.files import CHECKOUT
from vrts.pipeline.settings import load_task

EXAMPLE = CHECKOUT / "examples" / "01-cans-on-bases"
SCENE = (CHECKOUT / "scenes" / "cans-on-bases" / "scene.toml").read_text()
POST = """
[objects.post]
kind = "base"
at_mm = [920, 30]
on = "table"
size_mm = [40, 40, {height}]
"""


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """Return the first example with a post in a hidden scene."""
    lab = tmp_path / "lab"
    (lab / "staff" / "scenes").mkdir(parents=True)
    shutil.copy(EXAMPLE / "task.toml", lab)
    shutil.copy(EXAMPLE / "solution.v2", lab / "staff")
    (lab / "staff" / "scenes" / "post.toml").write_text(SCENE + POST.format(height=390))
    return lab


def test_a_program_that_fails_in_a_hidden_scene_gets_the_mark_of_that_scene(folder: Path) -> None:
    program = Order("anna", "anna.v2", (folder / "staff" / "solution.v2").read_bytes())
    public, whole = load_task(folder), load_task(folder, staff=True)
    assert (public.hidden, public.variants, whole.hidden) == (0, (), 1)
    good, poor = (mark(program, setting, Wanted()).assessment for setting in (public, whole))
    assert good.grade is not None
    assert poor.grade is not None
    assert good.grade.mark == 10
    assert poor.grade.mark < 8
    assert "`post`" in poor.grade.losses[0].sentence
    assert [d.rule.code for d in poor.findings if d.rule.code == "V678"] == ["V678"]


@pytest.mark.thorough
def test_the_reference_must_get_all_points_in_hidden_scenes_too(folder: Path) -> None:
    found = check_task(load_task(folder, staff=True), folder / "staff" / "solution.v2")
    assert not found.ready
    (finding,) = [d for d in found.findings if d.is_error]
    assert finding.rule.code == "V674"
    assert "in post" in finding.headline
    low = SCENE + POST.format(height=20)
    (folder / "staff" / "scenes" / "post.toml").write_text(low)
    assert check_task(load_task(folder, staff=True), folder / "staff" / "solution.v2").ready


def test_hidden_scenes_are_packed_for_the_staff_only(folder: Path) -> None:
    files = read_folder(folder)
    student = setting_of(read_zip(student_zip(files, 1)))
    staff = setting_of(read_zip(staff_zip(files, 1)))
    assert (student.variants, student.more) == ((), 1)
    assert [variant.scene.name for variant in staff.variants] == ["post"]
    assert staff.stamps == ()


def test_what_everything_is_worth_is_listed(folder: Path) -> None:
    with (folder / "staff" / "task.toml").open("w") as file:
        file.write('[[via]]\nname = "high"\nat_mm = [900, 30, 100]\n')
        file.write('[[rule]]\nmust_use = "MOVES"\npoints = 0.7\n')
    setting = load_task(folder, staff=True)
    listed = check_task(setting, None).worths
    points = [(float(worth.points), worth.what.split("`")[1]) for worth in listed[:4]]
    assert points[:3] == [(3.0, "can1"), (3.0, "can2"), (2.5, "high")]
    assert points[3][0] == 0.7
    assert [float(worth.points) for worth in listed[4:]] == [1.5, 1.5, 1.0, 5.0, 1.5]
