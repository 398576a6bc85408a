"""Points as other systems read them: exact, without the noise of floating point."""

import re
from fractions import Fraction

MOST_DECIMALS = 6
_NUMBER = re.compile(r"-?(\d+)([.,](\d+))?")
_DOUBTFUL = re.compile(r"-?[1-9]\d{0,2}([.,])\d{3}")  # decimals, or a thousand
_PARTED = re.compile(r"-?\d{1,3}(?:(?:,\d{3})+\.|(?:\.\d{3})+,)\d+")


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


class Doubtful(Exception):  # noqa: N818 -- names the situation
    """A number that can be read in two ways."""

    def __init__(self, text: str) -> None:
        """Keep both readings: with thousands, and with decimals."""
        super().__init__(text)
        whole = Fraction(text.replace(",", "").replace(".", ""))
        self.values = (whole, Fraction(text.replace(",", ".")))


def parsed(text: str) -> Fraction | None:
    """Return the number that a field holds, with a decimal point or comma; None: it holds none.

    Of two signs the last one is that of decimals, as in 1,234.50.
    """
    plain = _whole_parted(text.strip(), tells(text))
    found = _NUMBER.fullmatch(plain)
    return None if found is None else Fraction(found[0].replace(",", "."))


def read_number(text: str, point: str = "", doubtful: str = ",") -> Fraction | None:
    """Return the number that a field holds; None: it holds none.

    Args:
        text: The field.
        point: What parts decimals there, "," or "."; "": that is not known.
        doubtful: Signs that may also part thousands, where it is not known.

    Raises:
        Doubtful: Both readings are numbers, such as of 1,234.
    """
    plain = text.strip()
    found = _DOUBTFUL.fullmatch(plain)
    if found is not None and not point and found[1] in doubtful:
        raise Doubtful(plain)
    return parsed(_whole_parted(plain, point))


def tells(text: str) -> str:
    """Return which decimal sign a number shows; "" where it shows none, or could be a thousand."""
    plain = text.strip()
    if _PARTED.fullmatch(plain):
        return plain[max(plain.rfind(","), plain.rfind("."))]
    found = _NUMBER.fullmatch(plain)
    if found is None or found[2] is None or _DOUBTFUL.fullmatch(plain):
        return ""
    return found[2][0]


def _whole_parted(text: str, point: str) -> str:
    """Return a number without what parts its thousands, if it is written so."""
    other = {",": ".", ".": ","}.get(point, "")
    sure = bool(other) and re.fullmatch(rf"-?\d{{1,3}}([{other}]\d{{3}})+([{point}]\d+)?", text)
    return text.replace(other, "") if sure else text
