"""The convex hull of any points, by Qhull: those that meet in slivers, too."""

from typing import TypeAlias

import numpy as np
import numpy.typing as npt

from vrts.scene.meshes.polytopes import Polytope

Array: TypeAlias = npt.NDArray[np.float64]

ONE_PLANE = 1e-9  # rounding of a plane to which it counts as another's


class FlatPoints(ValueError):  # noqa: N818 -- names what it is
    """The points lie in one plane, nearly."""


def hulled(points: Array) -> Polytope:
    """Return the convex hull of points, shape (n, 3), in mm.

    Raises:
        FlatPoints: They lie in one plane.
    """
    from scipy.spatial import ConvexHull, QhullError  # it need not be installed

    try:
        hull = ConvexHull(points)
    except (QhullError, ValueError) as refusal:
        raise FlatPoints(str(refusal).partition("\n")[0]) from refusal
    planes = np.unique(np.round(hull.equations / ONE_PLANE) * ONE_PLANE, axis=0)
    used = np.unique(hull.simplices)
    number = np.zeros(len(points), dtype=np.int64)
    number[used] = np.arange(len(used))
    corners = points[used]
    normals = planes[:, :3] / np.linalg.norm(planes[:, :3], axis=1, keepdims=True)
    offsets = (corners @ normals.T).max(axis=0)
    triangles = tuple((int(a), int(b), int(c)) for a, b, c in number[hull.simplices])
    return Polytope(corners, normals, offsets, triangles)


def volume(points: Array) -> float:
    """Return the volume of the hull of points that do not lie in one plane [mm^3]."""
    from scipy.spatial import ConvexHull  # it need not be installed

    return float(ConvexHull(points).volume)
