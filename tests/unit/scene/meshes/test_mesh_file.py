"""Mesh files: what is read, and what is refused before anything is made of it."""

import numpy as np
import pytest

from tests.parts import HEIGHT, obj, stl, text_stl, u_shape
from vrts.scene.meshes.mesh_file import MOST_BYTES, MOST_TRIANGLES, read_mesh
from vrts.scene.meshes.triangles import MeshFault


def refusal(name: str, data: bytes, unit: str = "mm") -> str:
    with pytest.raises(MeshFault) as found:
        read_mesh(name, data, unit)
    return str(found.value)


@pytest.mark.parametrize(
    ("name", "data"),
    [("a.stl", stl(u_shape())), ("A.STL", text_stl(u_shape())), ("a.obj", obj(u_shape()))],
)
def test_every_format_gives_the_same_surface(name: str, data: bytes) -> None:
    mesh = read_mesh(name, data, "mm")
    assert len(mesh.faces) == 28
    assert mesh.volume == pytest.approx(320_000.0)
    assert mesh.centre_of_mass == pytest.approx((60.0, 22.0, HEIGHT / 2))


def test_the_unit_is_what_the_author_says() -> None:
    inches = read_mesh("a.stl", stl(u_shape() / 25.4), "inch")
    assert inches.volume == pytest.approx(320_000.0, rel=1e-5)
    metres = read_mesh("a.stl", stl(u_shape() / 1000.0), "m")
    assert metres.volume == pytest.approx(320_000.0, rel=1e-5)


def test_a_surface_turned_inside_out_is_turned_back() -> None:
    assert read_mesh("a.stl", stl(u_shape()[:, ::-1]), "mm").volume == pytest.approx(320_000.0)


def test_holes_are_told_with_a_place() -> None:
    assert "not closed: 3 edges" in refusal("a.stl", stl(u_shape()[1:]))


def test_one_triangle_turned_the_wrong_way_is_told() -> None:
    corners = u_shape()
    corners[3] = corners[3, ::-1]
    assert "not closed" in refusal("a.stl", stl(corners))


def test_hostile_files_are_refused() -> None:
    bad = u_shape()
    bad[0, 0, 0] = np.nan
    assert "not a number" in refusal("a.stl", stl(bad))
    assert "16,000,000 bytes" in refusal("a.stl", bytes(MOST_BYTES + 1))
    assert "is no mesh that vrts reads" in refusal("a.3mf", b"PK\x03\x04")
    assert "cut off" in refusal("a.stl", stl(u_shape())[:-10])
    assert "cut off" in refusal("a.stl", b"solid nothing")
    many = np.repeat(u_shape(), MOST_TRIANGLES // 28 + 1, axis=0)
    assert f"{MOST_TRIANGLES:,} are taken" in refusal("a.stl", stl(many))
    assert "from its origin" in refusal("a.stl", stl(u_shape()), "m")
    assert "flat" in refusal("a.stl", stl(u_shape() * (1.0, 1.0, 0.0)))
    assert "far too small" in refusal("a.stl", stl(u_shape() / 1000.0))  # metres read as mm
    assert "less than 1 mm3" in refusal("a.stl", stl(u_shape() / 80.0 / 1.3))


@pytest.mark.parametrize(
    "line", ["f 1 2 9", "f 0 1 2", "f 1 2", "v 1 2", "v a b c", "v 1 2 3" + " " * 3000, "v 1 2 nan"]
)
def test_odd_lines_of_an_obj_file_are_refused(line: str) -> None:
    assert refusal("a.obj", f"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n{line}\nf 1 2 3\n".encode())
