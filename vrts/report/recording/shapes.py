"""The meshes of robot and bodies, sent once."""

from collections.abc import Sequence
from functools import lru_cache
from typing import TypeAlias

import numpy as np
import rerun as rr
from rerun.chunk import Chunk

from vrts.base.pose import Pose
from vrts.geometry.shapes import Piece
from vrts.report.assessment import Assessment
from vrts.report.picture.lighting import to_srgb
from vrts.report.picture.solids import Color, Surface, by_color, link_solids, surface
from vrts.report.recording.names import of_body, of_finger, of_robot
from vrts.report.recording.static import static_chunk
from vrts.robots.model import Robot
from vrts.scene.model import Body, Scene

Painted: TypeAlias = tuple[tuple[Color, tuple[Piece, ...]], ...]

KEPT = 512  # bodies
NORMAL_DECIMALS = 6  # corners that differ by less are one


def send_shapes(a: Assessment) -> None:
    """Send what stands in the scene; what never moves with its place."""
    assert a.scene is not None
    moved = frozenset(a.run.placements if a.run else ())
    chunks = [*_world(), *_robot(a.scene.robot)]
    for body in a.scene.bodies:
        chunks += _of(body, moves=body.name in moved)
    rr.send_chunks(chunks)


def prepare_shapes(scene: Scene) -> None:
    """Make the meshes of a scene, which are kept. No recording is opened, no thread started."""
    _world()
    _robot(scene.robot)
    for body in scene.bodies:
        _of(body, moves=False)
        _of(body, moves=True)


def _of(body: Body, *, moves: bool) -> tuple[Chunk, ...]:
    return _body(body.name, tuple(by_color(body)), None if moves else body.X_WO)


@lru_cache(maxsize=1)
def _world() -> tuple[Chunk, ...]:
    return (static_chunk("world", rr.ViewCoordinates.RIGHT_HAND_Z_UP),)


@lru_cache(maxsize=8)
def _robot(robot: Robot) -> tuple[Chunk, ...]:
    fingers = {finger.name for finger in robot.gripper.fingers}
    found: list[Chunk] = []
    for solid in link_solids(robot):
        mesh = _mesh([solid.surface], [solid.color])
        path = of_finger(solid.name) if solid.name in fingers else of_robot(solid.name)
        if mesh is not None:
            found.append(static_chunk(path, mesh))
    return tuple(found)


@lru_cache(maxsize=KEPT)
def _body(name: str, painted: Painted, X_WO: Pose | None) -> tuple[Chunk, ...]:
    """Return a body's mesh, with its place if there is one; a body may be nothing but a place."""
    known: list[rr.AsComponents] = []
    if X_WO is not None:
        R = np.array(X_WO.rotation, np.float32).reshape(3, 3)
        known.append(rr.Transform3D(translation=X_WO.translation, mat3x3=R))
    mesh = _mesh([surface(pieces) for _, pieces in painted], [color for color, _ in painted])
    if mesh is not None:
        known.append(mesh)
    return (static_chunk(of_body(name), *known),) if known else ()


def _mesh(surfaces: Sequence[Surface], colors: Sequence[Color]) -> rr.Mesh3D | None:
    """Return one mesh, in which edges stay sharp and round faces smooth.

    Triangles share a corner where they have place, normal and colour in common.
    """
    counts = [one.corners.size // 3 for one in surfaces]
    if not sum(counts):
        return None
    places = np.concatenate([one.corners.reshape(-1, 3) for one in surfaces])
    normals = np.concatenate([one.normals.reshape(-1, 3) for one in surfaces])
    color = np.repeat(np.arange(len(surfaces)), counts)[:, None]
    corners = np.concatenate([places, normals.round(NORMAL_DECIMALS) + 0.0, color], axis=1)
    corners, number = np.unique(corners.astype(np.float32), axis=0, return_inverse=True)
    srgb = to_srgb(np.array(colors, np.float32))
    alone = len(surfaces) == 1
    return rr.Mesh3D(
        vertex_positions=corners[:, :3],
        triangle_indices=number.reshape(-1, 3).astype(np.uint32),
        vertex_normals=corners[:, 3:6],
        vertex_colors=None if alone else srgb[corners[:, 6].astype(np.int64)],
        albedo_factor=srgb[0] if alone else None,
    )
