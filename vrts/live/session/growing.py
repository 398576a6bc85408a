"""A run that grows beat by beat: its machine goes on in place, so a beat costs next to nothing.

`Controller` copies the machine whenever it advances, which makes every run of the past safe to ask.
Here only what asks for a `Run` pays for a copy. Events come out once each, when their time comes.
"""

import math
from bisect import bisect_right, insort

from vrts.base.stack import deep_stack
from vrts.engine.controller import start
from vrts.engine.events import Event, ProgramEnded, ProgramStarted
from vrts.engine.forget import forget
from vrts.engine.machine import Machine
from vrts.engine.run import Run
from vrts.ir.commands import Command, Panic, TimedCommand
from vrts.ir.module import Module
from vrts.robots.model import Configuration
from vrts.scene.model import Scenario, Scene

CHECKPOINT = 30.0  # [s] between states kept for going back; a whole number
RECENT = 600.0  # [s] after which only states `SPARSE` apart are kept
SPARSE = 120.0  # [s], a whole number
REACH = 3600.0  # [s] of history that is kept
FORGETTING = 60.0  # [s] between looks at what is older; a whole number
MOST_STATEMENTS = 5_000_000  # of history, beyond which it is shortened, however young it is
MOST_EVENTS = 100_000
MOST_CELLS = 20_000  # variables and array elements
TOO_MANY = "the arm and the programs were stopped: there are more than 20,000 variables"


