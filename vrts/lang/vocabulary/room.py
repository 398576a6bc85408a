"""How many operands an instruction has room for, as its usage says: `GLINE (unit) x, y, x, y`."""

from functools import cache
from typing import NamedTuple

from vrts.lang.vocabulary.word import Word

ANY = "..."  # at the end of a list in a usage: and more of the kind


class Room(NamedTuple):
    """Largest numbers of operands; None is any number."""

    unit: int | None  # in the parentheses behind the word
    operands: int | None
    given: int | None  # behind `=`
    equal: bool | None  # whether `=` belongs there; None: nobody knows


@cache
def room_of(word: Word) -> Room:
    """Return the room that the usage of a word leaves."""
    rest = word.usage[len(word.text) :].strip()
    unit: int | None = 0
    if not rest and word.dialects == "a":  # lists of AS name some words without their operands
        return Room(0, None, None, None)
    if rest.startswith("("):
        inner, _, rest = rest[1:].partition(")")
        unit = _count(inner)
    left, equal, right = rest.partition("=")
    return Room(unit, _count(left), _count(right), bool(equal))


def _count(items: str) -> int | None:
    if ANY in items:
        return None
    depth, commas = 0, 0
    for sign in items:
        depth += (sign == "[") - (sign == "]")
        commas += sign == "," and not depth
    return commas + 1 if items.strip() else 0
