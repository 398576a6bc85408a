"""What goes along with a scene that names meshes: their pieces, wherever they lie."""

from pathlib import Path

from tests.parts import u_pieces
from vrts.assignments.task_folder import LARGEST, with_shapes

SCENE = """
[objects.cradle]
kind = "mesh"
file = "cradle.stl"
unit = "mm"
at_mm = [850, -330]
on = "floor"

[objects.other]
kind = "mesh"
file = "cradle.stl"
pieces = "parts/other.json"
unit = "mm"
at_mm = [850, 330]
on = "floor"

[objects.astray]
kind = "mesh"
file = "../secret"
unit = "mm"
at_mm = [850, 0]
on = "floor"
"""


def test_pieces_go_along_and_a_large_mesh_stays(tmp_path: Path) -> None:
    folder = tmp_path / "lab"
    (folder / "parts").mkdir(parents=True)
    (tmp_path / "secret.pieces.json").write_bytes(u_pieces())
    (folder / "scene.toml").write_text(SCENE)
    (folder / "cradle.stl").write_bytes(bytes(LARGEST + 1))
    (folder / "small.stl").write_bytes(b"solid")
    (folder / "cradle.stl.pieces.json").write_bytes(u_pieces())
    (folder / "parts" / "other.json").write_bytes(u_pieces())
    files: dict[str, bytes] = {}
    with_shapes(folder / "scene.toml", "lab/scene.toml", files)
    assert set(files) == {
        "lab/scene.toml",
        "lab/small.stl",
        "lab/cradle.stl.pieces.json",
        "lab/parts/other.json",
    }