class GrowingRun:
    """The machine of a session, and everything that is known of its past."""

    def __init__(self, scene: Scene, scenario: Scenario, *, forgets: bool = True) -> None:
        """Begin at time 0; `forgets`: whether history is shortened."""
        self.machine: Machine = start(Module({}, ()), scene, scenario).machine.copy()
        self.time_s = 0.0
        self.said: list[str] = []  # what users should know
        self.known_from_s = 0.0  # what was before is forgotten
        self._begun = -1  # the number of the event with which the robot program began
        self._seen = 0  # events of the machine that were looked at
        self._coming: list[tuple[float, int, Event]] = []  # seen, but their time has not come
        self._kept: list[tuple[float, Machine]] = [(0.0, self.machine.copy())]
        self._run: Run | None = None
        self._forgets = forgets
        self._forgotten = 0  # statements of the history that is forgotten
        self._uncrowded = MOST_EVENTS  # events that are not too many

    # --- going on -----------------------------------------------------------------------------

    def issue(self, *commands: Command) -> None:
        """Give commands now."""
        self._run = None
        self.machine.issue(tuple(TimedCommand(self.time_s, command) for command in commands))

    @property
    def waits(self) -> bool:
        """Whether commands have been given that have not taken effect yet."""
        return self.machine.obeyed < len(self.machine.issued)

    @deep_stack()
    def advance(self, until_s: float) -> None:
        """Go on to a time that is not in the past [s]."""
        if until_s < self.time_s:
            raise ValueError(f"{until_s} s is before the horizon at {self.time_s} s")
        self._run = None
        while (second := math.floor(self.time_s) + 1.0) <= until_s:
            self.machine.advance(second)
            self.time_s = second
            self._tidy_up()
        self.machine.advance(until_s)
        self.time_s = until_s

    def _tidy_up(self) -> None:
        """Do what is due at a whole second: so a session that is repeated does the same."""
        if self.machine.running and self.machine.system.memory.size > MOST_CELLS:
            self.issue(Panic())
            self.said.append(TOO_MANY)
        if self.time_s % CHECKPOINT == 0.0:
            self._thin_out()
            self._kept.append((self.time_s, self.machine.copy()))
        if self._forgets and (self._crowded or self.time_s % FORGETTING == 0.0):
            self._forget()

    def news(self) -> list[Event]:
        """Return the events whose time has come since this was asked last, in time order."""
        events = self.machine.system.events
        for number in range(self._seen, len(events)):
            event = events[number]
            if isinstance(event, ProgramStarted) and not event.process:
                self._begun = number
            insort(self._coming, (event.time_s, number, event), key=_when)
        self._seen = len(events)
        ripe = 0
        while ripe < len(self._coming) and self._coming[ripe][0] <= self.time_s:
            ripe += 1
        found = [
            event for _, number, event in self._coming[:ripe] if not self._stale(number, event)
        ]
        del self._coming[:ripe]
        return found

    def _stale(self, number: int, event: Event) -> bool:
        """Return whether an event is the end of an instruction that another program followed.

        A single instruction ends when the arm will have arrived; when it is replaced on the way,
        its end is none of the program that has begun meanwhile.
        """
        return isinstance(event, ProgramEnded) and not event.process and number < self._begun

    @property
    def next_tick_s(self) -> float:
        """Time of the next tick [s], the first at which what is given now may show."""
        tick = self.machine.tick
        return (math.floor(self.time_s / tick + 1e-9) + 1) * tick

    # --- asking -------------------------------------------------------------------------------

    @property
    def run(self) -> Run:
        """The run up to now, which nothing changes any more."""
        if self._run is None:
            machine = self.machine.copy()
            self._run = Run(machine, self.time_s, (machine,))
        return self._run

    def drop_run(self) -> None:
        """Keep no copy of the machine for `run`."""
        self._run = None

    @property
    def configuration(self) -> Configuration:
        """Joint positions now [rad]."""
        return self.machine.system.planner.configuration_at(self.time_s)

    @property
    def opening(self) -> float:
        """Opening of the hand now [m]."""
        return self.machine.system.hand.opening(self.time_s)

    @property
    def executing(self) -> bool:
        """Whether a robot program executes, or has ended but the arm still moves for it."""
        machine, now_s = self.machine, self.time_s
        if machine.robot.running:
            return True
        ended_s = machine.ended_s  # stays where it was when the motion is given up
        settles_s = machine.system.planner.settled_at
        return ended_s is not None and ended_s > now_s and settles_s > now_s

    @property
    def moving(self) -> bool:
        """Whether the arm moves."""
        return self.machine.system.planner.under_way(self.time_s)

    @property
    def braking(self) -> bool:
        """Whether the arm slows down to give its motion up."""
        return self.machine.system.planner.braking_until > self.time_s

    # --- going back, and forgetting -----------------------------------------------------------

    @deep_stack()
    def rewind(self, time_s: float) -> None:
        """Forget everything after a time that is still known; commands after it too.

        Raises:
            ValueError: The time is not known (any more).
        """
        if not self.known_from_s <= time_s <= self.time_s:
            raise ValueError(f"{time_s} s is not between {self.known_from_s} and {self.time_s} s")
        self._kept = [entry for entry in self._kept if entry[0] <= time_s]
        issued = tuple(c for c in self.machine.issued if c.time_s <= time_s)
        self.machine = self._kept[-1][1].copy()
        self.machine.know(issued)
        self.machine.advance(time_s)
        self.time_s, self._run = time_s, None
        self._coming, self._seen, self._begun = [], 0, -1
        self.news()  # of the past: it was told before

    @property
    def _crowded(self) -> bool:
        """Whether so much happens that the history has to be shorter than usual."""
        machine = self.machine
        return (
            machine.finished - self._forgotten > MOST_STATEMENTS
            or len(machine.system.events) > self._uncrowded
        )

    def _thin_out(self) -> None:
        """Let go of states that others are near enough to, in what is long past."""
        recent_s, kept = self.time_s - RECENT, self._kept[:1]
        for time_s, machine in self._kept[1:]:
            if time_s > recent_s or time_s % SPARSE == 0.0:
                kept.append((time_s, machine))
            else:
                _release(machine)
        self._kept = kept

    def _forget(self) -> None:
        """Shorten the history to `REACH`, or by half of it where it is too long."""
        before = self.time_s - REACH
        if self._crowded:
            before = max(before, 0.5 * (self.known_from_s + self.time_s))
        before = max(before, 0.0)
        late = len(self.machine.system.events) - self._seen
        at = max(bisect_right(self._kept, before, key=lambda entry: entry[0]) - 1, 0)
        if self._crowded and self._kept[-1][0] > self.known_from_s:
            at = max(at, 1)
        known_from_s, first = self._kept[at]
        if known_from_s <= self.known_from_s:
            return
        for _, machine in self._kept[:at]:
            _release(machine)
        del self._kept[:at]
        self.known_from_s, self._run = known_from_s, None
        forget([self.machine, *(machine for _, machine in self._kept)], known_from_s)
        self._forgotten = first.finished
        shorter = self._seen - (len(self.machine.system.events) - late)
        self._seen -= shorter
        self._begun -= shorter
        self._coming = [(at_s, known - shorter, event) for at_s, known, event in self._coming]
        self._uncrowded = max(MOST_EVENTS, 2 * len(self.machine.system.events))


def _release(machine: Machine) -> None:
    """Let a machine that nobody needs any more go at once: its parts know one another."""
    system = machine.system
    del system.robot, system.process
    del machine.system, machine.robot, machine.process


def _when(entry: tuple[float, int, Event]) -> float:
    return entry[0]
