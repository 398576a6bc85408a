"""Passages of one place: when a run came there, and which of them are to stop at."""

from bisect import bisect_left, bisect_right
from collections.abc import Callable, Iterator, Sequence
from typing import NamedTuple

import numpy as np

from vrts.debug.breakpoints import Resolved, counts, passes
from vrts.debug.conditions.expression import Expression
from vrts.debug.conditions.hearing import Hear
from vrts.debug.evaluating import CannotTell
from vrts.debug.passages import Instant, Passages
from vrts.engine.memory.trace import Activation
from vrts.engine.run import Run

OFTEN = 256  # passages that are looked at before somebody is heard again


class Came(NamedTuple):
    """A passage: when, and which program came there."""

    instant: Instant
    process: bool = False
    text: str = ""  # what there is to say of it
    call: Activation | None = None  # the call that it is about, where that is not the innermost


class Chosen(NamedTuple):
    """A passage that is to stop at."""

    number: int  # of the passages of its place
    text: str = ""  # what went wrong with its condition


class Place:
    """All passages of one place, with what was found out about each; kept as long as its run."""

    def __init__(self, came: Sequence[Came], condition: Expression | None, hits: str) -> None:
        """Take passages in order, and which of them count."""
        self.came = came
        self._condition, self._hits = condition, hits.strip()
        self._known = bytearray(len(came))  # 0: not looked at; else one of the three below
        self._problems: dict[int, str] = {}
        self._counted: list[int] | None = None  # those that the hits choose

    def following(self, instant: Instant, look: "Look") -> Chosen | None:
        """Return the first one after an instant."""
        begin = bisect_right(self.came, instant, key=lambda came: came.instant)
        if self._hits:
            counted = self._all(look)
            k = bisect_left(counted, begin)
            return self._chosen(counted[k]) if k < len(counted) else None
        return self._first(range(begin, len(self.came)), look)

    def before(self, instant: Instant, look: "Look") -> Chosen | None:
        """Return the last one before an instant."""
        end = bisect_left(self.came, instant, key=lambda came: came.instant)
        if self._hits:
            counted = self._all(look)
            k = bisect_left(counted, end)
            return self._chosen(counted[k - 1]) if k else None
        return self._first(range(end - 1, -1, -1), look)

    def passed(self, begin: Instant, end: Instant, look: "Look") -> Iterator[Came]:
        """Return those after an instant, up to another one."""
        first = bisect_right(self.came, begin, key=lambda came: came.instant)
        last = bisect_right(self.came, end, key=lambda came: came.instant)
        if self._hits:
            counted = self._all(look)
            kept = counted[bisect_left(counted, first) : bisect_left(counted, last)]
            yield from (self.came[k] for k in kept)
        elif self._condition is None:
            yield from self.came[first:last]
        else:
            yield from (self.came[k] for k in range(first, last) if self._holds(k, look))

    def _first(self, order: range, look: "Look") -> Chosen | None:
        found = next((k for k in order if self._holds(k, look)), None)
        return None if found is None else self._chosen(found)

    def _chosen(self, k: int) -> Chosen:
        return Chosen(k, self._problems.get(k, ""))

    def _all(self, look: "Look") -> list[int]:
        """Return the passages that the hits choose, counted from the beginning of the run."""
        if self._counted is None:
            counted: list[int] = []
            hit = 0
            for k in range(len(self.came)):
                if self._holds(k, look):
                    if k in self._problems:  # nobody knows whether it counts
                        counted.append(k)
                        continue
                    hit += 1
                    if counts(self._hits, hit):
                        counted.append(k)
            self._counted = counted
        return self._counted

    def _holds(self, k: int, look: "Look") -> bool:
        if self._condition is None:
            return True
        if not self._known[k]:
            self._known[k] = self._worked_out(self._condition, k, look)
        return self._known[k] != _FALSE

    def _worked_out(self, condition: Expression, k: int, look: "Look") -> int:
        came = self.came[k]
        try:
            value = condition.value(came.instant, look.activation(came), look.heard)
        except CannotTell as problem:
            self._problems[k] = f"the condition cannot be worked out: {problem}"
            return _PROBLEM
        return _FALSE if value == 0.0 else _TRUE


_FALSE, _TRUE, _PROBLEM = 1, 2, 3


class Look:
    """How passages of a run are looked at, and who is heard meanwhile."""

    def __init__(self, run: Run, hear: Hear) -> None:
        """Take a run."""
        self._traces = run.history.robot.trace, run.history.process.trace
        self._hear = hear
        self._count = 0
        self.heard: Callable[[], None] = hear

    def activation(self, came: Came) -> Activation | None:
        """Return the call that sees it; now and then hear who wants no answer any more."""
        self._count += 1
        if self._count % OFTEN == 0:
            self._hear()
        if came.call is not None:
            return came.call
        return self._traces[came.process].activation(came.instant.finished)


def came_to(run: Run, both: Sequence[Passages], resolved: Resolved) -> list[Came]:
    """Return the passages of a line by the robot program and the process control program."""
    found: list[Came] = []
    for passages in both:
        numbers = np.asarray(passes(passages, resolved), np.int64)
        if len(numbers):
            finished = passages.reached[numbers]
            times = _times(run, finished)
            found += [
                Came(Instant(time_s, count), passages.is_process)
                for time_s, count in zip(times, finished.tolist(), strict=True)
            ]
    return sorted(found) if len(both) > 1 else found


def _times(run: Run, finished: "np.typing.NDArray[np.int64]") -> list[float]:
    """Return what `History.time_of` does, for many at once."""
    history = run.history
    known = np.asarray(history.counts, np.int64)
    ticks = np.asarray(history.ticks, np.int64)
    k = np.searchsorted(known, finished - 1, side="right")
    there = (finished > 0) & (k < len(ticks))
    if not len(ticks):
        return [0.0] * len(finished)
    times = ticks[np.minimum(k, len(ticks) - 1)] * history.tick_s
    return np.where(there, times, 0.0).tolist()
