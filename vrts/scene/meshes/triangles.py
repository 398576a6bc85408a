"""A closed surface of triangles, and what is measured of it."""

from typing import NamedTuple, TypeAlias

import numpy as np
import numpy.typing as npt

Array: TypeAlias = npt.NDArray[np.float64]
Indices: TypeAlias = npt.NDArray[np.int64]

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
    turned: int = 0  # parts that were inside out in the file while others were not
    shared: bool = False  # whether solids overlap in it: what they share counts more than once

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
