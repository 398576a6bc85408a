"""Changes of task, scene and lab on disk are noticed, each of them."""

import os
from pathlib import Path

from tests.unit.lsp.in_a_cell import TASK, setting
from vrts.lsp.documents.setting_files import setting_stamp


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
