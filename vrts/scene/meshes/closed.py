"""Whether triangles are a closed surface that pieces can be made of."""

from typing import TypeAlias

import numpy as np
import numpy.typing as npt

from vrts.scene.meshes.orientation import oriented
from vrts.scene.meshes.passes import passes
from vrts.scene.meshes.triangles import LARGEST, MeshFault, Triangles

Array: TypeAlias = npt.NDArray[np.float64]
Indices: TypeAlias = npt.NDArray[np.int64]

FLATTEST = 0.1  # [mm] of a mesh across
LEAST = 1.0  # [mm^3] that a mesh encloses


def closed(corners: Array) -> Triangles:
    """Return the surface of triangles, after a look at what it has to be.

    Args:
        corners: Shape (m, 3, 3), in mm.

    Raises:
        MeshFault: It is too large or small, flat, not closed, or some of it is inside out.
    """
    if not bool(np.isfinite(corners).all()):
        raise MeshFault("a corner of the mesh is not a number", "save the mesh again")
    if float(np.abs(corners).max()) > LARGEST:
        raise MeshFault(
            f"a corner of the mesh is farther than {LARGEST / 1000:.0f} m from its origin",
            "look at `unit`, or move the part to the origin of its file",
        )
    vertices, index = np.unique(corners.reshape(-1, 3) + 0.0, axis=0, return_inverse=True)
    faces = index.reshape(-1, 3).astype(np.int64)
    a, b, c = faces.T
    faces = faces[(a != b) & (b != c) & (c != a)]
    if len(faces) < 4 or float(np.ptp(vertices, axis=0).min()) < FLATTEST:
        raise MeshFault("the mesh is flat, or far too small", "look at `unit`")
    _check_edges(vertices, faces)
    found = Triangles(vertices, *oriented(vertices, faces))
    if found.volume < LEAST:
        raise MeshFault(
            f"the mesh encloses no volume, or less than {LEAST:g} mm3",
            "look at `unit`, or save it as a solid",
        )
    crossed = passes(found.corners)
    if crossed.inside_out is not None:
        near = ", ".join(f"{value:.1f}" for value in crossed.inside_out)
        raise MeshFault(
            f"the mesh passes through itself, and is inside out behind that, near ({near}) mm",
            "repair the mesh: make one solid of it in your CAD or mesh program, and save it again",
        )
    return found._replace(shared=crossed.shared is not None)


def _check_edges(vertices: Array, faces: Indices) -> None:
    """Raise unless every edge belongs to as many triangles one way as the other."""
    edges = np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]])
    count = len(vertices)
    there = edges[:, 0] * count + edges[:, 1]
    back = edges[:, 1] * count + edges[:, 0]
    keys, tally = np.unique(there, return_counts=True)
    other, returning = np.unique(back, return_counts=True)
    position = np.searchsorted(other, keys)
    position[position == len(other)] = 0
    matched = (other[position] == keys) & (returning[position] == tally)
    if bool(matched.all()):
        return
    first = int(keys[int(np.argmin(matched))])
    a, b = vertices[first // count], vertices[first % count]
    middle = ", ".join(f"{value:.1f}" for value in (a + b) / 2.0)
    raise MeshFault(
        f"the mesh is not closed: {int((~matched).sum()):,} edges have a triangle on one side "
        f"only, or turned the wrong way; the first is near ({middle}) mm",
        "close the holes (repair the mesh in your CAD or mesh program) and save it again",
    )
