"""Did you mean: the nearest of the names that exist."""

from collections.abc import Iterable
from functools import lru_cache


@lru_cache(maxsize=20_000)  # the same slip comes again and again
def edit_distance(a: str, b: str, limit: int) -> int:
    """Return the Damerau-Levenshtein distance (optimal string alignment), or limit + 1 if above."""
    if abs(len(a) - len(b)) > limit:
        return limit + 1
    before: list[int] = []
    row = list(range(len(b) + 1))
    for i, x in enumerate(a, 1):
        following = [i]
        for j, y in enumerate(b, 1):
            best = min(row[j] + 1, following[j - 1] + 1, row[j - 1] + (x != y))
            if i > 1 and j > 1 and x == b[j - 2] and a[i - 2] == y:
                best = min(best, before[j - 2] + 1)
            following.append(best)
        if min(following) > limit:
            return limit + 1
        before, row = row, following
    return row[-1]


def nearest(word: str, names: Iterable[str]) -> str | None:
    """Return the name a writer most likely meant, or None.

    Of names as near, swapped letters are likelier than one left out (`SQTR` is SQRT, not SQR);
    other ties go to the first in the alphabet.

    One slip is allowed in a word of up to five letters, two in longer ones; a word of two letters
    or fewer only for letters swapped or one letter added.
    """
    found = near(word, names)
    letters = sorted(word)
    return (
        min(found, key=lambda one: (one[0], sorted(one[1]) != letters, one[1]))[1]
        if found
        else None
    )


def near(word: str, names: Iterable[str]) -> list[tuple[int, str]]:
    """Return all names that a word may be a slip for, with the number of slips."""
    limit = 1 if len(word) <= 5 else 2
    found: list[tuple[int, str]] = []
    for name in names:
        if name == word:
            continue
        distance = edit_distance(word, name, limit)
        if distance > limit or (len(word) <= 2 and distance and len(name) <= len(word)):
            continue
        found.append((distance, name))
    return found
