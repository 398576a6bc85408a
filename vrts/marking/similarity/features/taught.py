"""Values that somebody taught: locations and joint positions, as numbers in a file."""

import math
import re
from collections.abc import Iterator
from typing import NamedTuple

from vrts.base.source import Span
from vrts.lang.reading.sections.lines import Line
from vrts.marking.similarity.symbols import Readable

MOST_VALUES = 2_000  # of a program
LEAST_NUMBERS = 3  # in a row: a position
DECIMALS = 2  # 0.01 mm and 0.01 degrees

# nothing is taken back: a long line takes time by its length, not by its square
_NUMBER = r"[-+]?(?:\d++(?:\.\d*+)?|\.\d++)(?:[eE][-+]?\d++)?+"
_ROW = re.compile(
    rf"(?P<name>[$#]?[A-Za-z][\w.]*+)(?:\[[^\]]*+\])?+[ \t]*+(?:=[ \t]*+)?+"
    rf"(?P<numbers>{_NUMBER}(?:[ \t,]++{_NUMBER})*+)[ \t]*+$",
    re.ASCII,
)
_CALL = re.compile(
    rf"(?P<name>#?PPOINT|TRANS)[ \t]*\([ \t]*"
    rf"(?P<numbers>{_NUMBER}(?:[ \t]*,[ \t]*{_NUMBER})*)[ \t]*\)",
    re.ASCII | re.IGNORECASE,
)
_ONE = re.compile(_NUMBER)


class Taught(NamedTuple):
    """A value, and where it stands."""

    numbers: tuple[float, ...]  # mm and degrees, rounded
    name: str  # of the location, or the function that makes it
    line: int


def taught(file: Readable) -> tuple[Taught, ...]:
    """Return the first values of a file, each once."""
    found: dict[tuple[float, ...], Taught] = {}
    for section in file.sections:
        for line in section.lines:
            number = 0
            for name, numbers in _values(section.kind, line):
                number = number or Span(file.source, line.start, line.end).line
                found.setdefault(numbers, Taught(numbers, name, number))
            if len(found) >= MOST_VALUES:
                return tuple(found.values())
    return tuple(found.values())


def _values(kind: str, line: Line) -> Iterator[tuple[str, tuple[float, ...]]]:
    if kind in ("reals", "strings"):
        return
    matches = [_ROW.match(line.text)] if kind != "program" else _CALL.finditer(line.text)
    for match in matches:
        if match is None:
            continue
        numbers = tuple(_rounded(text) for text in _ONE.findall(match["numbers"]))
        if len(numbers) >= LEAST_NUMBERS and any(numbers) and all(map(math.isfinite, numbers)):
            yield match["name"], numbers


def _rounded(text: str) -> float:
    return round(float(text), DECIMALS) + 0.0
