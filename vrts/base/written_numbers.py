"""Numbers as people and other programs write them: with a decimal point or comma, exactly."""

import re
from fractions import Fraction

_NUMBER = re.compile(r"-?(\d+)([.,](\d+))?")
_DOUBTFUL = re.compile(r"-?[1-9]\d{0,2}([.,])\d{3}")  # decimals, or a thousand
_PARTED = re.compile(r"-?\d{1,3}(?:(?:,\d{3})+\.|(?:\.\d{3})+,)\d+")


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
