"""Decimal numbers of mm and degrees to SI and back, each rounded once.

So every double has a decimal text that reads as it: a product of two doubles would skip some.
"""

from collections.abc import Callable
from decimal import Context, Decimal

from vrts.base.numbers import single

_DIGITS = Context(prec=60)
_PI = Decimal("3.14159265358979323846264338327950288419716939937510582097494459")
_MM = Decimal("0.001")
_DEGREE = _DIGITS.divide(_PI, Decimal(180))

FEWEST, MOST = 15, 22  # digits that are tried for a double
MOST_SINGLE = 9  # digits that tell single-precision numbers apart


def metres(text: str) -> float:
    """Return a decimal number of mm in m."""
    return float(_DIGITS.multiply(Decimal(text), _MM))


def radians(text: str) -> float:
    """Return a decimal number of degrees in rad."""
    return float(_DIGITS.multiply(Decimal(text), _DEGREE))


def millimetres_text(value: float) -> str:
    """Return the shortest decimal number of mm that reads as a length in m."""
    return _shortest(_DIGITS.divide(Decimal(value), _MM), value, metres)


def degrees_text(value: float) -> str:
    """Return the shortest decimal number of degrees that reads as an angle in rad."""
    return _shortest(_DIGITS.divide(Decimal(value), _DEGREE), value, radians)


def single_text(value: float) -> str:
    """Return the shortest decimal number that reads as a single-precision number."""
    for digits in range(1, MOST_SINGLE + 1):
        text = f"{value:.{digits}g}"
        if _as_single(text) == value:
            return _plain(text)
    raise AssertionError("nine digits tell all single-precision numbers apart")


def _shortest(exact: Decimal, value: float, read: Callable[[str], float]) -> str:
    for digits in range(FEWEST, MOST + 1):
        text = f"{exact:.{digits}g}"
        if read(text) == value:
            return _plain(text)
    raise AssertionError("so many digits tell all doubles apart")


def _as_single(text: str) -> float | None:
    try:
        return single(float(text))
    except OverflowError:
        return None  # rounded up beyond the largest one: more digits are needed


def _plain(text: str) -> str:
    """Return a number without exponent where it is short, without minus before zero."""
    number = Decimal(text).normalize()
    if number == 0:
        return "0"
    shown = f"{number:f}"
    return shown if len(shown) <= 24 else f"{number:E}"
