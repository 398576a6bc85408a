"""An oven whose door stands open, as convex pieces.

Its mouth looks toward -x. The first piece is the baking stone, on which things stand.
"""

from collections.abc import Iterator
from typing import NamedTuple

from vrts.base.pose import X_AXIS, Y_AXIS, Pose, Vector, rotation_about, translation
from vrts.base.units import DEG
from vrts.geometry.shapes import Box, Cylinder, Piece
from vrts.scene.colors import Color, known_color
from vrts.scene.things.forms import Form

WALL = 0.015  # [m] of sides, back and roof
LINTEL = 0.035  # [m] height of the panel above the mouth
STONE = 0.012  # [m] thickness of the stone
SHELF = 0.01  # [m] the stone is this much above the floor of the oven, in which the door is hinged
FOOT = (0.018, 0.012)  # [m] radius and height
DOOR = 0.012  # [m] thickness
PANE = 0.001  # [m] the window stands out of it
KNOB = (0.011, 0.014)  # [m] radius and length
KNOBS = (-0.3, 0.0, 0.3)  # of the width, from the middle
HEATER = 0.004  # [m] radius
BELOW = SHELF + STONE + FOOT[1] + DOOR  # [m] the stone is at least this high

TILE, GLASS, CHROME, GLOW = "#d9b79a", "#23282e", "#d5dade", "#e4572e"


class Oven(NamedTuple):
    """The measures of an oven [m]."""

    depth: float  # along x, without the door
    width: float  # along y
    height: float
    stone: float  # height of the upper side of the stone

    @property
    def mouth(self) -> float:
        """How high the mouth is: from the stone to the lower edge of the panel."""
        return self.height - WALL - LINTEL - self.stone

    @property
    def door(self) -> float:
        """How far the open door reaches out: it closes the mouth."""
        return self.mouth + SHELF


def oven(size: Oven, housing: Color) -> Form:
    """Return an oven with its door hanging open, level.

    Args:
        size: Its measures; the mouth must be higher than nothing.
        housing: Colour of what is neither stone nor glass nor metal, linear RGB.
    """
    parts = list(_parts(size, housing))
    return Form(
        tuple(piece for piece, _ in parts),
        (0.0, 0.0, size.height / 2),
        None,
        size.height,
        tuple(color for _, color in parts),
    )


def _parts(size: Oven, housing: Color) -> Iterator[tuple[Piece, Color]]:
    """Yield the pieces from below, the stone first."""
    front, back, half = -size.depth / 2, size.depth / 2, size.width / 2
    floor = size.stone - SHELF
    inside_low, inside_high = size.stone - STONE, size.height - WALL
    chrome = known_color(CHROME)
    yield (
        _block((front + WALL, -half + WALL, inside_low), (back - WALL, half - WALL, size.stone)),
        known_color(TILE),
    )
    radius, foot = FOOT
    for x in (front + 2 * radius, back - 2 * radius):
        for y in (-half + 2 * radius, half - 2 * radius):
            disc = Piece(Cylinder(radius, foot / 2), translation(x, y, foot / 2))
            yield disc, known_color(GLASS)
    yield _block((front, -half, foot), (back, half, inside_low)), housing
    yield _door(size, front, floor), housing
    yield _pane(size, front, floor), known_color(GLASS)
    yield _handle(size, front, floor), chrome
    yield _block((front, -half, inside_low), (back, -half + WALL, size.height)), housing
    yield _block((front, half - WALL, inside_low), (back, half, size.height)), housing
    inner = half - WALL
    yield _block((back - WALL, -inner, inside_low), (back, inner, inside_high)), housing
    for x in (-size.depth / 5, size.depth / 5):
        rod = _rod(Y_AXIS, inner, HEATER, (x, 0.0, inside_high - 3 * HEATER))
        yield rod, known_color(GLOW)
    low = inside_high - LINTEL
    yield _block((front, -inner, low), (front + WALL, inner, inside_high)), known_color(GLASS)
    radius, length = KNOB
    for share in KNOBS:
        place = (front - length / 2, share * size.width, low + LINTEL / 2)
        yield _rod(X_AXIS, length / 2, radius, place), chrome
    yield _block((front, -inner, inside_high), (back, inner, size.height)), housing


def _door(size: Oven, front: float, floor: float) -> Piece:
    inner = size.width / 2 - WALL
    return _block((front - size.door, -inner, floor - DOOR), (front, inner, floor))


def _pane(size: Oven, front: float, floor: float) -> Piece:
    """Return the window in the door, a little proud of it."""
    inner = size.width / 2 - WALL
    edge = size.door / 5
    return _block(
        (front - size.door + edge, -inner + edge, floor - DOOR / 2),
        (front - edge, inner - edge, floor + PANE),
    )


def _handle(size: Oven, front: float, floor: float) -> Piece:
    """Return the bar on the outside of the door, which looks down now."""
    low = floor - DOOR - 3 * HEATER
    place = (front - size.door + 4 * HEATER, 0.0, low + HEATER)
    return _rod(Y_AXIS, size.width / 3, HEATER, place)


def _block(low: Vector, high: Vector) -> Piece:
    half = ((high[0] - low[0]) / 2, (high[1] - low[1]) / 2, (high[2] - low[2]) / 2)
    return Piece(Box(half), translation(low[0] + half[0], low[1] + half[1], low[2] + half[2]))


def _rod(axis: Vector, half: float, radius: float, place: Vector) -> Piece:
    """Return a cylinder along x or y."""
    across = Y_AXIS if axis == X_AXIS else X_AXIS
    return Piece(Cylinder(radius, half), Pose(rotation_about(across, 90.0 * DEG), place))
