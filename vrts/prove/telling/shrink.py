"""A counterexample without what it does not need: decisions are left out one by one."""

from collections.abc import Callable
from typing import TypeVar

from vrts.prove.proof import Decided, What

T = TypeVar("T")


def shrunk(
    story: tuple[Decided, ...], shows: Callable[[tuple[Decided, ...]], T | None], known: T
) -> tuple[tuple[Decided, ...], T]:
    """Return a story of which no decision can be left out, and what it shows.

    Args:
        story: What outside decided.
        shows: Replays a story; None: it does not show what is wrong.
        known: What the whole story shows.
    """
    k = len(story) - 1
    while k >= 0:
        if not _may_go(story[k]):
            k -= 1
            continue
        fewer = without(story, k)
        found = shows(fewer)
        if found is not None:
            story, known = fewer, found
        k = min(k, len(story)) - 1
    return story, known


def _may_go(decided: Decided) -> bool:
    """Return whether a decision may be left out alone.

    Without an answer or a draw later ones would be given to earlier questions. What follows on a
    stop goes with it, and without an execution the next one begins at another time.
    """
    if decided.what is What.STOP:
        return decided.value == "stop"
    return decided.what not in (What.ANSWER, What.RANDOM, What.AGAIN)


def without(story: tuple[Decided, ...], k: int) -> tuple[Decided, ...]:
    """Return a story without a decision, and without what then changes nothing."""
    left: list[Decided] = []
    known: dict[tuple[What, int], bool | float | str] = {}
    for n, decided in enumerate(story):
        if n == k or (n > k and decided.what is story[k].what is What.STOP):
            continue
        if decided.what in (What.INPUT, What.ANALOG):
            if known.get(decided[1:3], False) == decided.value:
                continue  # inputs are off at first, and analog ones read 0
            known[decided[1:3]] = decided.value
        left.append(decided)
    return tuple(left)
