"""A value beside its limit, with as many digits as it takes to see which is more."""

from fractions import Fraction


def beside(
    value: Fraction, limit: Fraction, *, least: int = 1, most: int = 2, plain: bool = False
) -> tuple[str, str]:
    """Return two numbers in decimals that compare as the numbers do.

    10.4 beside 10 is `10.4` and `10`, never `10` and `10`.

    Args:
        value: What was measured.
        limit: What it is compared with.
        least: Decimals where they suffice.
        most: Decimals that a measurement has at most: numbers are not told apart beyond.
        plain: Whether the limit is shown with no more decimals than it has.
    """
    for decimals in range(least, most + 1):
        shown = _rounded(value, decimals), _rounded(limit, decimals)
        if _order(*shown) == _order(value, limit):
            break
    else:
        decimals, shown = most, (_rounded(value, most), _rounded(limit, most))
    needed = _needed(shown[1], 0 if plain else least, decimals)
    return _text(shown[0], decimals), _text(shown[1], needed)


def _needed(number: Fraction, least: int, most: int) -> int:
    """Return how many decimals a number has, from `least` to `most`."""
    return next((k for k in range(least, most) if not number * 10**k % 1), most)


def _order(a: Fraction, b: Fraction) -> int:
    return (a > b) - (a < b)


def _rounded(number: Fraction, decimals: int) -> Fraction:
    return Fraction(round(number * 10**decimals), 10**decimals)


def _text(number: Fraction, decimals: int) -> str:
    return f"{float(number):.{decimals}f}"
