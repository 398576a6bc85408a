"""The meshes of robot and bodies, logged once."""

from collections.abc import Sequence
from functools import lru_cache
from typing import TypeAlias

import numpy as np
import rerun as rr

from vrts.geometry.shapes import Piece
from vrts.report.assessment import Assessment
from vrts.report.lighting import to_srgb
from vrts.report.recording.names import of_body, of_robot
from vrts.report.solids import Color, Surface, by_color, link_solids, surface
from vrts.robots.model import Robot
from vrts.scene.model import Scene

Painted: TypeAlias = tuple[tuple[Color, tuple[Piece, ...]], ...]
Meshes: TypeAlias = tuple[tuple[str, rr.Mesh3D], ...]  # with their paths

KEPT = 256  # meshes


def log_shapes(a: Assessment) -> None:
    """Log what stands in the scene; what never moves with its place."""
    assert a.scene is not None
    rr.log("world", rr.ViewCoordinates.RIGHT_HAND_Z_UP, static=True)
    for path, mesh in _robot(a.scene.robot):
        rr.log(path, mesh, static=True)
    moved = frozenset(a.run.placements if a.run else ())
    for body in a.scene.bodies:
        known: list[rr.AsComponents] = []
        if body.name not in moved:
            R = np.array(body.X_WO.rotation, np.float32).reshape(3, 3)
            known.append(rr.Transform3D(translation=body.X_WO.translation, mat3x3=R))
        mesh = _body(tuple(by_color(body)))
        if mesh is not None:
            known.append(mesh)
        if known:
            rr.log(of_body(body.name), *known, static=True)


def prepare_shapes(scene: Scene) -> None:
    """Make the meshes of a scene, which are kept. No recording is opened, no thread started."""
    _robot(scene.robot)
    for body in scene.bodies:
        _body(tuple(by_color(body)))


@lru_cache(maxsize=8)
def _robot(robot: Robot) -> Meshes:
    meshes = ((of_robot(s.name), _mesh([s.surface], [s.color])) for s in link_solids(robot))
    return tuple((path, mesh) for path, mesh in meshes if mesh is not None)


@lru_cache(maxsize=KEPT)
def _body(painted: Painted) -> rr.Mesh3D | None:
    return _mesh([surface(pieces) for _, pieces in painted], [color for color, _ in painted])


def _mesh(surfaces: Sequence[Surface], colors: Sequence[Color]) -> rr.Mesh3D | None:
    """Return one mesh of separate triangles, so that edges stay sharp and round faces smooth."""
    counts = [one.corners.size // 3 for one in surfaces]
    if not sum(counts):
        return None
    corners = np.concatenate([one.corners.reshape(-1, 3) for one in surfaces])
    normals = np.concatenate([one.normals.reshape(-1, 3) for one in surfaces])
    srgb = to_srgb(np.array(colors, np.float32))
    alone = len(surfaces) == 1
    return rr.Mesh3D(
        vertex_positions=corners.astype(np.float32),
        vertex_normals=normals.astype(np.float32),
        vertex_colors=None if alone else np.repeat(srgb, counts, axis=0),
        albedo_factor=srgb[0] if alone else None,
    )
