"""What the machine was at many instants at once: what SPEED, DEST, RANDOM and others ask."""

from collections.abc import Mapping
from functools import cached_property
from typing import cast

import numpy as np

from vrts.base.pose import Pose
from vrts.debug.conditions.block import Block
from vrts.debug.conditions.columns import Bools, Reals, Wholes, pose_of
from vrts.engine.code.values.controller_functions import (
    AT_REST,
    IDLE,
    MEMORY_CELLS,
    MOVING,
    PAUSED,
    RUNNING,
    STOPPING,
    UNDER_PROGRAM_CONTROL,
    UNKNOWN,
    WAITING,
)
from vrts.engine.code.values.state_functions import (
    DRAWN_OF,
    RANDOM_INCREMENT,
    RANDOM_MULTIPLIER,
)
from vrts.engine.memory.cells import Array
from vrts.engine.memory.facts import Aim, Executed, Facts
from vrts.engine.memory.records import INSTANT
from vrts.engine.memory.trace import Trace
from vrts.engine.memory.track import Track
from vrts.engine.run import Run
from vrts.robots.model import Configuration

BITS = 32  # of a number of statements
LAST = (1 << BITS) - 1


class Keys:
    """Instants as whole numbers in order: ticks, and statements within them."""

    def __init__(self, tick_s: float) -> None:
        """Take the time between two ticks [s]."""
        self._tick = tick_s

    def of_block(self, b: Block, ahead: "int | Wholes" = 0) -> Wholes:
        """Return those of the instants of a block, so many statements later."""
        ticks = np.floor(b.times / self._tick + INSTANT / self._tick).astype(np.int64)
        later = b.times - ticks * self._tick > INSTANT  # within a tick, after all of it
        return (ticks << BITS) | np.where(later, LAST, b.finished + ahead)

    def of_track(self, track: "Track[object]") -> Wholes:
        """Return those of changes; of one tick the later one is what counts."""
        ticks = np.round(np.array(track.times, np.float64) / self._tick).astype(np.int64)
        keys = (ticks << BITS) | np.array(track.numbers, np.int64)
        return np.minimum.accumulate(keys[::-1])[::-1]


class Changes:
    """All changes of something, looked up for many instants at once."""

    def __init__(self, track: "Track[object]", keys: Keys) -> None:
        """Take the changes."""
        self._keys, self.count = keys, len(track.times)
        self._known = keys.of_track(track)
        self.numbers = np.array([0, *track.numbers], np.int64)  # the first one: before any change

    def places(self, b: Block, ahead: "int | Wholes" = 0) -> Wholes:
        """Return how many changes there were at each instant."""
        return np.searchsorted(self._known, self._keys.of_block(b, ahead), side="right")


