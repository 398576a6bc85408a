"""Convex pieces and angles as robot data writes them: in millimetres and degrees."""

import math

from vrts.base.pose import X_AXIS, Y_AXIS, Pose, Vector, rotation_about, translation
from vrts.base.units import DEG, MM
from vrts.geometry.shapes import Box, Cylinder, Hull, Piece
from vrts.robots.model import Configuration

FACETS = 24  # corners of a tapered round part; the polygon lies inside the circle by at most 0.9 %


def degrees(*values: float) -> Configuration:
    """Return six joint positions or speeds given in degrees."""
    a, b, c, d, e, f = (value * DEG for value in values)
    return (a, b, c, d, e, f)


def box(centre: Vector, half: Vector) -> Piece:
    """Return a box along the axes of its frame, by its centre and half extents [mm]."""
    return Piece(Box((half[0] * MM, half[1] * MM, half[2] * MM)), _at(centre))


def cylinder(centre: Vector, axis: str, radius: float, half_length: float) -> Piece:
    """Return a cylinder along an axis "x", "y" or "z" of its frame [mm]."""
    turn = {
        "x": rotation_about(Y_AXIS, math.pi / 2),
        "y": rotation_about(X_AXIS, -math.pi / 2),
        "z": rotation_about(X_AXIS, 0.0),
    }[axis]
    return Piece(Cylinder(radius * MM, half_length * MM), Pose(turn, _at(centre).translation))


def hull(points: list[Vector]) -> Piece:
    """Return the convex hull of points [mm]."""
    return Piece(Hull(tuple((x * MM, y * MM, z * MM) for x, y, z in points)), translation(0, 0, 0))


def _at(centre: Vector) -> Pose:
    return translation(centre[0] * MM, centre[1] * MM, centre[2] * MM)


def ring(radius: float, z: float) -> list[Vector]:
    """Return points on a circle about the z axis at a height [mm]."""
    steps = (math.tau * k / FACETS for k in range(FACETS))
    return [(radius * math.cos(a), radius * math.sin(a), z) for a in steps]
