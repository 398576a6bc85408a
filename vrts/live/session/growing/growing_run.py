"""A run that grows beat by beat: its machine goes on in place, so a beat costs next to nothing.

`Controller` copies the machine whenever it advances, which makes every run of the past safe to ask.
Here only what asks for a `Run` pays for a copy. Events come out once each, when their time comes.
What is older than ten minutes is in a file (`past`), or forgotten where there is none.
"""

import math
from bisect import bisect_right
from collections.abc import Iterator, Sequence

from vrts.base.stack import deep_stack
from vrts.engine.controller import start
from vrts.engine.machine.forget import forget, forget_values
from vrts.engine.machine.machine import Machine
from vrts.engine.machine.tick import run_until
from vrts.engine.memory.events import Event
from vrts.engine.run import Run
from vrts.ir.commands import Command, Panic, TimedCommand
from vrts.ir.module import Module
from vrts.live.session.growing.away import Away
from vrts.live.session.growing.coming import Coming
from vrts.live.session.growing.deeds import Deeds, moving, telling
from vrts.live.session.growing.past import Past
from vrts.robots.model import Configuration
from vrts.scene.model import Scenario, Scene

CHECKPOINT = 30.0  # [s] between states kept for going back; a whole number
RECENT = 600.0  # [s] after which only states `SPARSE` apart are kept
SPARSE = 120.0  # [s], a whole number
REACH = 600.0  # [s] of history that is kept
FORGETTING = 60.0  # [s] between looks at what is older; a whole number
MOST_STATEMENTS = 5_000_000  # of history, beyond which it is shortened, however young it is
MOST_EVENTS = 100_000
MOST_CELLS = 20_000  # variables and array elements
TOO_MANY = "the arm and the programs were stopped: there are more than 20,000 variables"


