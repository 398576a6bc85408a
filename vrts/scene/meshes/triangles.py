"""A closed surface of triangles, and what is measured of it."""

from typing import NamedTuple, TypeAlias

import numpy as np
import numpy.typing as npt

Array: TypeAlias = npt.NDArray[np.float64]
Indices: TypeAlias = npt.NDArray[np.int64]

FLATTEST = 1e-3  # [mm] of a mesh across
LARGEST = 10_000.0  # [mm] of any coordinate


class MeshFault(Exception):  # noqa: N818 -- names what it is
    """A mesh that cannot be taken, in one sentence, and what to do."""

    def __init__(self, message: str, remedy: str = "") -> None:
        """Keep the sentence and the remedy."""
        super().__init__(message)
        self.remedy = remedy


class Triangles(NamedTuple):
    """A surface; corners that are one stand in it once."""

    vertices: Array  # (n, 3) [mm]
    faces: Indices  # (m, 3), counter-clockwise seen from outside

    @property
    def corners(self) -> Array:
        """The corners of every triangle, shape (m, 3, 3) [mm]."""
        return self.vertices[self.faces]

    @property
    def volume(self) -> float:
        """What the surface encloses [mm^3]."""
        a, b, c = self.corners.transpose(1, 0, 2)
        return float(np.einsum("ij,ij->i", a, np.cross(b, c)).sum() / 6.0)

    @property
    def centre_of_mass(self) -> Array:
        """Of a solid of one density [mm]."""
        a, b, c = self.corners.transpose(1, 0, 2)
        parts = np.einsum("ij,ij->i", a, np.cross(b, c)) / 6.0
        return (parts[:, None] * (a + b + c) / 4.0).sum(axis=0) / parts.sum()


def closed(corners: Array) -> Triangles:
    """Return the surface of triangles, after a look at what it has to be.

    Args:
        corners: Shape (m, 3, 3), in mm.

    Raises:
        MeshFault: It is too large, flat, or not closed.
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
    found = Triangles(vertices, faces)
    volume = found.volume
    if volume < 0.0:
        found = Triangles(vertices, faces[:, ::-1].copy())
    if abs(volume) < FLATTEST**3:
        raise MeshFault("the mesh encloses no volume", "look at `unit`, or save it as a solid")
    return found


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
