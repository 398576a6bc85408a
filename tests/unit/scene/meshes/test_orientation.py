"""The parts of a mesh, and which way they are turned: by trimesh, and by points in boxes."""

from collections.abc import Callable, Sequence
from importlib import import_module
from typing import Any, TypeAlias

import numpy as np
import numpy.typing as npt
import pytest

from tests.parts import stl
from vrts.scene.meshes.closed import closed
from vrts.scene.meshes.deviation import deviation
from vrts.scene.meshes.mesh_file import read_mesh
from vrts.scene.meshes.parts import parts_of
from vrts.scene.meshes.polytopes import polytope
from vrts.scene.meshes.triangles import MeshFault, Triangles
from vrts.scene.meshes.winding import shares

Array: TypeAlias = npt.NDArray[np.float64]

trimesh: Any = import_module("trimesh")  # its types are only partly known


def box(low: Sequence[float], high: Sequence[float], *, inward: bool = False) -> Array:
    """Return the triangles of a box, shape (12, 3, 3)."""
    made = trimesh.creation.box(bounds=[low, high])
    corners = np.asarray(made.triangles, dtype=np.float64)
    return corners[:, ::-1] if inward else corners


def ball(middle: Sequence[float], radius: float, *, inward: bool = False) -> Array:
    made = trimesh.creation.icosphere(subdivisions=1, radius=radius)
    corners = np.asarray(made.triangles, dtype=np.float64) + middle
    return corners[:, ::-1] if inward else corners


def cube(x: float, y: float = 0.0, z: float = 0.0, *, inward: bool = False) -> Array:
    return box((x, y, z), (x + 10.0, y + 10.0, z + 10.0), inward=inward)


def mesh_of(*parts: Array) -> Triangles:
    return closed(np.concatenate(parts))


def foreign(mesh: Triangles) -> Any:
    return trimesh.Trimesh(mesh.vertices, mesh.faces, process=False)


def least_times(mesh: Triangles, rng: np.random.Generator) -> float:
    """Return how often the surface goes round points by chance, at least."""
    low, high = mesh.vertices.min(axis=0) - 1.0, mesh.vertices.max(axis=0) + 1.0
    points = rng.uniform(low, high, (60, 3))
    return min(float(shares(mesh.corners, point).sum()) for point in points)


SHELL = box((0, 0, 0), (40, 40, 40))
HOLLOW = box((5, 5, 5), (35, 35, 35), inward=True)
ISLAND = box((10, 10, 10), (20, 20, 20))


@pytest.mark.parametrize(
    ("parts", "volume", "turned"),
    [
        ([cube(0), cube(20)], 2000.0, 0),
        ([cube(0), cube(20, inward=True)], 2000.0, 1),
        ([cube(0, inward=True), cube(20, inward=True)], 2000.0, 0),
        ([cube(0), box((20, 0, 0), (50, 30, 30), inward=True)], 28_000.0, 1),
        ([SHELL, HOLLOW], 37_000.0, 0),
        ([SHELL[:, ::-1], HOLLOW[:, ::-1]], 37_000.0, 0),
        ([SHELL, HOLLOW, ISLAND], 38_000.0, 0),
        ([SHELL[:, ::-1], HOLLOW[:, ::-1], ISLAND[:, ::-1], cube(60)], 39_000.0, 3),
        ([SHELL, HOLLOW, ISLAND, cube(60, inward=True)], 39_000.0, 1),
        ([SHELL, ISLAND], 65_000.0, 0),  # a solid in a solid counts twice, as in trimesh
        ([cube(0), cube(10, 10, inward=True)], 2000.0, 1),  # they share an edge
        ([cube(0), cube(10, inward=True)], 2000.0, 1),  # a face
        ([cube(0), cube(10)], 2000.0, 0),
        ([cube(0), cube(10, 10, 10, inward=True)], 2000.0, 1),  # a corner
        ([cube(0), cube(5, 5, 5)], 2000.0, 0),  # they overlap
    ],
)
def test_each_part_is_solid_or_a_hollow_in_one(
    parts: list[Array], volume: float, turned: int
) -> None:
    shuffled = np.random.default_rng(2).permutation(np.concatenate(parts))
    mesh = closed(shuffled)
    assert (mesh.turned, mesh.volume) == (turned, pytest.approx(volume))
    told = foreign(mesh)
    assert told.volume == pytest.approx(volume)
    assert told.center_mass == pytest.approx(mesh.centre_of_mass)
    assert least_times(mesh, np.random.default_rng(1)) > -1e-6


@pytest.mark.parametrize(
    ("parts", "said"),
    [
        ([SHELL, HOLLOW, ISLAND[:, ::-1]], "near (15.0, 15.0, 15.0) mm is inside out: its normals"),
        ([SHELL, box((30, 5, 5), (50, 35, 35), inward=True)], "cuts through another part"),
        ([SHELL, box((30, 5, 5), (45, 15, 15), inward=True), cube(60)], "cuts through another"),
        ([ball((0, 0, 0), 9), ball((0, 0, 8), 6, inward=True)], "cuts through another part"),
        ([cube(3.0 * k, inward=k > 200) for k in range(210)], "200 parts at most"),
    ],
)
def test_what_cannot_be_told_is_refused(parts: list[Array], said: str) -> None:
    with pytest.raises(MeshFault) as found:
        mesh_of(*parts)
    assert said in str(found.value)
    assert found.value.remedy


