"""Every change of one thing, in order, and the instants before and after each."""

from bisect import bisect_right
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from typing import NamedTuple

from vrts.debug.passages import Instant, at_time, first_instant, instant_of
from vrts.engine.memory.events import Cause
from vrts.engine.run import Run

APART = 1e-6  # [s] so long before a change nothing of it has happened


class Moment(NamedTuple):
    """Something changes, at once or for a while."""

    instant: Instant  # right after it, or where it begins
    settled_s: float  # when it is over
    number: int | None = None  # the statement that did it; 0: data
    cause: Cause | None = None  # the step, where an event names it
    by: str = ""  # what did it, where no step did


@dataclass(frozen=True, slots=True)
class Track:
    """All changes of what a name stands for."""

    run: Run
    name: str  # in words: "`n`", "signal 5"
    read: Callable[[Instant], object]  # its value at an instant
    moments: Sequence[Moment]  # in order, no two at one instant

    def last(self, at: Instant) -> int | None:
        """Return the number of the last change that has begun at an instant."""
        found = bisect_right(self.moments, at, key=_instant)
        return found - 1 if found else None

    def following(self, at: Instant) -> int | None:
        """Return the number of the next change after an instant."""
        found = bisect_right(self.moments, at, key=_instant)
        return found if found < len(self.moments) else None

    def before(self, k: int) -> Instant:
        """Return an instant at which a change is to come, and none before it any more."""
        moment, run = self.moments[k], self.run
        if moment.number:
            found = instant_of(run, moment.number - 1)
        elif moment.instant.time_s <= APART:
            found = first_instant(run)
        else:
            found = at_time(run, moment.instant.time_s - APART)
        return max(found, self.moments[k - 1].instant) if k else found

    def after(self, k: int) -> Instant:
        """Return an instant at which a change is over, or the next one is about to begin."""
        moment = self.moments[k]
        if moment.settled_s <= moment.instant.time_s:
            return moment.instant
        end = moment.settled_s
        if k + 1 < len(self.moments):
            end = min(end, self.moments[k + 1].instant.time_s - APART)
        return max(moment.instant, at_time(self.run, end))


def joined(moments: Iterable[Moment]) -> list[Moment]:
    """Return changes in order; of several at one instant the last."""
    found: list[Moment] = []
    for moment in sorted(moments, key=_instant):
        if found and found[-1].instant == moment.instant:
            found.pop()
        found.append(moment)
    return found


def _instant(moment: Moment) -> Instant:
    return moment.instant
