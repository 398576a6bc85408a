"""What holds people up: losses of last attempts, brought together where they have one cause.

Sentences of one cause differ in when and where it was, and in numbers: so these are left out.
"""

from collections.abc import Iterable, Mapping
from fractions import Fraction
from functools import lru_cache
from hashlib import sha256
from typing import Final

from vrts.course.board.told import CauseTold
from vrts.desk.rows.causes import same_sentence
from vrts.live.store.course.attempts import Attempt

STUCK: Final = 3  # attempts in a row that lose by the same
KEPT: Final = 65_536  # attempts and sentences that need not be looked at again
_KEY: Final = 12  # digits


@lru_cache(maxsize=KEPT)
def cause_key(assignment: str, sentence: str) -> str:
    """Return a short name of a cause of an assignment."""
    return sha256(f"{assignment}\n{same_sentence(sentence)}".encode()).hexdigest()[:_KEY]


@lru_cache(maxsize=KEPT)
def lost(attempt: Attempt) -> Mapping[str, float]:
    """Return the points that an attempt has lost by each cause."""
    found: dict[str, float] = {}
    for loss in attempt.causes:
        key = cause_key(attempt.assignment, loss.cause)
        found[key] = found.get(key, 0.0) + abs(_number(loss.points))
    return found


def foremost(attempt: Attempt) -> str:
    """Return the cause that costs an attempt most; empty: it has lost nothing."""
    costs = lost(attempt)
    return max(costs, key=lambda key: (costs[key], key), default="")


def in_a_row(attempts: Iterable[Attempt], cause: str) -> int:
    """Return how many of the last attempts, in order, have lost by a cause."""
    count = 0
    for attempt in reversed([one for one in attempts if one.state == "marked"]):
        if cause not in lost(attempt):
            break
        count += 1
    return count


def causes_of(of: Mapping[int, Iterable[Attempt]], assignment: str) -> list[CauseTold]:
    """Return what costs points in the last marked attempts at an assignment, most students first.

    Args:
        of: Attempts by account, in the order of time.
        assignment: Its id.
    """
    points: dict[str, float] = {}
    words: dict[str, str] = {}
    who: dict[str, list[tuple[int, int]]] = {}  # how often in a row, and account
    for account, attempts in of.items():
        own = [one for one in attempts if one.assignment == assignment and one.state == "marked"]
        if not own:
            continue
        for loss in own[-1].causes:
            words.setdefault(cause_key(assignment, loss.cause), same_sentence(loss.cause))
        for key, cost in lost(own[-1]).items():
            points[key] = points.get(key, 0.0) + cost
            who.setdefault(key, []).append((in_a_row(own, key), account))
    told = [
        CauseTold(
            key,
            assignment,
            words[key],
            round(points[key], 1),
            tuple(account for _, account in sorted(those, key=lambda one: (-one[0], one[1]))),
            sum(times >= STUCK for times, _ in those),
        )
        for key, those in who.items()
    ]
    return sorted(told, key=lambda one: (-len(one.students), -one.points, one.key))


@lru_cache(maxsize=KEPT)
def _number(points: str) -> float:
    return float(Fraction(points))