def band(outline: Sequence[tuple[float, float]]) -> Array:
    """Return the triangles of a prism over a closed line that may cross itself, 30 mm high."""
    low, high = (np.array([(x, y, z) for x, y in outline]) for z in (0.0, 30.0))
    parts = [(low[k - 1], low[k], high[k]) for k in range(len(low))]
    parts += [(low[k - 1], high[k], high[k - 1]) for k in range(len(low))]
    parts += [(high[k - 1], high[k], high.mean(axis=0)) for k in range(len(low))]
    parts += [(low[k], low[k - 1], low.mean(axis=0)) for k in range(len(low))]
    return np.array(parts)


@pytest.mark.parametrize(
    "outline",
    [
        [(0, 0), (60, 30), (60, 10), (0, 40)],  # an 8, one half of it inside out
        [(0, 0), (40, 22), (60, 36), (60, 14), (40, 18), (0, 60)],
        [(0, 0), (50, 0), (50, 22), (80, 2), (80, 22), (50, 2), (50, 40), (0, 40)],
    ],
)
def test_a_mesh_that_crosses_itself_like_an_8_is_refused(
    outline: list[tuple[float, float]],
) -> None:
    for corners in (band(outline), band(outline[::-1])):
        with pytest.raises(MeshFault, match="passes through itself, and is inside out"):
            closed(corners)


@pytest.mark.parametrize(
    ("parts", "shared"),
    [
        ([cube(0), cube(5, 5, 5)], True),
        ([SHELL, ISLAND], True),
        (
            [
                band(
                    [(40 * np.cos(k * 0.8 * np.pi), 40 * np.sin(k * 0.8 * np.pi)) for k in range(5)]
                )
            ],
            True,
        ),
        ([SHELL, HOLLOW, ISLAND], False),
        ([cube(0), cube(10)], False),  # they touch, with a face
        ([cube(0), cube(10, 10)], False),
    ],
)
def test_solids_that_share_room_are_told(parts: list[Array], shared: bool) -> None:
    assert mesh_of(*parts).shared is shared


def by_chance(rng: np.random.Generator, make: Callable[..., Array]) -> tuple[list[Array], int]:
    """Return parts that do not overlap, with hollows and islands, and how many are solid."""
    parts: list[Array] = []
    for k in range(int(rng.integers(2, 5))):
        at = np.array([40.0 * k, *rng.uniform(-20, 20, 2)])
        size = rng.uniform(8, 18)
        group = [make(at, size)]
        if rng.random() < 0.6:
            group.append(make(at, 0.7 * size, inward=True))
            if rng.random() < 0.5:
                group.append(make(at, 0.3 * size))
        parts.append(np.concatenate(group))
    return parts, len(parts)


def _box_at(at: Array, size: float, *, inward: bool = False) -> Array:
    return box((at - size).tolist(), (at + size).tolist(), inward=inward)


@pytest.mark.parametrize("seed", range(6))
def test_random_meshes_are_as_they_were_before_groups_were_flipped(seed: int) -> None:
    rng = np.random.default_rng(seed)
    groups, count = by_chance(rng, ball if seed % 2 else _box_at)
    right = np.concatenate(groups)
    flipped = rng.random(count) < 0.5
    mixed = [g[:, ::-1] if f else g for g, f in zip(groups, flipped, strict=True)]
    order = rng.permutation(len(right))
    mesh = closed(np.concatenate(mixed)[order])
    wanted = trimesh.Trimesh(right.reshape(-1, 3), np.arange(3 * len(right)).reshape(-1, 3))
    assert mesh.volume == pytest.approx(wanted.volume)
    assert mesh.centre_of_mass == pytest.approx(wanted.center_mass)
    told = foreign(mesh)
    assert told.is_winding_consistent
    assert told.is_watertight
    sizes = [len(part.faces) for part in trimesh.graph.split(told, repair=False)]
    number = parts_of(mesh.vertices, mesh.faces)
    assert sorted(np.bincount(number).tolist()) == sorted(sizes)
    assert (mesh.turned > 0) == (0 < flipped.sum() < count)
    assert least_times(mesh, rng) > -1e-6


def test_a_part_that_is_inside_out_does_not_hide_how_far_pieces_stand_out() -> None:
    """Points in a part that is inside out would count as inside, and be left out."""
    far = np.array([7.0, 0.0, 0.0])
    mesh = read_mesh("a.stl", stl(np.concatenate([cube(0), cube(30, inward=True)])), "mm")
    first, second = (polytope(np.unique(cube(x).reshape(-1, 3), axis=0)) for x in (0.0, 30.0))
    assert deviation(mesh, [first, second]).at_most < 0.1
    longer = polytope(np.concatenate([second.points, second.points + far]))
    off = deviation(mesh, [first, longer])
    assert off.found == pytest.approx(7.0, abs=0.3)
    assert off.at_most >= 7.0
