"""`vrts task check` looks at the meshes of a task as `vrts scene check` does."""

from pathlib import Path

from tests.parts import u_pieces
from vrts.cli.authoring.mesh_pieces import task_pieces
from vrts.pipeline.settings import load_task

SCENE = """
[objects.table]
kind = "table"
at_mm = [1000, 0]
size_mm = [800, 1400]
top_z_mm = -300

[objects.cradle]
kind = "mesh"
file = "cradle.stl"
unit = "mm"
at_mm = [850, -330]
on = "table"
"""
TASK = """
[task]
scene = "scene.toml"

[[via]]
name = "a"
at_mm = [900, 0, 0]
radius_mm = 50

[time]
reference_s = 10
"""


def test_a_task_whose_mesh_is_not_there_is_told(tmp_path: Path) -> None:
    (tmp_path / "scene.toml").write_text(SCENE)
    (tmp_path / "task.toml").write_text(TASK)
    (tmp_path / "cradle.stl.pieces.json").write_bytes(u_pieces())
    (found,) = task_pieces(load_task(tmp_path), tmp_path)
    assert (found.rule.code, found.is_error) == ("V913", False)
