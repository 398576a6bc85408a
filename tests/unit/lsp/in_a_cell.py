"""A program with a task beside it, whose scene is a file of its own."""

from pathlib import Path

from tests.places import ROOT

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
    """Write task and scene; return where a program of the task would be."""
    scene = (ROOT / "scenes" / "cans-on-bases" / "scene.toml").read_text("utf-8")
    (folder / "cell").mkdir()
    (folder / "cell" / "scene.toml").write_text(scene, "utf-8")
    (folder / "task.toml").write_text(TASK, "utf-8")
    return folder / "a.v2"
