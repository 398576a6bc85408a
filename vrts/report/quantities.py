"""Numbers as reports write them: rounded by the rule that marks use, with a unit.

The rule: 1 ms, 0.01 mm, 0.01 degrees (vrts/README.md, Conventions).
"""

from collections.abc import Mapping, Sequence
from fractions import Fraction

from vrts.base.diagnostic import Datum, Moment
from vrts.base.units import deg, mm

MINUS = "−"  # U+2212, as wide as the digits

DECIMALS = {"_s": 3, "_m": 5, "_mm": 2, "_deg": 2, "_deg_s": 2, "_mm_s": 2, "_rad": 4}
OTHER_DECIMALS = 6


def seconds(time_s: float) -> float:
    """Return a time rounded to 1 ms."""
    return round(time_s, 3) + 0.0


def millimetres(length_m: float) -> float:
    """Return a length in mm, rounded to 0.01 mm."""
    return round(mm(length_m), 2) + 0.0


def degrees(angle_rad: float) -> float:
    """Return an angle in degrees, rounded to 0.01 degrees."""
    return round(deg(angle_rad), 2) + 0.0


def at_time(time_s: float) -> str:
    """Return a time for a sentence: `at 12.4 s`."""
    return f"at {time_s:.1f} s"


def when(moment: Moment) -> str:
    """Return the time of a moment for a sentence: `at 12.4 s`, `deepest at 12.4 s`."""
    return f"deepest {at_time(moment.time_s)}" if moment.deepest else at_time(moment.time_s)


def points(value: Fraction) -> str:
    """Return points with one decimal, or two where one would hide something: `1.5`, `0.67`."""
    hundredths = round(value * 100)
    return f"{hundredths / 100:.1f}" if hundredths % 10 == 0 else f"{hundredths / 100:.2f}"


def lost(value: Fraction) -> str:
    """Return points lost, signed: `−1.5`. A gain (rounding in favour) shows as `+0.02`."""
    if value == 0:
        return "0.0"
    return (MINUS if value > 0 else "+") + points(abs(value))


def mark(value: Fraction) -> str:
    """Return a mark with its one decimal: `8.5`."""
    return f"{float(value):.1f}"


def full(total: Fraction) -> str:
    """Return how many points a mark is out of: `10`, `12.5`."""
    return f"{float(total):g}"


def rounded_data(data: Mapping[str, Datum]) -> dict[str, object]:
    """Return a diagnostic's or verdict's exact values, rounded by the unit in their names."""
    return {name: _rounded(value, _decimals(name)) for name, value in data.items()}


def _decimals(name: str) -> int:
    endings = [ending for ending in DECIMALS if name.endswith(ending)]
    return DECIMALS[max(endings, key=len)] if endings else OTHER_DECIMALS


def _rounded(value: Datum, decimals: int) -> object:
    match value:
        case float():
            return round(value, decimals) + 0.0 if abs(value) < float("inf") else str(value)
        case tuple():
            return [_rounded(item, decimals) for item in value]
        case _:
            return value


def joint_degrees(configuration: Sequence[float]) -> list[float]:
    """Return the six joint positions of a configuration in degrees."""
    return [degrees(value) for value in configuration[:6]]
