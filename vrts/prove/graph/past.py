"""What outside decided on the way to a state: shared by all futures that went the same way."""

from typing import NamedTuple

from vrts.prove.proof import Decided


class Past(NamedTuple):
    """The last decision that made a difference, and those before it."""

    before: "Past | None"
    decided: Decided


def story(past: Past | None) -> tuple[Decided, ...]:
    """Return the decisions of a past, in time order."""
    found: list[Decided] = []
    while past is not None:
        found.append(past.decided)
        past = past.before
    found.reverse()
    found.sort(key=_time)  # what was so before may be asked later
    return tuple(found)


def _time(decided: Decided) -> float:
    return decided.time_s
