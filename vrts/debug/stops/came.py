"""Passages of one place: when a run came there, and which of them are to stop at."""

from bisect import bisect_left, bisect_right
from collections.abc import Callable, Iterator, Sequence
from heapq import merge
from itertools import islice
from time import process_time
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
FIRST, MOST = 64, 4096  # passages that are looked at together: at first, at most
GOAL_S = 0.015  # of the processor, that those are to take: then somebody is heard


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
        self._known = np.zeros(len(came), np.uint8)  # 0: not looked at; else one of the three below
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
            yield from (self.came[k] for k in self._holding(range(first, last), look))

    def _first(self, order: range, look: "Look") -> Chosen | None:
        found = next(self._holding(order, look), None)
        return None if found is None else self._chosen(found)

    def _holding(self, order: range, look: "Look") -> Iterator[int]:
        """Return the passages, in order, at which the condition holds."""
        if self._condition is None:
            yield from order
            return
        for begin, end in self._blocks(order):
            look.heard()
            self._learn(self._condition, begin, end, look)
            maybe = np.flatnonzero(self._known[begin:end] != _FALSE) + begin
            for k in maybe[:: order.step].tolist():
                if k in order and self._holds(k, look):
                    yield k

    def _blocks(self, order: range) -> Iterator[tuple[int, int]]:
        """Return passages that are looked at together: as many as the last ones left time for."""
        size, done = FIRST, 0
        while done < len(order):
            part = order[done : done + size]
            before_s = process_time()
            yield min(part[0], part[-1]), max(part[0], part[-1]) + 1
            done += len(part)
            size = fitting(size, process_time() - before_s)

    def _learn(self, condition: Expression, begin: int, end: int, look: "Look") -> None:
        """Find out about passages together what can be found out so."""
        new = np.flatnonzero(self._known[begin:end] == 0) + begin
        if not len(new):
            return
        part = [self.came[k] for k in new.tolist()]
        reals, sure = condition.reals(
            [came.instant for came in part],
            [look.activation(came) for came in part],
            [came.process for came in part],
            look.heard,
        )
        self._known[new[sure]] = np.where(reals[sure] == 0.0, _FALSE, _TRUE)

    def _chosen(self, k: int) -> Chosen:
        return Chosen(k, self._problems.get(k, ""))

    def _all(self, look: "Look") -> list[int]:
        """Return the passages that the hits choose, counted from the beginning of the run."""
        if self._counted is None:
            counted: list[int] = []
            hit = 0
            for k in self._holding(range(len(self.came)), look):
                if k in self._problems:  # nobody knows whether it counts
                    counted.append(k)
                    continue
                hit += 1
                if hit % OFTEN == 0:
                    look.heard()
                if counts(self._hits, hit):
                    counted.append(k)
            self._counted = counted
        return self._counted

    def _holds(self, k: int, look: "Look") -> bool:
        if self._condition is None:
            return True
        if not self._known[k]:
            self._known[k] = self._worked_out(self._condition, k, look)
        return bool(self._known[k] != _FALSE)

    def _worked_out(self, condition: Expression, k: int, look: "Look") -> int:
        came = self.came[k]
        try:
            value = condition.value(
                came.instant, look.activation(came), look.heard, process=came.process
            )
        except CannotTell as problem:
            self._problems[k] = f"the condition cannot be worked out: {problem}"
            return _PROBLEM
        return _FALSE if value == 0.0 else _TRUE


_FALSE, _TRUE, _PROBLEM = 1, 2, 3


def fitting(size: int, spent_s: float) -> int:
    """Return how many may follow so many that took a time [s]: never more than twice as many."""
    share = GOAL_S / spent_s if spent_s > 0.0 else 2.0
    return max(1, min(int(size * min(share, 2.0)), MOST))


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


def came_to(run: Run, both: Sequence[Passages], resolved: Resolved, hear: Hear) -> list[Came]:
    """Return the passages of a line by the robot program and the process control program.

    Args:
        run: The run.
        both: All passages of its programs.
        resolved: The line.
        hear: Who is heard meanwhile.

    Raises:
        Interrupted: `hear` has heard somebody.
    """
    every: list[list[Came]] = []
    for passages in both:
        for _ in passages.in_parts():
            hear()
        numbers = np.asarray(passes(passages, resolved), np.int64)
        hear()
        if len(numbers):
            finished = passages.reached[numbers]
            hear()
            instants = map(Instant, _times(run, finished), finished.tolist())
            process = passages.is_process
            every.append(list(_heard((Came(at, process) for at in instants), hear)))
    return every[0] if len(every) == 1 else list(_heard(merge(*every), hear))


def _heard(every: Iterator[Came], hear: Hear) -> Iterator[Came]:
    while part := list(islice(every, MOST)):
        hear()
        yield from part


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
