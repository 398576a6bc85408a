"""Units at the edge. Inside, everything is in metres, radians and seconds."""

import math

MM = 1e-3  # [m]
INCH = 25.4e-3  # [m]
DEG = math.pi / 180.0  # [rad]


def mm(length_m: float) -> float:
    """Return a length in millimetres."""
    return length_m / MM


def deg(angle_rad: float) -> float:
    """Return an angle in degrees."""
    return angle_rad / DEG
