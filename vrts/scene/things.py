"""The kinds of things that stand in a workspace, as convex pieces.

The frame O of a thing is in the middle of its underside, z up.
"""

from typing import NamedTuple

from vrts.base.pose import Vector, translation
from vrts.geometry.shapes import Box, Cylinder, Piece

LEG = 0.06  # [m] thickness of a table's legs
INSET = 0.04  # [m] of a table's legs from the edge of its top
FLOOR_SIDE = 8.0  # [m]
FLOOR_THICKNESS = 0.1  # [m]


class Form(NamedTuple):
    """The shape of a thing, in O."""

    pieces: tuple[Piece, ...]
    centre_of_mass: Vector  # [m]
    symmetry_axis: Vector | None  # turning about it changes nothing
    height: float  # [m]


def upright_cylinder(radius: float, height: float) -> Form:
    """Return a can or a round base. Lengths in m."""
    piece = Piece(Cylinder(radius, height / 2), translation(0.0, 0.0, height / 2))
    return Form((piece,), (0.0, 0.0, height / 2), (0.0, 0.0, 1.0), height)


def upright_box(x: float, y: float, z: float) -> Form:
    """Return a box of edge lengths x, y, z [m]."""
    piece = Piece(Box((x / 2, y / 2, z / 2)), translation(0.0, 0.0, z / 2))
    return Form((piece,), (0.0, 0.0, z / 2), None, z)


def table(x: float, y: float, height: float, thickness: float, *, legs: bool) -> Form:
    """Return a table: a top on four legs, or a solid block without legs. Lengths in m."""
    if not legs:
        return upright_box(x, y, height)
    top = Piece(Box((x / 2, y / 2, thickness / 2)), translation(0.0, 0.0, height - thickness / 2))
    below = height - thickness
    dx, dy = x / 2 - INSET - LEG / 2, y / 2 - INSET - LEG / 2
    stand = tuple(
        Piece(Box((LEG / 2, LEG / 2, below / 2)), translation(sx * dx, sy * dy, below / 2))
        for sx in (-1, 1)
        for sy in (-1, 1)
    )
    return Form((top, *stand), (0.0, 0.0, height - thickness / 2), None, height)


def floor() -> Form:
    """Return a floor whose upper side is O's level z = 0."""
    half = FLOOR_SIDE / 2
    piece = Piece(
        Box((half, half, FLOOR_THICKNESS / 2)), translation(0.0, 0.0, -FLOOR_THICKNESS / 2)
    )
    return Form((piece,), (0.0, 0.0, -FLOOR_THICKNESS / 2), None, 0.0)
