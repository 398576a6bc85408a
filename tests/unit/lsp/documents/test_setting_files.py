"""Changes of task, scene and lab on disk are noticed, each of them."""

import os
from pathlib import Path

from tests.places import ROOT
from vrts.base.oat import pose_from_components
from vrts.lsp.documents.setting_files import setting_stamp
from vrts.lsp.runs.reaching import reach_text

TASK = """[task]
title = "a"
scene = "cell/scene.toml"
[time]
reference_s = 10
[[goal]]
object = "can1"
on = "base2"
"""


def setting(folder: Path) -> Path:
    scene = (ROOT / "scenes" / "cans-on-bases" / "scene.toml").read_text("utf-8")
    (folder / "cell").mkdir()
    (folder / "cell" / "scene.toml").write_text(scene, "utf-8")
    (folder / "task.toml").write_text(TASK, "utf-8")
    return folder / "a.v2"


def test_reach_is_that_of_the_scene_as_it_is_now(tmp_path: Path) -> None:
    program, scene = str(setting(tmp_path)), tmp_path / "cell" / "scene.toml"
    X_WT = pose_from_components(900.0, 0.0, 0.0, 90.0, 90.0, 0.0)
    text = scene.read_text("utf-8")
    near = reach_text(program, X_WT)
    assert near.startswith("reachable")
    scene.write_text(text.replace("puma761", "puma560"), "utf-8")  # the task stays as it is
    assert reach_text(program, X_WT) != near
    scene.write_text("nonsense", "utf-8")
    assert reach_text(program, X_WT) == ""
    scene.write_text(text, "utf-8")
    assert reach_text(program, X_WT) == near


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