class Machines:
    """The machine of a run, as columns that are made when they are first asked for."""

    def __init__(self, run: Run, facts: Facts) -> None:
        """Take a run, and what was noted of its machine."""
        self._run, self._facts, self._keys = run, facts, Keys(run.history.tick_s)
        self._reals: dict[int, tuple[object, Changes, Reals]] = {}

    def _real(self, b: Block, track: "Track[float]", before: float = np.nan) -> Reals:
        known = self._reals.get(id(track))
        if known is None:
            changes = Changes(cast("Track[object]", track), self._keys)
            values = np.array([before, *track.values], np.float64)
            # the track is kept with them: no other one gets its `id` meanwhile
            known = self._reals[id(track)] = track, changes, values
        _, changes, values = known
        return values[changes.places(b)]

    # --- chance and time ----------------------------------------------------------------------

    @property
    def draws_anew(self) -> bool:
        """Whether all numbers that RANDOM draws are decided by the seed."""
        return not self._run.scenario.draws

    def random(self, b: Block) -> Reals:
        """Return RANDOM, the next one in the order in which an expression asks."""
        if b.chance is None:
            seed = float(self._run.scenario.seed & 0xFFFFFFFF)
            states = self._real(b, cast("Track[float]", self._facts.drawn), seed)
            b.chance = states.astype(np.int64)
        b.chance = (RANDOM_MULTIPLIER * b.chance + RANDOM_INCREMENT) & 0xFFFFFFFF
        return (b.chance >> 8) / DRAWN_OF

    def timer(self, b: Block, numbers: Reals) -> Reals:
        """Return when timers stood at zero [s]."""
        found = np.zeros(b.count)
        for number in np.unique(numbers).tolist():
            track = self._facts.timers.get(int(number)) if np.isfinite(number) else None
            if track is not None:
                here = numbers == number
                found[here] = self._real(b, track, 0.0)[here]
        return found

    # --- arm ----------------------------------------------------------------------------------

    def speed(self, b: Block, which: int) -> Reals:
        """Return SPEED of 1, 2 or 3 [%]."""
        facts = self._facts
        if which == 1:
            return 100.0 * self._real(b, facts.rates)
        return self._real(b, facts.speeds if which == 2 else facts.next_speeds)

    def state(self, b: Block, which: int) -> Reals:
        """Return STATE of a selector."""
        if which != 2:
            return np.full(b.count, UNDER_PROGRAM_CONTROL if which == 1 else 0.0)
        moving = np.where(self._real(b, self._facts.ends) > b.times, MOVING, AT_REST)
        return np.where(self._real(b, self._facts.stops, 0.0) > b.times, STOPPING, moving)

    @cached_property
    def _aims(self) -> Changes:
        return Changes(cast("Track[object]", self._facts.aims), self._keys)

    def aims(self, b: Block) -> Wholes:
        """Return at each instant how many aims the arm has had."""
        return self._aims.places(b)

    @cached_property
    def _dest_columns(self) -> tuple[Reals, ...]:
        rows = [(*aim.X_BT.rotation, *aim.X_BT.translation) for aim in self._aim_list]
        return tuple(np.array([(np.nan,) * 12, *rows]).T)

    @cached_property
    def _aim_list(self) -> list[Aim]:
        return cast("list[Aim]", self._facts.aims.values)[: self._aims.count]

    def dest(self, b: Block) -> Pose:
        """Return X_BT at the destination, its numbers as columns."""
        at = self.aims(b)
        return pose_of(tuple([column[at] for column in self._dest_columns]))

    @cached_property
    def _dests(self) -> list[Configuration | None]:
        return [None, *(aim.dest for aim in self._aim_list)]

    def dest_joints(self, b: Block) -> list[Configuration | None]:
        """Return #DEST at each instant [rad]."""
        return [self._dests[k] for k in self.aims(b).tolist()]

    def turns(self, b: Block) -> Reals:
        """Return whether joints 4 and 6 may go beyond half a turn."""
        return self._real(b, cast("Track[float]", self._facts.turns))

    def analog(self, b: Block, channel: int) -> Reals:
        """Return what an analog input reads [counts]."""
        known = [(time, counts) for time, of, counts in self._run.scenario.analog if of == channel]
        times, counts = np.array([t for t, _ in known]), np.array([0.0, *(c for _, c in known)])
        return counts[np.searchsorted(times, b.times, side="right")]

    # --- programs and memory ------------------------------------------------------------------

    def free(self, b: Block) -> Reals:
        """Return FREE before it is rounded [%]."""
        cells = self._real(b, cast("Track[float]", self._facts.sizes))
        for bound in self._run.history.memory.bound:
            if isinstance(bound, Array) and bound.elements:
                made = np.array(bound.made, np.int64)
                cells = cells + np.searchsorted(made, b.finished, side="right")
        return 100.0 * np.maximum(1.0 - cells / MEMORY_CELLS, 0.0)

    @cached_property
    def _programs(self) -> "tuple[_Program, _Program]":
        facts, history = self._facts, self._run.history
        robot, process = history.robot.trace, history.process.trace
        return (
            _Program(facts.robot, facts.robot_wakes, robot, self._keys),
            _Program(facts.process, facts.process_wakes, process, self._keys),
        )

    def priority(self, b: Block) -> Reals:
        """Return PRIORITY of the program that asks."""
        robot, process = (program.priority(b) for program in self._programs)
        return np.where(b.process, process, robot)

    def error(self, b: Block) -> Reals:
        """Return ERROR of the program that asks."""
        robot, process = (program.error(b) for program in self._programs)
        return np.where(b.process, process, robot)

    @cached_property
    def _memories(self) -> Changes:
        return Changes(cast("Track[object]", self._facts.programs), self._keys)

    def status(self, b: Block, name: str) -> Reals:
        """Return STATUS of a program, its name in small letters."""
        memories = cast("list[Mapping[str, int]]", self._facts.programs.values)
        known = np.array([False, *(name in numbers for numbers in memories)])
        found = np.full(b.count, IDLE)
        left = np.ones(b.count, bool)
        for program, asks in zip(self._programs, (~b.process, b.process), strict=True):
            state = program.status(b, name, asks)
            here = left & (state != IDLE)
            found = np.where(here, state, found)
            left &= ~here
        return np.where(known[self._memories.places(b)], found, UNKNOWN)


class _Program:
    """The robot program or the process control program, as columns."""

    def __init__(
        self, told: "Track[Executed]", wakes: "Track[float]", trace: Trace, keys: Keys
    ) -> None:
        self._told = Changes(cast("Track[object]", told), keys)
        rows = cast("list[Executed]", told.values)
        self._rows = [Executed(), *rows[: self._told.count]]
        self._wakes = Changes(cast("Track[object]", wakes), keys)
        self._until = np.array([0.0, *wakes.values], np.float64)
        self._begun = np.array(trace.begun, np.int64)
        self._counts = np.array([*trace.counts, len(trace.instructions)], np.int64)

    def priority(self, b: Block) -> Reals:
        return np.array([float(row.priority) for row in self._rows])[self._told.places(b)]

    def error(self, b: Block) -> Reals:
        return np.array([float(row.error) for row in self._rows])[self._told.places(b)]

    def status(self, b: Block, name: str, asks: Bools) -> Reals:
        """Return what it makes STATUS say of a name; IDLE where it says nothing."""
        at = self._told.places(b)
        named = np.array([row.program == name for row in self._rows])[at]
        running = np.array([row.running for row in self._rows])[at]
        kept = np.array([row.kept for row in self._rows])[at]
        waits = np.where(~asks & self._blocked(b), WAITING, RUNNING)
        return np.where(named, np.where(running, waits, np.where(kept, PAUSED, IDLE)), IDLE)

    def _blocked(self, b: Block) -> Bools:
        """Return whether it is blocked amid a step, and not looked at again yet."""
        # the robot program has its turn before the other one asks
        ahead = np.where(b.process, 1, 0)
        at = self._wakes.places(b, ahead)
        same = self._executed(b.finished) == self._executed(self._wakes.numbers[at] - 1)
        return (self._until[at] > b.times) & same

    def _executed(self, finished: Wholes) -> Wholes:
        """Return what `Trace.executed` does, for many at once."""
        if not len(self._begun):
            return np.zeros(len(finished), np.int64)
        k = np.searchsorted(self._begun, finished, side="right") - 1
        at = np.maximum(k, 0)
        count = np.minimum(self._counts[at] + finished - self._begun[at], self._counts[at + 1])
        return np.where(k < 0, 0, count)
