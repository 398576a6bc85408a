"""Whether a mesh passes through itself: how often it goes round what lies under its triangles.

Under a triangle, against its normal, is the material: the surface goes round it once. Where it goes
round less often, the mesh is inside out there, as a band is that crosses itself like an 8: what it
encloses there counts negative, and so do volume and centre of mass. Where it goes round more often,
solids overlap, and what they share counts more than once.
"""

from typing import NamedTuple, TypeAlias

import numpy as np
import numpy.typing as npt

from vrts.scene.meshes.winding import shares

Array: TypeAlias = npt.NDArray[np.float64]

MOST_ASKED = 400  # triangles: the largest ones, and some of all others
UNDER = 1e-5  # share of a triangle's size
WHOLE = 0.05  # nearer to a whole number of times, a point is not on another surface


class Passes(NamedTuple):
    """Where a mesh passes through itself, as far as its triangles that were asked show."""

    inside_out: Array | None  # a place under which nothing is, shape (3,), in mm
    shared: Array | None  # a place that solids share


def passes(corners: Array) -> Passes:
    """Return where a closed surface passes through itself.

    Args:
        corners: Of its triangles, normals outward, shape (m, 3, 3), in mm.
    """
    a, b, c = corners.transpose(1, 0, 2)
    normals = np.cross(b - a, c - a)
    sizes = np.linalg.norm(normals, axis=1)
    order = np.argsort(-sizes, kind="stable")
    order = order[sizes[order] > 0.0]
    rest = order[MOST_ASKED // 2 :]
    some = rest[:: max(1, -(-len(rest) // (MOST_ASKED // 2)))]
    inside_out = shared = None
    for k in (*order[: MOST_ASKED // 2].tolist(), *some.tolist()):
        middle = corners[k].mean(axis=0)
        point = middle - normals[k] / sizes[k] * (UNDER * float(np.sqrt(sizes[k])))
        times = float(shares(corners, point).sum())
        if abs(times - round(times)) > WHOLE:
            continue
        if round(times) < 1 and inside_out is None:
            inside_out = middle
        if round(times) > 1 and shared is None:
            shared = middle
    return Passes(inside_out, shared)
