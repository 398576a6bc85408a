"""The meshes of robot and bodies, logged once."""

from collections.abc import Sequence

import numpy as np
import rerun as rr

from vrts.report.assessment import Assessment
from vrts.report.lighting import to_srgb
from vrts.report.recording.names import of_body, of_robot
from vrts.report.solids import Solid, body_solids, link_solids


def log_shapes(a: Assessment) -> None:
    """Log what stands in the scene; what never moves with its place."""
    assert a.scene is not None
    rr.log("world", rr.ViewCoordinates.RIGHT_HAND_Z_UP, static=True)
    for solid in link_solids(a.scene.robot):
        _log(of_robot(solid.name), [solid])
    solids: dict[str, list[Solid]] = {}
    for solid in body_solids(a.scene):
        solids.setdefault(solid.group, []).append(solid)
    moved = frozenset(a.run.placements if a.run else ())
    for body in a.scene.bodies:
        path = of_body(body.name)
        _log(path, solids[body.name])
        if body.name not in moved:
            R = np.array(body.X_WO.rotation, np.float32).reshape(3, 3)
            place = rr.Transform3D(translation=body.X_WO.translation, mat3x3=R)
            rr.log(path, place, static=True)


def _log(path: str, solids: Sequence[Solid]) -> None:
    """Log one mesh of separate triangles, so that edges stay sharp and round faces smooth."""
    corners = np.concatenate([solid.surface.corners.reshape(-1, 3) for solid in solids])
    normals = np.concatenate([solid.surface.normals.reshape(-1, 3) for solid in solids])
    colors = to_srgb(np.array([solid.color for solid in solids], np.float32))
    if not len(corners):
        return
    counts = [solid.surface.corners.size // 3 for solid in solids]
    one = len(solids) == 1
    mesh = rr.Mesh3D(
        vertex_positions=corners.astype(np.float32),
        vertex_normals=normals.astype(np.float32),
        vertex_colors=None if one else np.repeat(colors, counts, axis=0),
        albedo_factor=colors[0] if one else None,
    )
    rr.log(path, mesh, static=True)
