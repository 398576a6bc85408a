"""The record of one execution: everything that happened up to a horizon, at any time."""

from bisect import bisect_right
from collections.abc import Mapping, Sequence

from vrts.base.diagnostic import Diagnostic
from vrts.base.pose import Pose
from vrts.base.source import Span
from vrts.engine.cells import UNDEFINED
from vrts.engine.events import Cause, Event, Found, Printed, SignalChanged
from vrts.engine.machine import Machine
from vrts.engine.records import GRAVITY, Ending, Lie, Motion, Placement
from vrts.engine.timeline import Timeline
from vrts.ir.module import Module
from vrts.ir.values import Value
from vrts.robots.kinematics import forward
from vrts.robots.model import Configuration
from vrts.scene.model import Scenario, Scene


class OutOfHorizon(ValueError):  # noqa: N818 -- names the situation, as the glossary does
    """A time was asked for at which the run is not known."""

    def __init__(self, time_s: float, horizon_s: float) -> None:
        """Say which time, and how far the run reaches."""
        super().__init__(f"time {time_s} s is outside 0 to {horizon_s} s")
        self.time_s = time_s
        self.horizon_s = horizon_s


class Run:
    """One execution up to its horizon. Immutable; `controller.advance` makes longer ones."""

    def __init__(self, machine: Machine, until_s: float, checkpoints: tuple[Machine, ...]) -> None:
        """Take a machine that nobody changes any more, and earlier copies of it."""
        self._machine = machine
        self._checkpoints = checkpoints
        self.until_s = until_s
        ended = machine.ended_s
        self.horizon_s = until_s if ended is None else max(ended, min(until_s, self._last_s))
        self._timeline: Timeline | None = None  # worked out when first asked for
        self._events: tuple[Event, ...] | None = None

    @property
    def machine(self) -> Machine:
        """State to continue from; copy it before use."""
        return self._machine

    @property
    def checkpoints(self) -> tuple[Machine, ...]:
        """Earlier states to continue from, in time order."""
        return self._checkpoints

    @property
    def module(self) -> Module:
        """The programs."""
        return self._machine.executable.module

    @property
    def scene(self) -> Scene:
        """The workspace."""
        return self._machine.scene

    @property
    def scenario(self) -> Scenario:
        """Initial state, inputs and limits."""
        return self._machine.scenario

    @property
    def ending(self) -> Ending:
        """How the program ended, or that it still runs."""
        ended = self._machine.ended_s
        if ended is not None and ended > self.horizon_s:
            return Ending.RUNNING
        return self._machine.ending

    @property
    def started_s(self) -> float:
        """When EXECUTE took effect [s]."""
        return self._machine.started_s

    @property
    def ended_s(self) -> float | None:
        """When the program was over and the arm stood still [s]."""
        ended = self._machine.ended_s
        return None if ended is None or ended > self.horizon_s else ended

    @property
    def motions(self) -> Sequence[Motion]:
        """Every motion issued."""
        return self._machine.context.planner.motions

    @property
    def timeline(self) -> Timeline:
        """The trajectory of arm and hand."""
        if self._timeline is None:
            machine = self._machine
            self._timeline = Timeline(
                machine.context.planner.pieces,
                machine.context.hand.strokes,
                machine.initial_configuration,
                machine.initial_opening,
                self.horizon_s,
            )
        return self._timeline

    @property
    def events(self) -> tuple[Event, ...]:
        """What happened up to the horizon, in time order."""
        if self._events is None:
            known = (e for e in self._machine.context.events if e.time_s <= self.horizon_s)
            self._events = tuple(sorted(known, key=lambda event: event.time_s))
        return self._events

    @property
    def findings(self) -> tuple[Diagnostic, ...]:
        """Diagnostics of the engine, in time order."""
        return tuple(event.diagnostic for event in self.events if isinstance(event, Found))

    @property
    def placements(self) -> Mapping[str, Sequence[Placement]]:
        """Where every movable body is, over time."""
        return {
            name: tuple(p for p in track if p.start_s <= self.horizon_s)
            for name, track in self._machine.context.hand.placements.items()
        }

    @property
    def output(self) -> str:
        """Everything written to the terminal."""
        return "".join(event.text for event in self.events if isinstance(event, Printed))

    def at(self, time_s: float) -> "State":
        """Return the state at a time, in any order of asking.

        Raises:
            OutOfHorizon: The run does not reach so far.
        """
        if not 0.0 <= time_s <= self.horizon_s:
            raise OutOfHorizon(time_s, self.horizon_s)
        return State(self, time_s)

    @property
    def _last_s(self) -> float:
        """End of everything under way when the program ended [s]."""
        hand = self._machine.context.hand
        strokes = [stroke.end_s for stroke in hand.strokes[-1:]]
        landings = [track[-1].start_s for track in hand.placements.values()]
        return max([0.0, *strokes, *landings])


