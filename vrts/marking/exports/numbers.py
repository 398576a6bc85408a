"""Points as other systems read them: exact, without the noise of floating point."""

from fractions import Fraction

MOST_DECIMALS = 6


def decimal(value: Fraction, *, least: int = 0, most: int = MOST_DECIMALS, point: str = ".") -> str:
    """Return a number in decimals, rounded half away from 0.

    Args:
        value: The number.
        least: Decimals that are there also where they are 0.
        most: Decimals at most.
        point: Decimal point or comma.
    """
    scaled = int(abs(value) * 10**most + Fraction(1, 2))
    sign = "-" if value < 0 and scaled else ""
    whole, rest = divmod(scaled, 10**most)
    digits = f"{rest:0{most}d}" if most else ""
    kept = digits[:least] + digits[least:].rstrip("0")
    return f"{sign}{whole}{point if kept else ''}{kept}"


def number(value: Fraction) -> float | int:
    """Return a number for JSON: as its six decimals read, whole numbers without a point."""
    rounded = Fraction(decimal(value))
    return rounded.numerator if rounded.denominator == 1 else float(rounded)


def points(value: float) -> Fraction:
    """Return points of a result as they are written there."""
    return Fraction(repr(value))
