"""`12,5` for 12.5: which commas of a text stand where a decimal point is meant."""

import re
from collections.abc import Iterator
from itertools import combinations, pairwise
from typing import NamedTuple

MOST_COMMAS = 12  # of a text that is looked at
MOST_WAYS = 500  # to choose among them
_COMMA = re.compile(r"(?<![\w.])(?P<whole>\d+),(?=(?P<part>\d+)(?![\w.]))|(?P<string>\"[^\"]*\")")
_USUAL = frozenset({"5", "25", "75"})  # fractions that people choose


class Reading(NamedTuple):
    """A text with points for some of its commas."""

    text: str
    sure: bool  # whether every other choice of so many commas is less likely
    score: int  # how likely it is


def readings(text: str) -> Iterator[Reading]:
    """Return a text with a point for one of its commas, the likeliest first; then with all."""
    yield from with_points(text, 1)
    for many in range(2, len(_commas(text)) + 1):
        yield from with_points(text, many)


def with_points(text: str, many: int) -> list[Reading]:
    """Return a text with points for so many of its commas between digits, the likeliest first."""
    commas = _commas(text)
    if not 0 < many <= len(commas) <= MOST_COMMAS:
        return []
    ways: list[tuple[int, int, tuple[int, ...]]] = []  # likelihood, last place, all places
    for chosen in combinations(commas, many):
        if len(ways) == MOST_WAYS:
            return []
        at = tuple(place for place, _ in chosen)
        if all(not text[one + 1 : other].isdecimal() for one, other in pairwise(at)):
            ways.append((sum(likely for _, likely in chosen), at[-1], at))
    ways.sort(reverse=True)
    parted = len(ways) == 1 or ", " in text  # whether other commas look otherwise
    scores = [score for score, _, _ in ways]
    return [
        Reading(_pointed(text, at), parted and scores.count(score) == 1 and not i, score)
        for i, (score, _, at) in enumerate(ways)
    ]


def likeliest(text: str, many: int) -> Reading | None:
    """Return the one text with points that is likelier than all others, if there is."""
    found = with_points(text, many)
    return found[0] if found and (not found[1:] or found[0].score > found[1].score) else None


def _commas(text: str) -> list[tuple[int, int]]:
    """Return the commas that may be decimal ones: their places, and how likely they are."""
    return [
        (comma.end() - 1, _likely(comma["whole"], comma["part"]))
        for comma in _COMMA.finditer(text)
        if comma["string"] is None
    ]


def _likely(whole: str, part: str) -> int:
    if not int(part):
        return 1 if int(whole) else 0
    return 3 if part in _USUAL else 2


def _pointed(text: str, places: tuple[int, ...]) -> str:
    signs = list(text)
    for place in places:
        signs[place] = "."
    return "".join(signs)