class State:
    """A run at one instant; parts are worked out when they are asked for."""

    __slots__ = ("_run", "time_s")

    def __init__(self, run: Run, time_s: float) -> None:
        """Remember the run and the instant."""
        self._run = run
        self.time_s = time_s

    @property
    def configuration(self) -> Configuration:
        """Joint positions [rad]."""
        return self._run.timeline.configuration(self.time_s)

    @property
    def velocity(self) -> Configuration:
        """Joint velocities [rad/s]."""
        return self._run.timeline.velocity(self.time_s)

    @property
    def hand_opening(self) -> float:
        """Opening of the hand [m]."""
        return self._run.timeline.opening(self.time_s)

    @property
    def X_WF(self) -> Pose:
        """Pose of the flange."""
        return forward(self._run.scene.robot.arm, self.configuration)

    @property
    def X_WT(self) -> Pose:
        """Pose of the tool in force at the motion under way or just done."""
        motions = self._run.motions
        found = bisect_right(motions, self.time_s, key=lambda motion: motion.start_s)
        X_FT = motions[found - 1].X_FT if found else self._run.scene.X_FT
        return self.X_WF @ X_FT

    @property
    def placements(self) -> Mapping[str, Placement]:
        """How every movable body lies."""
        return {
            name: next(p for p in reversed(track) if p.start_s <= self.time_s)
            for name, track in self._run.placements.items()
        }

    @property
    def poses(self) -> Mapping[str, Pose]:
        """X_WO of every body of the scene."""
        found = {body.name: body.X_WO for body in self._run.scene.bodies}
        X_WF = self.X_WF
        for name, placement in self.placements.items():
            found[name] = pose_of(placement, self.time_s, X_WF)
        return found

    @property
    def held(self) -> str | None:
        """The body in the hand."""
        for name, placement in self.placements.items():
            if placement.lie is Lie.HELD and placement.support is None:
                return name
        return None

    @property
    def signals(self) -> frozenset[int]:
        """Signals that are on."""
        on: set[int] = set()
        for event in self._run.events:
            if event.time_s > self.time_s:
                break
            if isinstance(event, SignalChanged):
                (on.add if event.on else on.discard)(event.signal)
        return frozenset(on)

    @property
    def variables(self) -> Mapping[str, Value]:
        """Global variables that have a value, array elements included."""
        found: dict[str, Value] = {}
        for cell in self._run.machine.context.memory.cells():
            value = cell.at(self.time_s)
            if value is not UNDEFINED:
                found[cell.name] = value  # type: ignore[assignment]
        return found

    @property
    def call_stack(self) -> tuple[Cause, ...]:
        """The instruction that each program is at, outermost first; empty when none runs."""
        machine = self._run.machine
        if machine.ended_s is not None and self.time_s >= machine.ended_s:
            return ()
        places = machine.places
        found = bisect_right(places, self.time_s, key=lambda place: place.time_s)
        if not found:
            return ()
        programs = machine.executable.programs
        return tuple(
            programs[number].causes[min(index, len(programs[number].causes) - 1)]
            for number, index in places[found - 1].frames
        )

    @property
    def cause(self) -> Cause | None:
        """The instruction of the motion under way, else the one the program is at."""
        motions = self._run.motions
        found = bisect_right(motions, self.time_s, key=lambda motion: motion.start_s)
        if found and self.time_s < motions[found - 1].end_s:
            return motions[found - 1].cause
        stack = self.call_stack
        return stack[-1] if stack else None

    @property
    def program(self) -> str | None:
        """Name of the program of `cause`."""
        return self.cause.program if self.cause else None

    @property
    def step(self) -> int | None:
        """Step of `cause`."""
        return self.cause.step if self.cause else None

    @property
    def span(self) -> Span | None:
        """Source of `cause`."""
        return self.cause.span if self.cause else None

    @property
    def output(self) -> str:
        """What the program has written so far."""
        return "".join(
            event.text
            for event in self._run.events
            if isinstance(event, Printed) and event.time_s <= self.time_s
        )


def pose_of(placement: Placement, time_s: float, X_WF: Pose) -> Pose:
    """Return X_WO of a body at a time, with the flange where it is then."""
    if placement.lie is Lie.HELD:
        return X_WF @ placement.X
    if placement.lie is Lie.FALLING:
        x, y, z = placement.X.translation
        fallen = 0.5 * GRAVITY * (time_s - placement.start_s) ** 2
        return Pose(placement.X.rotation, (x, y, z - fallen))
    return placement.X
