"""Poses as 4 x 4 matrices: X Y Z in mm, and the angles O A T of AS and V+ (about Z, Y, Z)."""

import math

import numpy as np
import numpy.typing as npt

Frame = npt.NDArray[np.float64]


def turn(axis: str, degrees: float) -> Frame:
    """Return a turn about an axis."""
    s, c = math.sin(math.radians(degrees)), math.cos(math.radians(degrees))
    made = np.eye(4)
    i, j = {"x": (1, 2), "y": (2, 0), "z": (0, 1)}[axis]
    made[i, i], made[i, j], made[j, i], made[j, j] = c, -s, s, c
    return made


def shift(x: float, y: float, z: float) -> Frame:
    """Return a displacement."""
    made = np.eye(4)
    made[:3, 3] = x, y, z
    return made


def zyz(x: float, y: float, z: float, o: float, a: float, t: float) -> Frame:
    """Return a transformation as both manuals define it."""
    return shift(x, y, z) @ turn("z", o) @ turn("y", a) @ turn("z", t)
