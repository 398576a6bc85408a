"""A pizza in its pan, as convex pieces.

Two fingers that open 80 mm cannot take a pizza by its edge and keep it level: the weight is half a
pizza away from them. They take the pan by its handle, a raised bar toward -x.
"""

import math

from vrts.base.pose import Vector, translation
from vrts.geometry.shapes import Box, Cylinder, Hull, Piece
from vrts.scene.colors import Color, known_color
from vrts.scene.things.forms import Form

PAN = 0.006  # [m] height of the pan
DOUGH = 0.016  # [m] height of the crust above the underside
CHEESE = 0.018  # [m] height of what lies on the dough
SALAMI = 0.0195  # [m] height of the slices
CRUST_SHARE = 0.93  # of the pan's radius
CHEESE_SHARE = 0.80
SLICE_SHARE = 0.14
RING_SHARE = 0.52  # where the outer slices lie
SLICES = 6  # round the one in the middle
ARM = 0.025  # [m] from the edge of the pan to the bar
BAR = (0.02, 0.022, 0.042)  # [m] width of the bar, and from where to where it is high
ROOT = 0.015  # [m] how far the arm of the handle reaches under the edge

IRON, CRUST, RED = "#3a3d42", "#c98f4e", "#a8322a"


def pizza(radius: float, handle: float, cheese: Color) -> Form:
    """Return a pizza in a pan with a handle.

    Args:
        radius: Of the pan [m].
        handle: Length of the handle, from the edge of the pan [m]; more than `ARM`.
        cheese: Colour of what lies on the dough, linear RGB.
    """
    width, low, high = BAR
    bar_x = (handle - ARM) / 2
    bar = Piece(
        Box((bar_x, width / 2, (high - low) / 2)),
        translation(-(radius + ARM + bar_x), 0.0, (low + high) / 2),
    )
    slices = [(0.0, 0.0), *_ring(RING_SHARE * radius)]
    pieces: list[tuple[Piece, Color]] = [
        (_disc(radius, 0.0, PAN), known_color(IRON)),
        (Piece(_arm(radius), translation(0.0, 0.0, 0.0)), known_color(IRON)),
        (bar, known_color(IRON)),
        (_disc(CRUST_SHARE * radius, PAN, DOUGH), known_color(CRUST)),
        (_disc(CHEESE_SHARE * radius, DOUGH, CHEESE), cheese),
    ]
    for x, y in slices:
        disc = _disc(SLICE_SHARE * radius, CHEESE, SALAMI)
        pieces.append((Piece(disc.shape, translation(x, y, 0.0) @ disc.X_OP), known_color(RED)))
    return Form(
        tuple(piece for piece, _ in pieces),
        (0.0, 0.0, DOUGH / 2),  # the handle is light [assumed]
        None,
        high,
        tuple(color for _, color in pieces),
    )


def _disc(radius: float, low: float, high: float) -> Piece:
    half = (high - low) / 2
    return Piece(Cylinder(radius, half), translation(0.0, 0.0, low + half))


def _arm(radius: float) -> Hull:
    """Return the slope from the edge of the pan up to the bar."""
    width, low, high = BAR
    edge, end = -(radius - ROOT), -(radius + ARM)
    corners: list[Vector] = []
    for y in (-width / 2, width / 2):
        corners += [(edge, y, PAN / 3), (edge, y, PAN), (end, y, low), (end, y, high)]
    return Hull(tuple(corners))


def _ring(radius: float) -> list[tuple[float, float]]:
    turns = [math.tau * number / SLICES for number in range(SLICES)]
    return [(radius * math.cos(turn), radius * math.sin(turn)) for turn in turns]
