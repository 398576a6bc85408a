"""Which program is marked next: nobody's many hand-ins keep others waiting."""

from collections.abc import Sequence
from typing import NamedTuple

from vrts.live.store.course.attempts import Attempt


class Job(NamedTuple):
    """A program that is marked once, for everybody who handed it in."""

    assignment: str
    digest: str
    variant: str = ""  # tag


def in_order(waiting: Sequence[Attempt]) -> list[Job]:
    """Return the programs in the order in which they are marked.

    First everybody's first that waits, in the order of time, then everybody's second, and so on.

    Args:
        waiting: Attempts that wait, in the order of time.
    """
    turns: dict[int, int] = {}
    found: dict[Job, tuple[int, float]] = {}
    for one in waiting:
        who = one.account if one.by is None else one.by
        job = Job(one.assignment, one.digest, one.variant)
        if job in found:
            continue
        turns[who] = turns.get(who, -1) + 1
        found[job] = (turns[who], one.at)
    return sorted(found, key=lambda job: (*found[job], job))
