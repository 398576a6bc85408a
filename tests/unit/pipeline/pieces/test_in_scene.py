"""`vrts scene check` with meshes: pieces made, proven, and refused where they are others."""

import hashlib
import json
from pathlib import Path

import numpy as np
import pytest
from click.testing import CliRunner, Result

from tests.parts import U_PIECES, block, stl, u_pieces, u_shape
from vrts.cli.main import vrts
from vrts.pipeline.pieces import splitting

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


def folder_with(path: Path, scene: str = SCENE) -> Path:
    (path / "scene.toml").write_text(scene)
    (path / "cradle.stl").write_bytes(stl(u_shape()))
    return path


def check(folder: Path, *more: str) -> Result:
    return CliRunner().invoke(vrts, ["scene", "check", str(folder), *more])


@pytest.mark.thorough
def test_pieces_are_made_once_and_proven_at_every_check(tmp_path: Path) -> None:
    folder = folder_with(tmp_path)
    lacking = check(folder)
    assert lacking.exit_code == 1
    assert "V899" in lacking.stderr
    picture = tmp_path / "pieces.png"
    made = check(folder, "--write", "--png", str(picture))
    assert made.exit_code == 0, made.output
    assert "proven: the pieces hold the whole surface of the mesh" in made.stdout
    assert picture.read_bytes().startswith(b"\x89PNG")
    file = folder / "cradle.stl.pieces.json"
    first = file.read_bytes()
    assert len(json.loads(first)["pieces_mm"]) == 3
    again = check(folder, "--write")
    assert "is as it was" in again.stderr
    assert file.read_bytes() == first

    fields = json.loads(first)
    fields["pieces_mm"].pop()
    file.write_text(json.dumps(fields))
    short = check(folder)
    assert short.exit_code == 1
    assert "V912" in short.stderr
    assert "the mesh stands out of the pieces by up to" in short.stdout

    file.write_bytes(first)
    (folder / "cradle.stl").write_bytes(stl(u_shape() * 1.01))
    changed = check(folder)
    assert changed.exit_code == 1
    assert "V910" in changed.stderr

    (folder / "cradle.stl").unlink()
    alone = check(folder)
    assert alone.exit_code == 0
    assert "runs do not need it" in alone.stdout
    assert "V913" in alone.stderr


@pytest.mark.parametrize(
    ("scene", "said"),
    [
        (SCENE.replace('"cradle.stl"', '"../cradle.stl"'), "own folder"),
        (SCENE.replace('"cradle.stl"', '"missing.stl"'), "no such file"),
        (SCENE.replace('"cradle.stl"', '"scene.toml"'), "no mesh that vrts reads"),
        (SCENE.replace('unit = "mm"', 'unit = "m"'), "farther than 10 m"),
        (SCENE + 'pieces = "../out.json"\n', "own folder"),
        (SCENE + 'pieces = "nowhere/out.json"\n', "or in none"),
        (SCENE + 'pieces = "scene.toml"\n', "another file, which is not overwritten"),
        (SCENE + 'pieces = "cradle.stl"\n', "another file, which is not overwritten"),
    ],
)
def test_meshes_that_cannot_be_taken_are_told(tmp_path: Path, scene: str, said: str) -> None:
    found = check(folder_with(tmp_path, scene), "--write")
    assert found.exit_code == 1
    assert "V897" in found.stderr
    assert said in found.stderr
    assert sorted(path.name for path in tmp_path.iterdir()) == ["cradle.stl", "scene.toml"]


def test_a_library_that_is_not_there_is_named(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(splitting, "NEEDED", ("no_such_package",))
    found = check(folder_with(tmp_path), "--write")
    assert found.exit_code == 1
    assert "V911" in found.stderr
    assert "vrts[mesh]" in found.stderr
    assert "V899" not in found.stderr


def test_asking_for_pieces_without_writing_them_is_a_wrong_call(tmp_path: Path) -> None:
    assert check(folder_with(tmp_path), "--most", "4").exit_code == 2


def test_a_part_that_is_inside_out_is_told(tmp_path: Path) -> None:
    folder = folder_with(tmp_path)
    beside = (u_shape() * 0.5 + (200.0, 0.0, 0.0))[:, ::-1]
    mesh = stl(np.concatenate([u_shape(), beside]))
    (folder / "cradle.stl").write_bytes(mesh)
    more = b",\n".join(
        json.dumps([[x / 2 + 200, y / 2, z / 2] for x, y, z in block(*each)]).encode()
        for each in U_PIECES
    )
    written = u_pieces(sha256=hashlib.sha256(mesh).hexdigest()).replace(
        b"]]\n  ]", b"]],\n" + more + b"\n  ]"
    )
    (folder / "cradle.stl.pieces.json").write_bytes(written)
    told = check(folder)
    assert "V690" in told.stderr
    assert "of 1 the normals point inward; they count as solid" in told.stderr
    assert "V897" not in told.stderr
    assert "V922" not in told.stderr

    twice = stl(np.concatenate([u_shape(), u_shape() * (0.1, 0.1, 0.5) + (50.0, 5.0, 5.0)]))
    (folder / "cradle.stl").write_bytes(twice)
    written = u_pieces(sha256=hashlib.sha256(twice).hexdigest())
    (folder / "cradle.stl.pieces.json").write_bytes(written)
    told = check(folder)
    assert "warning[V922 solids-overlap]" in told.stderr
