"""Measurements are rounded before anything is scored or written: 1 ms, 0.01 mm, 0.01 degrees.

So engines, machines and operating systems give the same mark.
"""

from fractions import Fraction

from vrts.base.units import deg, mm


def exact_mm(length_m: float) -> Fraction:
    """Return a length in mm, to 0.01."""
    return Fraction(round(mm(length_m) * 100), 100)


def exact_deg(angle_rad: float) -> Fraction:
    """Return an angle in degrees, to 0.01."""
    return Fraction(round(deg(angle_rad) * 100), 100)


def exact_s(time_s: float) -> Fraction:
    """Return a time in s, to 1 ms."""
    return Fraction(round(time_s * 1000), 1000)
