"""Where things stand, as an operator measures it in front of the robot."""

import math
from typing import NamedTuple

from vrts.base.oat import oat_from_rotation
from vrts.base.pose import Pose, Rotation, multiply, rotate
from vrts.base.units import mm
from vrts.geometry.support import bounds
from vrts.scene.model import Body, Mobility, Scene

_DOWN: Rotation = (-1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, -1.0)  # half a turn about y


class Place(NamedTuple):
    """Where a body is to stand, in the robot's own frame: mm and degrees."""

    name: str
    title: str
    x: float  # of its middle
    y: float
    low: float  # Z of its lowest point
    high: float  # Z of its highest point
    size: tuple[float, float, float]  # of the box round it
    oat: tuple[float, float, float]  # of a hand that points at it from above, turned as it is
    carried: bool


def places(scene: Scene) -> tuple[Place, ...]:
    """Return where every body is to stand, what can be carried first; a floor is left out."""
    found = [_place(body) for body in scene.bodies if body.kind != "floor"]
    return tuple(sorted(found, key=lambda place: not place.carried))


def _place(body: Body) -> Place:
    box = bounds(body.pieces, body.X_WO)
    (x0, y0, z0), (x1, y1, z1) = box.lower, box.upper
    return Place(
        body.name,
        body.title,
        round(mm(0.5 * (x0 + x1)), 1) + 0.0,
        round(mm(0.5 * (y0 + y1)), 1) + 0.0,
        round(mm(z0), 1) + 0.0,
        round(mm(z1), 1) + 0.0,
        (round(mm(x1 - x0), 1), round(mm(y1 - y0), 1), round(mm(z1 - z0), 1)),
        _from_above(body.X_WO),
        body.mobility is Mobility.MOVABLE,
    )


def _from_above(X_WO: Pose) -> tuple[float, float, float]:
    """Return O, A, T of a hand over a body: pointing down, fingers closing along its y axis."""
    x, y, _ = rotate(X_WO.rotation, (0.0, 1.0, 0.0))
    turn = math.atan2(-x, y)
    s, c = math.sin(turn), math.cos(turn)
    level: Rotation = (c, -s, 0.0, s, c, 0.0, 0.0, 0.0, 1.0)
    o, a, t = oat_from_rotation(multiply(level, _DOWN))
    return (round(o, 1) + 0.0, round(a, 1) + 0.0, round(t, 1) + 0.0)
