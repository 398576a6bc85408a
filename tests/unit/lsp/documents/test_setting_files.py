"""Changes of task, scene and lab on disk are noticed, each of them."""

import os
from pathlib import Path

from tests.unit.lsp.in_a_cell import TASK, setting
from vrts.lsp.documents.setting_files import setting_stamp, task_file


def test_every_file_of_a_setting_counts(tmp_path: Path) -> None:
    program = str(setting(tmp_path))
    seen = {setting_stamp(program)}
    mesh = tmp_path / "cell" / "meshes" / "rim.stl"
    for number, path in enumerate((tmp_path / "scenario.toml", mesh, tmp_path / "task.toml")):
        path.parent.mkdir(exist_ok=True)
        path.write_text(TASK + "\n" * number, "utf-8")
        seen.add(setting_stamp(program))
    mesh.unlink()
    seen.add(setting_stamp(program))
    assert len(seen) == 5
    (tmp_path / "b.v2").write_text("; a program is no part of it", "utf-8")
    assert setting_stamp(program) in seen
    submission = str(tmp_path / "submissions" / "c.v2")
    assert setting_stamp(submission) == setting_stamp(program)


def test_without_a_task_there_is_no_setting(tmp_path: Path) -> None:
    program = str(tmp_path / "a.v2")
    assert setting_stamp(program) == ()
    assert setting_stamp("untitled:1") == setting_stamp(os.path.join("", "any"))
    (tmp_path / "task.toml").write_text("[[", "utf-8")
    assert len(setting_stamp(program)) == 1


def test_it_is_the_task_that_the_program_is_verified_by(tmp_path: Path) -> None:
    setting(tmp_path)
    deep = tmp_path / "work" / "anna"
    deep.mkdir(parents=True)
    assert task_file(str(deep / "a.v2")) == str(tmp_path / "task.toml")
    assert setting_stamp(str(deep / "a.v2")) == setting_stamp(str(tmp_path / "a.v2"))
    handed_in = tmp_path / "submissions" / "anna"
    handed_in.mkdir(parents=True)
    for folder in (deep, handed_in):
        (folder / "task.toml").write_text("# anna's own\n", "utf-8")
    assert task_file(str(handed_in / "a.v2")) == str(tmp_path / "task.toml")
    assert task_file(str(deep / "a.v2")) is None, "two may be meant"
