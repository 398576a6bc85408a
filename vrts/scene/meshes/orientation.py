"""Which way the normals of each part of a mesh point, and the turning of those that are wrong.

What a surface goes round less than zero times would count as inside the mesh, and pieces that
stand out there as inside it. So nothing may be gone round less than zero times. For a part whose
normals point outward that is so by itself. One whose normals point inward is a hollow: all round it
has to be material, and no other part may cut through it. A part that is inside no other can be no
hollow: it is turned, with all that is inside it. Of a part that passes through itself nothing is
told: it counts by what it encloses in sum.
"""

from typing import NamedTuple, TypeAlias

import numpy as np
import numpy.typing as npt

from vrts.scene.meshes.parts import parts_of
from vrts.scene.meshes.triangles import MeshFault
from vrts.scene.meshes.winding import shares

Array: TypeAlias = npt.NDArray[np.float64]
Indices: TypeAlias = npt.NDArray[np.int64]
Flags: TypeAlias = npt.NDArray[np.bool_]

MOST_PARTS = 200  # of a mesh in which some are inside out
MOST_ASKED = 200  # middles of triangles of one part
WHOLE = 0.05  # nearer to a whole number of times, a point is not on the other surface
AT_ONCE = 1_000_000  # pairs of triangles
CLOSE = 1e-9  # share of the size of a mesh: nearer to a plane, a corner is on no side of it
REMEDY = "turn the normals of this part in your CAD or mesh program, and save the mesh again"


class Oriented(NamedTuple):
    """Triangles whose normals point out of the material."""

    faces: Indices  # (m, 3)
    turned: int  # parts that were inside out while others were not


def oriented(vertices: Array, faces: Indices) -> Oriented:
    """Return a closed surface with the normals of every part pointing out of the material.

    Args:
        vertices: Shape (n, 3), in mm.
        faces: Shape (m, 3), each edge as often one way as the other.

    Raises:
        MeshFault: A part is inside out, and what it should be cannot be told.
    """
    part = parts_of(vertices, faces)
    about = (vertices.min(axis=0) + vertices.max(axis=0)) / 2.0
    a, b, c = (vertices - about)[faces].transpose(1, 0, 2)
    volumes = np.bincount(part, np.einsum("ij,ij->i", a, np.cross(b, c)) / 6.0)
    flip = np.full(len(volumes), float(volumes.sum()) < 0.0)
    inward = (volumes < 0.0) != flip
    if inward.any():
        flip ^= _Parts(vertices, faces, part).to_turn(inward)
    found = faces.copy()
    found[flip[part]] = faces[flip[part], ::-1]
    return Oriented(found, 0 if flip.all() else int(flip.sum()))


class _Parts:
    """The parts of a mesh, of which some may be inside out."""

    def __init__(self, vertices: Array, faces: Indices, part: Indices) -> None:
        self.corners = vertices[faces]
        self.part = part
        self.count = int(part.max()) + 1
        self.size = float(np.ptp(vertices, axis=0).max())

    def to_turn(self, inward: Flags) -> Flags:
        """Return which parts to turn, of those whose normals point inward or all others."""
        if self.count > MOST_PARTS:
            raise MeshFault(
                f"the mesh has {self.count:,} parts, and {int(inward.sum()):,} of them are inside "
                f"out or hollow; that is told for {MOST_PARTS} parts at most",
                "turn all normals outward, or save fewer parts in one file",
            )
        inside = [self._around(one) for one in range(self.count)]  # of which others
        outermost = np.array([not bool(others.any()) for others in inside])
        turned = np.zeros(self.count, dtype=np.bool_)
        for one in range(self.count):
            roots = inside[one] & outermost
            roots[one] |= outermost[one]
            ways = inward[roots]
            if not len(ways) or bool(ways.any()) != bool(ways.all()):
                self._refuse(one, "lies in two others, of which one is inside out")
            turned[one] = bool(ways.all())
        for one in np.flatnonzero(inward | (inward ^ turned)).tolist():
            if self._meets_others(one):
                self._refuse(one, "is inside out, and cuts through another part")
        sign = np.where(inward ^ turned, -1, 1)
        for one in np.flatnonzero(sign < 0).tolist():
            if int(sign[inside[one]].sum()) < 1:
                self._refuse(one, "is inside out: its normals point inward, with no material round")
        return turned

    def _around(self, one: int) -> Flags:
        """Return which other parts a part is inside of."""
        own = self.corners[self.part == one]
        middles = own.mean(axis=1)
        times = np.zeros(self.count)
        sure = np.zeros(self.count, dtype=np.bool_)
        sure[one] = True
        for point in middles[:: max(1, len(middles) // MOST_ASKED)]:
            some = np.bincount(self.part, shares(self.corners, point), self.count)
            clear = ~sure & (np.abs(some - np.round(some)) < WHOLE)
            times[clear], sure = some[clear], sure | clear
            if sure.all():
                break
        return np.abs(times) > 0.5

    def _meets_others(self, one: int) -> bool:
        """Return whether the surface of a part and that of another cut through each other."""
        own, others = self.corners[self.part == one], self.corners[self.part != one]
        low, high = own.min(axis=(0, 1)), own.max(axis=(0, 1))
        near = (others.min(axis=1) <= high).all(axis=1) & (others.max(axis=1) >= low).all(axis=1)
        others = others[near]
        if not len(others):
            return False
        lower, upper = others.min(axis=1), others.max(axis=1)
        step = max(1, AT_ONCE // len(others))
        for first in range(0, len(own), step):
            some = own[first : first + step]
            meet = (some.min(axis=1)[:, None] <= upper) & (some.max(axis=1)[:, None] >= lower)
            i, j = np.nonzero(meet.all(axis=2))
            close = CLOSE * self.size
            if _pierces(some[i], others[j], close) or _pierces(others[j], some[i], close):
                return True
        return False

    def _refuse(self, one: int, what: str) -> None:
        near = self.corners[self.part == one].mean(axis=(0, 1))
        place = ", ".join(f"{value:.1f}" for value in near)
        raise MeshFault(f"a part of the mesh near ({place}) mm {what}", REMEDY)


def _pierces(triangles: Array, others: Array, close: float) -> bool:
    """Return whether an edge of one triangle goes through its other one, of pairs (k, 3, 3)."""
    a, b, c = others.transpose(1, 0, 2)
    normal = np.cross(b - a, c - a)
    size = np.linalg.norm(normal, axis=1)
    good = size > 0.0
    a, b, c, normal, some = a[good], b[good], c[good], normal[good], triangles[good]
    normal /= size[good, None]
    height = np.einsum("kij,kj->ki", some - a[:, None], normal)
    for k in range(3):
        p, q, hp, hq = some[:, k], some[:, k - 1], height[:, k], height[:, k - 1]
        through = (np.minimum(hp, hq) < -close) & (np.maximum(hp, hq) > close)
        share = np.where(through, hp / np.where(through, hp - hq, 1.0), 0.0)
        at = p + share[:, None] * (q - p)
        for u, v in ((a, b), (b, c), (c, a)):
            side = np.einsum("ki,ki->k", np.cross(v - u, at - u), normal)
            through &= side >= -close * np.linalg.norm(v - u, axis=1)
        if through.any():
            return True
    return False
