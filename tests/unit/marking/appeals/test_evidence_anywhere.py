"""A mark is reproduced wherever the task stood, and however it and its folder were named."""

import shutil
from pathlib import Path

import pytest

from tests.places import ROOT
from tests.support_commands import vrts_text

EXAMPLE = ROOT / "examples" / "01-cans-on-bases"


@pytest.mark.thorough
@pytest.mark.parametrize(
    ("folder", "inside", "task"),
    [
        ("Lab 1", True, "task.toml"),
        pytest.param("lab1", True, ".", marks=pytest.mark.thorough),
        pytest.param("lab1", False, "lab1/task.toml", marks=pytest.mark.thorough),
    ],
)
def test_evidence_of_a_task_with_its_own_scene(
    folder: str, inside: bool, task: str, tmp_path: Path
) -> None:
    lab = tmp_path / folder
    lab.mkdir()
    text = (EXAMPLE / "task.toml").read_text("utf-8")
    (lab / "task.toml").write_text(text.replace('scene = "cans-on-bases"', 'scene = "scene.toml"'))
    shutil.copy(ROOT / "scenes" / "cans-on-bases" / "scene.toml", lab)
    home = lab if inside else tmp_path
    shutil.copy(EXAMPLE / "submissions" / "hits-base.v2", home / "anna.v2")
    marked = vrts_text("grade", task, "anna.v2", "-o", "out", "--no-pages", cwd=home)
    assert marked.returncode == 0, marked.stderr
    assert vrts_text("grade", "evidence", "anna", "--from", "out", cwd=home).returncode == 0
    again = vrts_text("grade", "reproduce", "evidence-anna.zip", cwd=home)
    assert "anna: the same result, 7.0 of 10" in again.stdout, again.stdout
    assert again.returncode == 0
