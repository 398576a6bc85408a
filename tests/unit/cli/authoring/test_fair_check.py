"""`vrts task check` with variants: what falls out is named, and its remedy can be pasted."""

import shutil
from pathlib import Path

import pytest

from tests.places import ROOT
from tests.support_commands import Said, vrts_text
from vrts.assignments.variants.key import place_of_handed

LAB = ROOT / "examples" / "08-own-numbers" / "lab1"
VARIES = """[variants]
assignment = "test"
[[variants.vary]]
name = "can1"
set = "scene.objects.can1.at_mm"
choices = [[780, -440], [720, -500], [1040, 170]]
[[variants.vary]]
name = "can2"
set = "scene.objects.can2.at_mm"
choices = [[780, 440], [840, 500]]
"""
NAMES = ("Ann", "Ben", "Cleo", "Dan", "Eve", "Fay", "Guy", "Hal", "Ida")


@pytest.fixture
def home(tmp_path: Path) -> Path:
    shutil.copytree(LAB, tmp_path / "lab")
    task = tmp_path / "lab" / "task.toml"
    task.write_text(task.read_text("utf-8").partition("[variants]")[0] + VARIES, "utf-8")
    rows = [f"Participant {k},{name},{name}@x.org,," for k, name in enumerate(NAMES, 1)]
    header = "Identifier,Full name,Email address,Status,Grade"
    (tmp_path / "class.csv").write_text("\n".join((header, *rows, "")), "utf-8")
    (tmp_path / "lab.key").write_text("6" * 64 + "\n", "utf-8")
    return tmp_path


def checked(home: Path) -> Said:
    words = ("task", "check", "lab", "--roster", "class.csv", "--key", "lab.key")
    return vrts_text(*words, cwd=home)


@pytest.mark.thorough
def test_what_falls_out_is_named_and_its_remedy_can_be_pasted(home: Path) -> None:
    said = checked(home)
    assert said.returncode == 1, said.stderr
    assert "`can1` is inside `base2` at the start" in said.stderr
    assert "which `Eve`, `Fay` would get, falls out" in said.stderr
    remedy = "[[variants.without]]\ncan1 = [[1040, 170]]\n"
    assert remedy in said.stdout
    with (home / "lab" / "task.toml").open("a", encoding="utf-8") as file:
        file.write(f"\n{remedy}")
    after = checked(home)
    assert after.returncode == 0, after.stderr
    assert "4 can be done and are equally hard; 0 fall out" in after.stdout
    assert "9 students of the list have" in after.stdout


@pytest.mark.thorough
def test_what_was_handed_out_is_asked_for_before_anything_is_drawn_again(home: Path) -> None:
    task, key = home / "lab" / "task.toml", home / "lab.key"
    task.write_text(task.read_text("utf-8").replace(", [1040, 170]]", "]"), "utf-8")
    words = ("lab", "--roster", "class.csv", "--key", "lab.key")
    handed = vrts_text("task", "variants", *words, "--untried", "-o", "zips", cwd=home)
    assert handed.returncode == 0, handed.stderr
    task.write_text(task.read_text("utf-8").replace("[720, -500]", "[720, -490]"), "utf-8")
    changed = checked(home)
    assert changed.returncode == 1
    assert "`[variants]` was changed: what was handed out to " in changed.stderr
    place_of_handed(key).unlink()
    for said in (checked(home), vrts_text("task", "check", "lab", "--key", "lab.key", cwd=home)):
        assert said.returncode == 0, said.stderr
        assert "warning[V779 handed-out-unknown]" in said.stderr


def test_a_list_of_a_class_is_for_variants_and_has_to_be_there(home: Path) -> None:
    missing = vrts_text("task", "check", "lab", "--roster", "none.csv", cwd=home)
    assert missing.returncode == 2
    assert "cannot read `none.csv`" in missing.stderr
    task = home / "lab" / "task.toml"
    task.write_text(task.read_text("utf-8").partition("[variants]")[0], "utf-8")
    plain = vrts_text("task", "check", "lab", "--roster", "class.csv", cwd=home)
    assert plain.returncode == 2
    assert "`--roster` is for a task with variants" in plain.stderr
    plain = vrts_text("task", "check", "lab", "--key", "lab.key", cwd=home)
    assert "`--key` is for a task with variants" in plain.stderr
