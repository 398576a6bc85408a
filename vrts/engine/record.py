"""The record of one execution: everything that happened up to a horizon, as a whole."""

from bisect import bisect_right
from collections.abc import Hashable, Mapping, Sequence
from functools import cached_property

from vrts.base.diagnostic import Diagnostic
from vrts.engine.history import History, history_of
from vrts.engine.machine.machine import Machine
from vrts.engine.memory.events import (
    Event,
    Found,
    Printed,
)
from vrts.engine.memory.numbered import Numbered
from vrts.engine.memory.records import (
    Ending,
    Motion,
    Placement,
)
from vrts.engine.timeline import Timeline
from vrts.ir.module import Module
from vrts.scene.model import Scenario, Scene


class Record:
    """One execution up to its horizon. Immutable."""

    def __init__(
        self, origin: Machine | History, until_s: float, checkpoints: tuple[Machine, ...] = ()
    ) -> None:
        """Take a machine that nobody changes any more, and earlier copies of it.

        A history alone, as it comes from a file, makes a run that can be asked but not advanced.
        """
        self.history = history_of(origin) if isinstance(origin, Machine) else origin
        self._machine = origin if isinstance(origin, Machine) else None
        self._checkpoints = checkpoints
        self.until_s = until_s
        ended = self.history.ended_s
        over = self.history.closed and ended is not None
        self.horizon_s = (
            max(ended, min(until_s, self._last_s)) if over and ended is not None else until_s
        )

    @property
    def machine(self) -> Machine:
        """State to continue from; copy it before use.

        Raises:
            ValueError: The run comes from a file.
        """
        if self._machine is None:
            raise ValueError("a run from a file can be asked, not advanced: execute it again first")
        return self._machine

    @property
    def checkpoints(self) -> tuple[Machine, ...]:
        """Earlier states to continue from, in time order.

        Raises:
            ValueError: The run comes from a file.
        """
        return self._checkpoints if self._checkpoints else (self.machine,)

    @property
    def module(self) -> Module:
        """The programs."""
        return self.history.module

    @property
    def scene(self) -> Scene:
        """The workspace."""
        return self.history.scene

    @property
    def scenario(self) -> Scenario:
        """Initial state, inputs and limits."""
        return self.history.scenario

    @property
    def ending(self) -> Ending:
        """How the robot program ended, or that it still runs."""
        ended = self.history.ended_s
        if ended is not None and ended > self.horizon_s:
            return Ending.RUNNING
        return self.history.robot.ending

    @property
    def started_s(self) -> float:
        """When EXECUTE took effect [s]."""
        return self.history.started_s

    @property
    def ended_s(self) -> float | None:
        """When the robot program was over and the arm stood still [s]."""
        ended = self.history.ended_s
        return None if ended is None or ended > self.horizon_s else ended

    @property
    def statements(self) -> int:
        """How many statements were executed, by both programs."""
        return self.history.finished

    @property
    def motions(self) -> Numbered[Motion]:
        """Every motion issued, in run time."""
        return self._motions

    @cached_property
    def _motions(self) -> Numbered[Motion]:
        arm = self.history.arm
        given = arm.motions
        motions = given if isinstance(given, Numbered) else Numbered(given)
        if arm.scale.plain:
            return motions
        time = arm.scale.time
        in_run_time = (
            motion._replace(start_s=time(motion.start_s), end_s=time(motion.end_s))
            for motion in motions
        )
        return Numbered(in_run_time, motions.first)

    def motion_begun(self, time_s: float) -> Motion | None:
        """Return the last motion that has begun at a time [s]."""
        given, time = self.history.arm.motions, self.history.arm.scale.time
        first = given.first if isinstance(given, Numbered) else 0
        found = bisect_right(given, time_s, first, key=lambda motion: time(motion.start_s))
        if found == first:
            return None
        motion = given[found - 1]
        return motion._replace(start_s=time(motion.start_s), end_s=time(motion.end_s))

    @property
    def timeline(self) -> Timeline:
        """The trajectory of arm and hand."""
        return self._timeline

    @cached_property
    def _timeline(self) -> Timeline:
        arm, hand = self.history.arm, self.history.hand
        return Timeline(
            arm.pieces, arm.scale, hand.strokes, arm.configuration, hand.opening_m, self.horizon_s
        )

    @property
    def events(self) -> tuple[Event, ...]:
        """What happened up to the horizon, in time order.

        Of one instant, motions that end and begin come first, then what the programs did.
        """
        return self._events

    @cached_property
    def _events(self) -> tuple[Event, ...]:
        return tuple([one.event for one in self.history.events.in_order.until(self.horizon_s)])

    @property
    def event_numbers(self) -> Sequence[int]:
        """Beside `events`: how many statements were finished with each."""
        return self._event_numbers

    @cached_property
    def _event_numbers(self) -> Sequence[int]:
        numbers = self.history.events.numbers
        return [numbers[one.number] for one in self.history.events.in_order.until(self.horizon_s)]

    def happened(self, track: Hashable, time_s: float) -> Sequence[Event]:
        """Return the events of a track of `event_order` up to a time [s], such as of a type."""
        return self.history.events.in_order.track(track, min(time_s, self.horizon_s))

    def last(self, track: Hashable, time_s: float) -> Event | None:
        """Return the last of them."""
        return self.history.events.in_order.last(track, min(time_s, self.horizon_s))

    @property
    def findings(self) -> tuple[Diagnostic, ...]:
        """Diagnostics of the engine, in time order."""
        return tuple(event.diagnostic for event in self.events if isinstance(event, Found))

    @property
    def placements(self) -> Mapping[str, Sequence[Placement]]:
        """Where every movable body is, over time."""
        return self._placements

    @cached_property
    def _placements(self) -> Mapping[str, Sequence[Placement]]:
        return {
            name: tuple(p for p in track if p.start_s <= self.horizon_s)
            for name, track in self.history.hand.placements.items()
        }

    @property
    def output(self) -> str:
        """Everything written to the terminal."""
        return "".join(event.text for event in self.events if isinstance(event, Printed))

    @property
    def _last_s(self) -> float:
        """End of everything under way when the program ended [s]."""
        hand = self.history.hand
        strokes = [stroke.end_s for stroke in hand.strokes[-1:]]
        landings = [track[-1].start_s for track in hand.placements.values()]
        return max([0.0, *strokes, *landings])
