"""Meshes are closed, turn outwards and hold the volume of the shape."""

import math
from collections import Counter

import numpy as np
import pytest

from vrts.base.pose import IDENTITY, Z_AXIS, Pose, rotation_about
from vrts.geometry.hull import faces
from vrts.geometry.mesh import Mesh, surface, tessellate
from vrts.geometry.shapes import Box, Cylinder, Hull, Piece, Shape

RING = tuple(
    (0.1 * math.cos(k * math.tau / 24), 0.1 * math.sin(k * math.tau / 24), z)
    for k in range(24)
    for z in (0.0, 0.3)
)
FRUSTUM = Hull(
    tuple((s * r, t * r, z) for s in (-1, 1) for t in (-1, 1) for r, z in ((0.2, 0.0), (0.1, 0.3)))
)
SHAPES: list[tuple[str, Shape, float]] = [
    ("box", Box((0.1, 0.2, 0.3)), 8 * 0.1 * 0.2 * 0.3),
    ("cylinder", Cylinder(0.1, 0.2), 0.4 * 24 * 0.01 * math.sin(math.tau / 48)),
    ("ring hull", Hull(RING), 0.3 * 12 * 0.01 * math.sin(math.tau / 24)),
    ("frustum", FRUSTUM, 0.3 / 3 * (0.16 + 0.04 + 0.08)),
    ("corner", Hull(((0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1), (0.1, 0.1, 0.1))), 1 / 6),
]


def volume(mesh: Mesh) -> float:
    a, b, c = (mesh.vertices[mesh.triangles[:, k]] for k in range(3))
    return float(np.einsum("ij,ij->", a, np.cross(b, c))) / 6


def assert_watertight(mesh: Mesh) -> None:
    edges = Counter((int(t[k]), int(t[(k + 1) % 3])) for t in mesh.triangles for k in range(3))
    assert all(count == 1 for count in edges.values())
    assert all((b, a) in edges for a, b in edges)
    assert set(mesh.triangles.ravel().tolist()) == set(range(len(mesh.vertices)))


@pytest.mark.parametrize(("shape", "expected"), [s[1:] for s in SHAPES], ids=[s[0] for s in SHAPES])
def test_surface_is_closed_and_has_the_volume(shape: Shape, expected: float) -> None:
    mesh = surface(shape)
    assert_watertight(mesh)
    assert volume(mesh) == pytest.approx(expected, rel=1e-9)


def test_random_hulls_are_closed() -> None:
    random = np.random.default_rng(7)
    for _ in range(40):
        points = random.normal(size=(int(random.integers(5, 40)), 3))
        mesh = surface(Hull(tuple((float(x), float(y), float(z)) for x, y, z in points)))
        assert_watertight(mesh)
        hull = faces(points)
        for polygon in hull.polygons:
            a, b, c = hull.vertices[list(polygon[:3])]
            normal = np.cross(b - a, c - a)
            assert ((points - a) @ normal).max() < 1e-9


def test_points_on_a_grid_keep_only_the_corners() -> None:
    grid = np.array([(x, y, z) for x in range(4) for y in range(4) for z in range(4)], float)
    hull = faces(grid)
    assert len(hull.vertices) == 8
    assert sorted(map(len, hull.polygons)) == [4] * 6


def test_flat_points_are_refused() -> None:
    with pytest.raises(ValueError, match="plane"):
        faces(np.array([(0, 0, 0), (1, 0, 0), (0, 1, 0), (1, 1, 0), (0.5, 0.2, 0)], float))


def test_tessellate_puts_the_piece_into_its_body() -> None:
    X_OP = Pose(rotation_about(Z_AXIS, math.pi / 2), (1.0, 0.0, 0.0))
    mesh = tessellate(Piece(Box((0.1, 0.2, 0.3)), X_OP))
    assert np.allclose(mesh.vertices.min(axis=0), (0.8, -0.1, -0.3))
    assert np.allclose(mesh.vertices.max(axis=0), (1.2, 0.1, 0.3))
    same = tessellate(Piece(Box((0.1, 0.2, 0.3)), IDENTITY))
    assert np.array_equal(mesh.triangles, same.triangles)
