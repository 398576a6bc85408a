"""Pieces of concave meshes are never farther than the mesh, and nearer by no more than told."""

import math
from functools import cache
from importlib import import_module
from typing import Any

import numpy as np
import numpy.typing as npt
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.laws import examples
from tests.parts import stl, u_shape
from vrts.base.pose import IDENTITY, Pose, rotation_about
from vrts.geometry.proving.scalar import nearest
from vrts.geometry.shapes import Box, Hull, Piece
from vrts.pipeline.pieces.making import made
from vrts.scene.meshes.pieces_file import Pieces
from vrts.scene.meshes.polytopes import polytope

fcl: Any = import_module("fcl")

ROUNDING = 2e-3  # [mm] of the two ways to a distance
RING = 24  # corners of a ring
TURN = st.floats(-math.pi, math.pi)
PLACE = st.floats(-90.0, 90.0)
HALF = st.floats(1.0, 25.0)


def ring() -> npt.NDArray[np.float64]:
    """A tube with slanted walls, whose hole a hull would close."""
    angles = np.arange(RING) * math.tau / RING
    circle = np.stack([np.cos(angles), np.sin(angles)], axis=1)
    rims = [(40.0, 0.0), (46.0, 35.0), (30.0, 35.0), (22.0, 0.0)]
    rows = [np.column_stack([r * circle, np.full(RING, z)]) for r, z in rims]
    faces: list[npt.NDArray[np.float64]] = []
    for row, following in zip(rows, rows[1:] + rows[:1], strict=True):
        for k in range(RING):
            a, b = row[k], row[(k + 1) % RING]
            c, d = following[(k + 1) % RING], following[k]
            faces += [np.array([a, b, c]), np.array([a, c, d])]
    return np.array(faces)


MESHES = {"u": u_shape(), "ring": ring()}


@cache
def pieces_of(name: str) -> Pieces:
    return made(f"{name}.stl", stl(MESHES[name]), "mm", 0.05, 32)


@cache
def solid(name: str) -> Any:
    return fcl.CollisionObject(_bvh(MESHES[name].astype(np.float32)), fcl.Transform())


def _bvh(corners: npt.NDArray[np.floating]) -> Any:
    model = fcl.BVHModel()
    model.beginModel(len(corners), 3 * len(corners))
    model.addSubModel(
        corners.reshape(-1, 3).astype(np.float64), np.arange(3 * len(corners)).reshape(-1, 3)
    )
    model.endModel()
    return model


def mesh_distance(name: str, half: tuple[float, float, float], X: Pose) -> float:
    """Return the distance of a box to the surface of a mesh in mm; 0 where they meet."""
    corners = [(x, y, z) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]
    hull = polytope(np.array(corners, dtype=np.float64) * half)
    triangles = np.array(
        [
            hull.points[[polygon[0], polygon[k], polygon[k + 1]]]
            for polygon in hull.polygons
            for k in range(1, len(polygon) - 1)
        ]
    )
    at = fcl.Transform(np.array(X.rotation).reshape(3, 3), np.array(X.translation))
    box = fcl.CollisionObject(_bvh(triangles), at)
    if fcl.collide(solid(name), box, fcl.CollisionRequest(), fcl.CollisionResult()):
        return 0.0
    result = fcl.DistanceResult()
    return fcl.distance(solid(name), box, fcl.DistanceRequest(), result)


@pytest.mark.parametrize("name", ["u", pytest.param("ring", marks=pytest.mark.thorough)])
@settings(max_examples=examples(120), deadline=None)
@given(
    half=st.tuples(HALF, HALF, HALF),
    at=st.tuples(PLACE, PLACE, PLACE),
    axis=st.sampled_from([(1.0, 0.0, 0.0), (0.6, 0.8, 0.0), (0.48, 0.6, 0.64)]),
    turn=TURN,
)
def test_the_clearance_of_pieces_is_safe_and_as_near_as_told(
    name: str,
    half: tuple[float, float, float],
    at: tuple[float, float, float],
    axis: tuple[float, float, float],
    turn: float,
) -> None:
    X = Pose(rotation_about(axis, turn), at)
    true = mesh_distance(name, half, X)
    box, found = Piece(Box(half), IDENTITY), pieces_of(name)
    hulls = [Piece(Hull(points), IDENTITY) for points in found.corners]
    proven = min(nearest(hull, IDENTITY, box, X).lower for hull in hulls)
    assert proven <= true + ROUNDING  # where surfaces meet, pieces do
    if proven > 0.0:
        assert proven >= true - found.at_most - ROUNDING
