"""Hulls that stand for balls and meshes of a description."""

import numpy as np

from vrts.geometry.shapes import Hull
from vrts.geometry.thin import sphere, thinned
from vrts.robots.urdf.description import Shape, UrdfFault
from vrts.robots.urdf.stl import stl_points

MESH_TOLERANCE = 1e-3  # [m] by which a mesh may stand out of the hull that stands for it
THINNEST = 1e-4  # [m] of a mesh
GRID = 1e-5  # [m] to which corners of meshes are rounded, so that doubled corners are one
BALL_POINTS = 120  # of the hull round a sphere


def ball(radius: float) -> Hull:
    """Return a polyhedron round a sphere."""
    directions = sphere(BALL_POINTS)
    inside = float((directions @ sphere(4 * BALL_POINTS).T).max(axis=0).min())
    return Hull(tuple((x, y, z) for x, y, z in (directions * (radius / inside)).tolist()))


def mesh_hull(shape: Shape, data: bytes) -> Hull:
    """Return the hull of an STL mesh with few corners.

    Raises:
        UrdfFault: The file is not STL, or flat.
    """
    points = stl_points(data)
    if points is None:
        raise UrdfFault(f"mesh `{shape.file}` is not STL", shape.line)
    points = np.unique(np.round(points * np.array(shape.size) / GRID) * GRID, axis=0)
    spread = np.linalg.svd(points - points.mean(axis=0), full_matrices=False)[2]
    if min(float(np.ptp(points @ axis)) for axis in spread) < THINNEST:
        raise UrdfFault(f"mesh `{shape.file}` is flat", shape.line)
    return Hull(tuple((x, y, z) for x, y, z in thinned(points, MESH_TOLERANCE).tolist()))
