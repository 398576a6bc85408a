"""The kinds of things that stand in a workspace, as convex pieces.

The frame O of a thing is in the middle of its underside, z up.
"""

import math
from typing import NamedTuple

from vrts.base.pose import Y_AXIS, Pose, Vector, rotation_about, translation
from vrts.geometry.shapes import Box, Cylinder, Hull, Piece
from vrts.scene.colors import Color

LEG = 0.06  # [m] thickness of a table's legs
INSET = 0.04  # [m] of a table's legs from the edge of its top
RIM_PARTS = 24  # convex parts of a dish's round wall
FOOT_SHARE = 0.88  # of a dish's radius: its flat underside
RIM_START = 0.002  # [m] the wall begins above the underside, so that the dish stands on its foot
LIP = (0.008, 0.012)  # [m] thickness and height of the edge that ends a stand's plate
BOARD = 0.016  # [m] thickness of the boards under a stand's plate
FLOOR_SIDE = 8.0  # [m]
FLOOR_THICKNESS = 0.1  # [m]


class Form(NamedTuple):
    """The shape of a thing, in O."""

    pieces: tuple[Piece, ...]
    centre_of_mass: Vector  # [m]
    symmetry_axis: Vector | None  # turning about it changes nothing
    height: float  # [m]
    paint: tuple[Color, ...] = ()  # of each piece; empty: all have the object's colour
    grips: tuple[Pose, ...] = ()  # of the pads, where the file says how it is held


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


def dish(radius: float, height: float, wall: float) -> Form:
    """Return a round dish: a flat foot, and a wall that leans outward to the rim.

    Args:
        radius: Of the rim, outside [m].
        height: Of the rim above the underside [m].
        wall: Thickness of foot and wall [m].
    """
    foot = FOOT_SHARE * radius
    pieces = [Piece(Cylinder(foot, wall / 2), translation(0.0, 0.0, wall / 2))]
    rings = ((foot, RIM_START), (foot - wall, RIM_START), (radius, height), (radius - wall, height))
    for part in range(RIM_PARTS):
        ends = [math.tau * (part + end) / RIM_PARTS for end in (0, 1)]
        points = tuple(
            (r * math.cos(turn), r * math.sin(turn), z) for r, z in rings for turn in ends
        )
        pieces.append(Piece(Hull(points), translation(0.0, 0.0, 0.0)))
    return Form(tuple(pieces), (0.0, 0.0, height / 3), (0.0, 0.0, 1.0), height)


def stand(x: float, y: float, height: float, thickness: float, slope: float) -> Form:
    """Return a tilted stand: a plate on two boards, lower toward -x, with a lip at its low end.

    The first piece is the plate; its upper side is where things stand.

    Args:
        x: Length of the plate along its slope [m].
        y: Its width [m].
        height: Of the middle of its upper side [m].
        thickness: Of the plate [m].
        slope: Angle to the level [rad].
    """
    turned = Pose(rotation_about(Y_AXIS, -slope), (0.0, 0.0, height))
    plate = Piece(
        Box((x / 2, y / 2, thickness / 2)), turned @ translation(0.0, 0.0, -thickness / 2)
    )
    lip_x, lip_z = LIP
    lip = Piece(
        Box((lip_x / 2, y / 2, (lip_z + thickness) / 2)),
        turned @ translation(-(x + lip_x) / 2, 0.0, (lip_z - thickness) / 2),
    )
    boards: list[Piece] = []
    for end in (-1, 1):
        at, _, top = turned.apply((end * (x / 2 - 2 * BOARD), 0.0, -thickness))
        boards.append(
            Piece(Box((BOARD / 2, y / 2 - BOARD, top / 2)), translation(at, 0.0, top / 2))
        )
    highest = height + x / 2 * math.sin(slope)
    return Form((plate, lip, *boards), (0.0, 0.0, height / 2), None, highest)


def floor() -> Form:
    """Return a floor whose upper side is O's level z = 0."""
    half = FLOOR_SIDE / 2
    piece = Piece(
        Box((half, half, FLOOR_THICKNESS / 2)), translation(0.0, 0.0, -FLOOR_THICKNESS / 2)
    )
    return Form((piece,), (0.0, 0.0, -FLOOR_THICKNESS / 2), None, 0.0)