class GrowingRun:
    """The machine of a session, and everything that is known of its past."""

    def __init__(
        self, scene: Scene, scenario: Scenario, past: Past | None = None, *, forgets: bool = True
    ) -> None:
        """Begin at time 0.

        Args:
            scene: The workspace.
            scenario: How it is at first.
            past: Takes what is forgotten; None: nobody does.
            forgets: Whether history is shortened.
        """
        self.machine: Machine = start(Module({}, ()), scene, scenario).machine.copy()
        self.time_s = 0.0
        self.said: list[str] = [] if past is None else past.said  # what users should know
        if past is not None:
            past.begin()
        self.known_from_s = 0.0  # what was before is in the file, or forgotten
        self._past = past
        self._handed_on = 0  # commands of the machine that are in the file
        self._done = (0, 0.0)  # motions, and a time [s], before which what was done is in the file
        self._crowd = False  # more has happened than can be gone through again
        self._coming = Coming()
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
            run_until(self.machine, second)
            self.time_s = second
            self._tidy_up()
        run_until(self.machine, until_s)
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
        return self._coming.ripe(self.machine.system.events, self.time_s)

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

    @property
    def reaches_s(self) -> float:
        """The earliest time that can be gone back to [s]."""
        past_s = self._past.known_from_s if self._past is not None else None
        return self.known_from_s if past_s is None else past_s

    @property
    def knows_all(self) -> bool:
        """Whether all that was ever done can be had again."""
        kept = self._past is not None and self._past.whole and not self._crowd
        return self.known_from_s == 0.0 or kept

    @deep_stack()
    def rewind(self, time_s: float) -> None:
        """Forget everything after a time that is still known; commands after it too.

        Raises:
            ValueError: The time is not known (any more).
        """
        if not self.reaches_s <= time_s <= self.time_s:
            raise ValueError(f"{time_s} s is not between {self.reaches_s} and {self.time_s} s")
        if time_s < self.known_from_s:
            kept_s, kept, given = self._from_file(time_s)
            assert self._past is not None
            self._past.cut(kept_s)
            self._kept = [(kept_s, kept)]
            self.known_from_s, self._handed_on = kept_s, len(kept.issued)
            self._done = (kept.system.planner.given.motions.first, kept_s)
        else:
            self._kept = [entry for entry in self._kept if entry[0] <= time_s]
            kept_s, kept = self._kept[-1]
            given = self.machine.issued[len(kept.issued) :]
        self.machine = kept.copy()
        for _ in _repeated(self.machine, given, kept_s, time_s):
            pass
        self.time_s, self._run = time_s, None
        self._coming = Coming()
        self.news()  # of the past: it was told before

    @deep_stack()
    def run_since(self, time_s: float) -> Run | None:
        """Return the run with motions and events from a time on; it may take its time.

        Values and statements are only those of the end. None: the time is not known any more.
        """
        if time_s >= self.known_from_s:
            return self.run
        if self._crowd:
            return None
        try:
            begun_s, machine, given = self._from_file(time_s)
        except ValueError:
            return None
        for now_s in _repeated(machine, given, begun_s, self.time_s):
            forget_values([machine], max(now_s - FORGETTING, 0.0))
        return Run(machine, self.time_s, (machine,))

    @deep_stack()
    def run_of(self, from_s: float, until_s: float) -> Run | None:
        """Return a run that knows all between two times [s]; it may take its time.

        None: that is not known any more.
        """
        if from_s >= self.known_from_s:
            return self.run
        try:
            begun_s, machine, given = self._from_file(from_s)
        except ValueError:
            return None
        until_s = min(until_s, self.time_s)
        for _ in _repeated(machine, given, begun_s, until_s):
            pass
        return Run(machine, until_s, (machine,))

    def deeds(self) -> Deeds | None:
        """Return what was done before `known_from_s`; None: that is not known any more."""
        if self.known_from_s == 0.0:
            return Deeds()
        return self._past.deeds() if self._past is not None else None

    def _from_file(self, time_s: float) -> tuple[float, Machine, tuple[TimedCommand, ...]]:
        """Return a state not after a time [s], its time, and all commands given since.

        Raises:
            ValueError: There is none.
        """
        if self._past is None:
            raise ValueError("nothing was kept")
        kept_s, machine, given = self._past.state_before(time_s)
        return kept_s, machine, (*given, *self.machine.issued[self._handed_on :])

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
        at = max(bisect_right(self._kept, before, key=lambda entry: entry[0]) - 1, 0)
        if self._crowded and self._kept[-1][0] > self.known_from_s:
            at = max(at, 1)
        if self._kept[at][0] <= self.known_from_s:
            return
        self._crowd = self._crowd or self._crowded
        self._let_go(at)

    def _let_go(self, at: int) -> None:
        """Put into the file, or forget, what was before one of the states that are kept."""
        events, (known_from_s, first) = len(self.machine.system.events), self._kept[at]
        run, issued = self.run, self.machine.issued
        for time_s, machine in self._kept[:at]:
            if self._past is not None and time_s % SPARSE == 0.0:
                self._hand_on(run, time_s, machine)
            _release(machine)
        self._hand_on_commands(len(first.issued))
        del self._kept[:at]
        forget([self.machine, *(machine for _, machine in self._kept)], known_from_s)
        self._hand_on_deeds(run, self.machine, known_from_s)
        self._handed_on -= len(issued) - len(self.machine.issued)
        self.known_from_s, self._run = known_from_s, None
        self._forgotten = first.finished
        self._coming.forget(events - len(self.machine.system.events))
        self._uncrowded = max(MOST_EVENTS, 2 * len(self.machine.system.events))

    def put_away(self) -> Away | None:
        """Put all that is past into the file, and return what is now; None: there is no file."""
        if self._past is None or not self._past.works:
            return None
        if self._kept[-1][0] < self.time_s:
            self._kept.append((self.time_s, self.machine.copy()))
        if self.known_from_s < self.time_s:
            self._let_go(len(self._kept) - 1)
        told = (self._handed_on, self._done, self._crowd, self._forgotten, self._uncrowded)
        return Away(self.time_s, self.machine.copy(), *told, self._coming.heard)

    def take_back(self, away: Away) -> None:
        """Be what another one was that was put away; its file is this one's."""
        self.time_s = self.known_from_s = away.time_s
        self.machine = away.machine
        self._kept = [(away.time_s, away.machine.copy())]
        self._handed_on, self._done, self._crowd, self._forgotten, self._uncrowded = away[2:7]
        self._coming.go_on(away.heard)
        self._run = None

    def _hand_on(self, run: Run, time_s: float, machine: Machine) -> None:
        """Put a state into the file, with what was done before it."""
        assert self._past is not None
        self._hand_on_commands(len(machine.issued))
        machine.write()  # part from what has come since
        forget([machine], time_s)
        self._hand_on_deeds(run, machine, time_s)
        self._past.keep_state(time_s, machine)

    def _hand_on_commands(self, count: int) -> None:
        """Put commands into the file that are not there yet, up to a number of them."""
        if self._past is not None:
            self._past.keep_commands(self.machine.issued[self._handed_on : count])
            self._handed_on = max(self._handed_on, count)

    def _hand_on_deeds(self, run: Run, machine: Machine, time_s: float) -> None:
        """Put what was done before a time into the file that a machine has forgotten of it."""
        if self._past is None:
            return
        first = machine.system.planner.given.motions.first
        motions = run.motions[max(self._done[0], run.motions.first) : first]
        since_s = self._done[1]
        events = [event for event in run.events if since_s <= event.time_s < time_s]
        self._past.keep_deeds(Deeds(tuple(moving(motions)), tuple(telling(events))))
        self._done = (first, time_s)


def _repeated(
    machine: Machine, commands: Sequence[TimedCommand], from_s: float, until_s: float
) -> Iterator[float]:
    """Let a machine go on as it did; yield the times it comes to, a minute apart or less [s].

    Args:
        machine: It goes on in place.
        commands: That it was given since, in order; later ones are left out.
        from_s: How far it has come.
        until_s: How far it goes.
    """
    following = 0
    minute = math.floor(from_s / FORGETTING) + 1.0
    while True:
        at_s = until_s
        if following < len(commands):
            at_s = min(at_s, commands[following].time_s)
        at_s = min(at_s, minute * FORGETTING)
        run_until(machine, at_s)
        if at_s == minute * FORGETTING:
            minute += 1.0
        begin = following
        while following < len(commands) and commands[following].time_s <= at_s:
            following += 1
        machine.issue(tuple(commands[begin:following]))
        yield at_s
        if at_s >= until_s:
            return


def _release(machine: Machine) -> None:
    """Let a machine that nobody needs any more go at once: its parts know one another."""
    for c in (machine.robot, machine.process):
        del c.robot, c.process
    del machine.system, machine.robot, machine.process
