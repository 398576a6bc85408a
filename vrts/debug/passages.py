"""Where a program passed: every statement it executed, and the instants at which steps begin."""

from collections.abc import Iterator, Mapping
from functools import cached_property
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from vrts.engine.history import ProgramHistory
from vrts.engine.memory.events import Cause
from vrts.engine.memory.trace import Activation
from vrts.engine.run import Run

_CHUNK = 1024  # statements that are looked at in one go
_PART = 20_000  # calls and returns that are looked at between two yields


class Instant(NamedTuple):
    """An instant of a run; within a tick statements tell before and after apart. They are in order.

    A step is about to be executed at the instant at which the statement before it is finished.
    """

    time_s: float
    finished: int  # statements of both programs


class Passages:
    """The statements of the robot program, or of the process control program, one after the other.

    Arrays are beside each other, one entry a statement; `count` stands for the end.
    """

    def __init__(self, run: Run, *, process: bool) -> None:
        """Take a run; nothing is worked out before it is asked for."""
        self.run = run
        self.is_process = process
        self._program: ProgramHistory = run.history.process if process else run.history.robot

    @cached_property
    def count(self) -> int:
        """How many statements there are."""
        return self._program.trace.executed(self.run.statements)

    @cached_property
    def instructions(self) -> NDArray[np.uint32]:
        """Numbers of the instructions."""
        return np.frombuffer(self._program.trace.instructions, np.uint32)[: self.count]

    @cached_property
    def before(self) -> NDArray[np.int64]:
        """How many statements of both programs were finished when each was executed."""
        trace = self._program.trace
        kept = sum(1 for count in trace.counts if count < self.count)
        begun = np.frombuffer(trace.begun, np.uint32)[:kept].astype(np.int64)
        counts = np.frombuffer(trace.counts, np.uint32)[:kept].astype(np.int64)
        lengths = np.diff(counts, append=self.count)
        return np.repeat(begun - counts, lengths) + np.arange(self.count)

    @cached_property
    def reached(self) -> NDArray[np.int64]:
        """How many were finished when each came next: a step that waits was reached before."""
        found = self.before.copy()
        apart = np.flatnonzero(np.diff(self.before) > 1) + 1
        trace, known = self._program.trace, self.run.statements
        for k in apart.tolist():
            waiting = int(self.before[k - 1]) + 1
            if trace.following(waiting, known) == self.instructions[k]:
                found[k] = waiting
        return found

    @cached_property
    def depths(self) -> NDArray[np.int64]:
        """How many programs called each other when each was executed."""
        return self._depths([depth for part in self._depths_noted() for depth in part])

    def _depths_noted(self) -> Iterator[list[int]]:
        """Yield how many programs call each other whenever that changes, part by part."""
        activations = self._program.trace.activations
        known: dict[int, int] = {id(None): 0}  # by identity: they stay as long as their run
        yield [0]
        for first in range(0, len(activations), _PART):
            found: list[int] = []
            for activation in activations[first : first + _PART]:
                depth = known.get(id(activation))
                if depth is None:
                    depth = known[id(activation)] = _depth(activation, known)
                found.append(depth)
            yield found

    def _depths(self, noted: list[int]) -> NDArray[np.int64]:
        changed = np.frombuffer(self._program.trace.changed, np.uint32)
        places = np.searchsorted(changed, self.before, side="right")
        found: NDArray[np.int64] = np.asarray(noted, np.int64)[places]
        return found

    @cached_property
    def begins(self) -> NDArray[np.bool_]:
        """Whether a step of the program begins with each."""
        causes = self.run.history.code.causes
        first = np.ones(len(causes), bool)
        step = np.zeros(len(causes), np.int64)
        for k in range(1, len(causes)):
            same = causes[k][:2] == causes[k - 1][:2]
            first[k] = not same
            step[k] = step[k - 1] + (not same)
        steps, depths = step[self.instructions], self.depths
        other = (np.diff(steps, prepend=-1) != 0) | (np.diff(depths, prepend=0) != 0)
        return first[self.instructions] | other

    def in_parts(self) -> Iterator[None]:
        """Work out where steps begin; yield now and then, so that somebody can be heard."""
        yield
        if "depths" not in self.__dict__:
            noted: list[int] = []
            for part in self._depths_noted():
                noted += part
                yield
            self.__dict__["depths"] = self._depths(noted)  # as the property keeps it
            yield
        _ = self.begins
        yield

    @cached_property
    def begun(self) -> NDArray[np.int64]:
        """The statements with which steps begin, in order."""
        return np.flatnonzero(self.begins)

    def no_deeper(self, begun: NDArray[np.int64], depth: int) -> int | None:
        """Return the first of some statements at which so many programs at most call each other."""
        for first in range(0, len(begun), _CHUNK):
            part = begun[first : first + _CHUNK]
            fit = np.flatnonzero(self.depths[part] <= depth)
            if len(fit):
                return int(part[fit[0]])
        return None

    def cause(self, number: int) -> Cause:
        """Return the step of a statement."""
        return self.run.history.code.causes[int(self.instructions[number])]

    def following(self, instant: Instant) -> int:
        """Return which statement comes next at an instant; `count` when none does."""
        return int(np.searchsorted(self.before, instant.finished))

    def instant(self, number: int) -> Instant:
        """Return when a statement came next."""
        return instant_of(self.run, int(self.reached[number]))


def instant_of(run: Run, finished: int) -> Instant:
    """Return the first instant at which so many statements are finished."""
    return Instant(run.history.time_of(finished), finished)


def at_time(run: Run, time_s: float) -> Instant:
    """Return the instant of a time, after all that happened in its tick."""
    time_s = min(max(time_s, 0.0), run.horizon_s)
    return Instant(time_s, run.history.finished_at(time_s))


def statements_at(run: Run, time_s: float) -> tuple[int, int]:
    """Return how many statements are finished before and after what happens at a time [s]."""
    before = time_s - run.history.tick_s / 2
    first = first_instant(run) if before <= 0.0 else at_time(run, before)
    return first.finished, at_time(run, time_s).finished


def executes(run: Run, number: int, *, process: bool) -> int | None:
    """Return the instruction that a statement was, where that program executed it."""
    trace = (run.history.process if process else run.history.robot).trace
    index = trace.executed(number) - 1
    if index < 0 or trace.executed(number - 1) != index:
        return None
    return trace.instructions[index]


def first_instant(run: Run) -> Instant:
    """Return the instant at which nothing has happened."""
    return Instant(0.0, 0)


def last_instant(run: Run) -> Instant:
    """Return the instant after everything."""
    return at_time(run, run.horizon_s)


def _depth(activation: Activation | None, known: Mapping[int, int]) -> int:
    depth = 0
    while activation is not None:
        if id(activation) in known:
            return depth + known[id(activation)]
        depth += 1
        activation = activation.caller
    return depth
