"""Which variants are tried where there are too many for all: every value, and every two together.

A fault of a task that has variants is nearly always in one value, or in two that do not go
together [Kuhn2004]_. The set is made greedily [Cohen1997]_, each variant with as much that is new
as there is, and the same variants always give the same set.
"""

import math
from collections.abc import Callable, Mapping, Sequence
from itertools import chain, combinations
from typing import NamedTuple, TypeAlias

from vrts.check.variants.model import Combination, Variants

ALL = 100  # where there are no more variants than these, all are tried
MOST_ROWS = 300  # about so many variants are tried; wide ranges are thinned out for pairs
FEWEST = 2  # values of each of which pairs are taken: both ends
MOST_TRIES = 20_000  # values that are looked at to complete one variant
MOST_OF_ALL = 400_000  # and for all variants together

_Value: TypeAlias = tuple[int, int]  # what varies, and which of its choices
_News: TypeAlias = Callable[[int, Mapping[int, int]], Sequence[int]]
# choices of what varies that add something to a variant, those that add most first


class Covering(NamedTuple):
    """Variants in which every value is, and every pair of values."""

    combinations: tuple[Combination, ...]
    values: int  # how many are in one of them
    pairs: int
    never: int  # values and pairs that no student gets
    thinned: bool  # pairs only of some values of wide ranges: the ends, and some between
    given_up: int = 0  # values and pairs for which no variant was found, and that may have one


def covering(variants: Variants, most: int = MOST_ROWS) -> Covering:
    """Return a covering set of the variants that a student may get.

    Args:
        variants: Of a task.
        most: About how many variants there may be; every value is in one of them, whatever it is.
    """
    counts = [len(vary.choices) for vary in variants.varies]
    if variants.total <= min(ALL, most):
        return _all(variants, counts)
    width = _width(counts, most)
    chosen = [_spread(count, width) for count in counts]
    left = _Left(chosen)
    every, never, given_up = left.size, 0, 0
    search = _Search(variants, counts)
    rows: list[Combination] = []
    missing = [dict.fromkeys(range(count)) for count in counts]  # values in no variant yet
    while left.size and not search.exhausted:
        pair = left.fullest()
        row = search.row(dict(pair), left.news)
        if row is None:
            left.drop(*pair)
            never, given_up = never + (not search.gave_up), given_up + search.gave_up
            continue
        rows.append(row)
        left.take(row)
        for some, choice in zip(missing, row, strict=True):
            some.pop(choice, None)
    given_up += left.size
    pairs = every - never - given_up
    whole = sum(counts)
    for k, own in enumerate(missing):
        while own:
            choice = next(iter(own))
            row = search.row({k: choice}, lambda one, _: tuple(missing[one]))
            if row is None:
                del own[choice]
                whole -= 1
                never, given_up = never + (not search.gave_up), given_up + search.gave_up
                continue
            rows.append(row)
            for some, one in zip(missing, row, strict=True):
                some.pop(one, None)
    thinned = any(len(some) < count for some, count in zip(chosen, counts, strict=True))
    return Covering(tuple(rows), whole, pairs, never, thinned, given_up)


def _all(variants: Variants, counts: Sequence[int]) -> Covering:
    every = map(variants.combination, range(variants.total))
    rows = tuple(row for row in every if variants.allowed(row))
    values = {value for row in rows for value in enumerate(row)}
    pairs = {pair for row in rows for pair in combinations(enumerate(row), 2)}
    could = sum(counts) + sum(a * b for a, b in combinations(counts, 2))
    return Covering(rows, len(values), len(pairs), could - len(values) - len(pairs), thinned=False)


def _width(counts: Sequence[int], most: int) -> int:
    """Return of how many values of each the pairs are taken."""
    more = 1 + math.log2(len(counts)) / 4  # rows for each pair of the two that have most values
    width = max(counts)
    while width > FEWEST and more * math.prod(sorted(min(n, width) for n in counts)[-2:]) > most:
        width -= 1
    return width


def _spread(count: int, width: int) -> tuple[int, ...]:
    """Return so many of the numbers below a count, with both ends, as evenly as they go."""
    if count <= width:
        return tuple(range(count))
    return tuple(round(k * (count - 1) / (width - 1)) for k in range(width))


class _Left:
    """The pairs that are in no variant yet: for each value, the values that it is to be with."""

    def __init__(self, chosen: Sequence[Sequence[int]]) -> None:
        values = [[(k, choice) for choice in some] for k, some in enumerate(chosen)]
        self._with: dict[_Value, dict[_Value, None]] = {
            value: {other: None for j, more in enumerate(values) if j != k for other in more}
            for k, some in enumerate(values)
            for value in some
        }
        self.size = sum(map(len, self._with.values())) // 2
        self._chosen = chosen

    def fullest(self) -> tuple[_Value, _Value]:
        """Return the pair whose values have most left; of equal ones the first."""
        value = max(self._with, key=lambda one: len(self._with[one]))
        return value, max(self._with[value], key=lambda one: len(self._with[one]))

    def news(self, k: int, row: Mapping[int, int]) -> list[int]:
        """Return the choices that would add pairs to a variant, those that add most first."""
        worth = {
            choice: sum(other in others for other in row.items())
            for choice in self._chosen[k]
            if (others := self._with[k, choice])
        }
        return sorted((one for one in worth if worth[one]), key=lambda one: -worth[one])

    def take(self, row: Combination) -> None:
        """Leave out the pairs of a variant."""
        for pair in combinations(enumerate(row), 2):
            self.drop(*pair)

    def drop(self, one: _Value, other: _Value) -> None:
        """Leave out one pair."""
        if other in self._with.get(one, {}):
            del self._with[one][other], self._with[other][one]
            self.size -= 1


class _Search:
    """Completes variants that a student may get."""

    def __init__(self, variants: Variants, counts: Sequence[int]) -> None:
        self._rules = [rule.choices for rule in variants.without]
        self._counts = counts
        self._tries = 0
        self._of_all = 0
        self.gave_up = False  # the last time: what was asked for may be there all the same

    @property
    def exhausted(self) -> bool:
        """Whether nothing more is looked for."""
        return self._of_all > MOST_OF_ALL

    def row(self, start: Mapping[int, int], news: _News) -> Combination | None:
        """Return a variant with some choices, and otherwise with as much that is new as it can.

        None: no student gets one with these choices, or none was found.
        """
        self._tries = 0
        self.gave_up = self.exhausted
        row = dict(start)
        if self.gave_up or not self._allowed(row) or not self._completed(row, news):
            return None
        return tuple(row[k] for k in range(len(self._counts)))

    def _completed(self, row: dict[int, int], news: _News) -> bool:
        following = next((k for k in range(len(self._counts)) if k not in row), None)
        if following is None:
            return True
        count = self._counts[following]
        first = dict.fromkeys(news(following, row))
        rest = (choice for choice in range(count) if choice not in first)
        for choice in chain(first, rest):
            self._tries += 1
            self._of_all += 1
            if self.gave_up or self._tries > MOST_TRIES or self.exhausted:
                self.gave_up = True
                return False
            row[following] = choice
            if self._allowed(row) and self._completed(row, news):
                return True
            del row[following]
        return False

    def _allowed(self, row: dict[int, int]) -> bool:
        """Return whether no rule excludes these choices already."""
        return not any(
            all(k in row and row[k] in choices for k, choices in rule.items())
            for rule in self._rules
        )
