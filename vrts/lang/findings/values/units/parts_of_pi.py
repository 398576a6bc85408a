"""Numbers that are a part of pi, as far as they are written: 1.57, 3.1416, 0.785."""

import math
from collections.abc import Sequence

from vrts.ir.module import Datum
from vrts.lang.meaning.name_uses import NameUses
from vrts.lang.names import key
from vrts.lang.syntax.expressions import Item, Name, Number, Parenthesised, Prefix

_PARTS = (1 / 6, 1 / 4, 1 / 3, 1 / 2, 2 / 3, 3 / 4, 1.0, 3 / 2, 2.0)  # of pi
_FEWEST_DIGITS = 3  # with fewer, a number is one of these by chance
_MOST_DIGITS = 8
_JOINTS = 6
_ANGLES = 3


def is_part_of_pi(written: str) -> bool:
    """Return whether a number is a usual part of pi, rounded or cut to the digits it has."""
    digits = written.lstrip("+-").partition(".")[2]
    if not digits.isdecimal() or len(written.lstrip("+-0.").replace(".", "")) < _FEWEST_DIGITS:
        return False
    value = abs(float(written))
    unit = 10.0 ** -min(len(digits), _MOST_DIGITS)
    return any(-0.51 * unit < part * math.pi - value < 1.01 * unit for part in _PARTS)


def number_written(types: NameUses, program: str | None, node: Item | None) -> str | None:
    """Return the digits of a number, or those of the one number that a variable is given."""
    while isinstance(node, Prefix | Parenthesised):
        node = node.operand if isinstance(node, Prefix) else node.inner
    if isinstance(node, Name) and node.text[0] not in "$#":
        if node.text.lower() in types.predefined:
            return None
        values = types.scope.entry(program, key(node.text)).values
        return number_written(types, None, values[0]) if _only_number(values) else None
    return types.problems.source.text[node.start : node.end] if isinstance(node, Number) else None


def first_in_radians(types: NameUses, program: str | None, angles: Sequence[Item | None]) -> int:
    """Return which of the angles of one place is the first part of pi, where all others are round.

    Angles that somebody taught are seldom round, so one of them may be 1.57 by chance. -1: none.
    """
    return _first([number_written(types, program, angle) for angle in angles])


def first_in_data(datum: Datum, *, joints: bool) -> int:
    """Return the like of a line of data, counted among all its values."""
    words = datum.span.text.replace(",", " ").replace("=", " ").split()[1:]
    if len(words) != _JOINTS:
        return -1
    skipped = 0 if joints else _JOINTS - _ANGLES
    found = _first(words[skipped:])
    return -1 if found < 0 else found + skipped


def _first(written: Sequence[str | None]) -> int:
    parts = [digits is not None and is_part_of_pi(digits) for digits in written]
    if True not in parts:
        return -1
    for digits, part in zip(written, parts, strict=True):
        if digits is not None and not part and not _is_round(digits):
            return -1
    return parts.index(True)


def _is_round(digits: str) -> bool:
    try:
        return float(digits) == round(float(digits))
    except ValueError:
        return False


def _only_number(values: Sequence[Item]) -> bool:
    if len(values) != 1:
        return False
    node = values[0]
    return isinstance(node.operand if isinstance(node, Prefix) else node, Number)
