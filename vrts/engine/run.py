"""The record of one execution: everything that happened up to a horizon, at any time."""

from bisect import bisect_right
from collections.abc import Mapping, Sequence
from functools import cached_property
from typing import TypeVar

from vrts.base.diagnostic import Diagnostic
from vrts.base.pose import IDENTITY, Pose
from vrts.base.source import Span
from vrts.engine.cells import UNDEFINED, Array, cells_of
from vrts.engine.events import (
    AnalogChanged,
    Answered,
    Cause,
    Event,
    Found,
    MotionEnded,
    MotionStarted,
    Printed,
    ProgramEnded,
    ProgramStarted,
    Prompted,
    SignalChanged,
    SpeedChanged,
    SwitchChanged,
)
from vrts.engine.history import History, ProgramHistory, history_of
from vrts.engine.machine import Machine
from vrts.engine.records import (
    Ending,
    Lie,
    Motion,
    Placement,
    ProgramState,
    ProgramStatus,
    pose_of,
)
from vrts.engine.timeline import Timeline
from vrts.engine.trace import Activation
from vrts.ir.module import Module
from vrts.ir.system import SWITCHES
from vrts.ir.values import Value
from vrts.robots.kinematics import forward
from vrts.robots.model import Configuration
from vrts.scene.model import Scenario, Scene

__all__ = ["OutOfHorizon", "Run", "State", "pose_of"]


E = TypeVar("E", bound=Event)


FINISHED = (Ending.COMPLETED.value, Ending.HALTED.value)  # nothing is left to go on with


class OutOfHorizon(ValueError):  # noqa: N818 -- names the situation, as the glossary does
    """A time or a statement was asked for at which the run is not known."""

    def __init__(self, time_s: float, horizon_s: float) -> None:
        """Say which time, and how far the run reaches."""
        super().__init__(f"time {time_s} s is outside 0 to {horizon_s} s")
        self.time_s = time_s
        self.horizon_s = horizon_s


class Run:
    """One execution up to its horizon. Immutable; `controller.advance` makes longer ones."""

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
    def motions(self) -> Sequence[Motion]:
        """Every motion issued, in run time."""
        return self._motions

    @cached_property
    def _motions(self) -> Sequence[Motion]:
        arm = self.history.arm
        if arm.scale.plain:
            return arm.motions
        time = arm.scale.time
        return [
            motion._replace(start_s=time(motion.start_s), end_s=time(motion.end_s))
            for motion in arm.motions
        ]

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
        known = (e for e in self.history.events if e.time_s <= self.horizon_s)
        return tuple(sorted(known, key=_order))

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

    def spell(self, time_s: float, *, is_robot: bool) -> ProgramStarted | ProgramEnded | None:
        """Return the event by which the robot program or the other last began or ended."""
        times, events = self._spells[is_robot]
        found = bisect_right(times, time_s)
        return events[found - 1] if found else None

    def executed(self, time_s: float, *, is_robot: bool) -> str:
        """Return the name of the program that began last; empty when none has."""
        times, events = self._spells[is_robot]
        for event in reversed(events[: bisect_right(times, time_s)]):
            if isinstance(event, ProgramStarted):
                return event.program
        return ""

    @cached_property
    def _spells(self) -> Mapping[bool, tuple[list[float], list[ProgramStarted | ProgramEnded]]]:
        found: dict[bool, tuple[list[float], list[ProgramStarted | ProgramEnded]]] = {}
        for is_robot in (True, False):
            events = [
                event
                for event in self.events
                if isinstance(event, ProgramStarted | ProgramEnded)
                and event.process is not is_robot
            ]
            found[is_robot] = ([event.time_s for event in events], events)
        return found

    def at(self, time_s: float) -> "State":
        """Return the state at a time, after all that happened in its tick; in any order of asking.

        Raises:
            OutOfHorizon: The run does not reach so far.
        """
        if not 0.0 <= time_s <= self.horizon_s:
            raise OutOfHorizon(time_s, self.horizon_s)
        return State(self, time_s, None)

    def at_statement(self, finished: int) -> "State":
        """Return the state after a number of statements, in any order of asking.

        Raises:
            OutOfHorizon: So many were not executed.
        """
        if not 0 <= finished <= self.statements:
            raise OutOfHorizon(finished, self.statements)
        return State(self, self.history.time_of(finished), finished)

    @property
    def _last_s(self) -> float:
        """End of everything under way when the program ended [s]."""
        hand = self.history.hand
        strokes = [stroke.end_s for stroke in hand.strokes[-1:]]
        landings = [track[-1].start_s for track in hand.placements.values()]
        return max([0.0, *strokes, *landings])


def _order(event: Event) -> tuple[int, int]:
    rank = 0 if isinstance(event, MotionEnded) else 1 if isinstance(event, MotionStarted) else 2
    return round(event.time_s * 1e9), rank


class State:
    """A run at one instant; parts are worked out when they are asked for."""

    __slots__ = ("_finished", "_run", "time_s")

    def __init__(self, run: Run, time_s: float, finished: int | None) -> None:
        """Remember the run and the instant; None is after all that happened in its tick."""
        self._run = run
        self._finished = finished
        self.time_s = time_s

    @property
    def finished(self) -> int:
        """Statements finished."""
        if self._finished is None:
            self._finished = self._run.history.finished_at(self.time_s)
        return self._finished

    # --- the arm ------------------------------------------------------------------------------

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
    def X_FT(self) -> Pose:
        """The tool that TOOL set last."""
        held = self._run.history.memory.tool.at(self.finished)
        return held if isinstance(held, Pose) else self._run.scene.X_FT

    @property
    def base(self) -> Pose:
        """X_VB: how BASE says that the robot was displaced."""
        held = self._run.history.memory.base.at(self.finished)
        return held if isinstance(held, Pose) else IDENTITY

    @property
    def X_WT(self) -> Pose:
        """Pose of the tool in force at the motion under way or just done."""
        motions = self._run.motions
        found = bisect_right(motions, self.time_s, key=lambda motion: motion.start_s)
        under_way = found and self.time_s <= motions[found - 1].end_s
        return self.X_WF @ (motions[found - 1].X_FT if under_way else self.X_FT)

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
    def switches(self) -> Mapping[str, bool]:
        """System switches."""
        found = {name: switch.on for name, switch in SWITCHES.items()}
        for event in self._events(SwitchChanged):
            found[event.switch] = event.on
        return found

    @property
    def parameters(self) -> Mapping[str, float]:
        """Parameters of the controller that were set."""
        cells = self._run.history.memory.parameters
        values = {name: cell.at(self.finished) for name, cell in cells.items()}
        return {name: v for name, v in values.items() if isinstance(v, float)}

    @property
    def analog(self) -> Mapping[int, float]:
        """Analog outputs that were set [counts]."""
        return {event.channel: event.value for event in self._events(AnalogChanged)}

    @property
    def monitor_speed(self) -> float:
        """The operator's speed [%]."""
        percent = self._run.scenario.monitor_speed
        for event in self._events(SpeedChanged):
            percent = event.percent
        return percent

    @property
    def program_speed(self) -> float:
        """Speed of the motion under way or just done [%]."""
        motions = self._run.motions
        found = bisect_right(motions, self.time_s, key=lambda motion: motion.start_s)
        return 100.0 * motions[found - 1].speed_fraction if found else 100.0

    # --- programs -----------------------------------------------------------------------------

    @property
    def module(self) -> Module:
        """The programs in memory at the horizon."""
        return self._run.module

    @property
    def variables(self) -> Mapping[str, Value]:
        """Global variables that have a value, array elements included."""
        finished = self.finished
        found: dict[str, Value] = {}
        for bound in self._run.history.memory.bound:
            for cell in cells_of(bound):
                value = cell.at(finished)
                if value is not UNDEFINED:
                    found[cell.name] = value  # type: ignore[assignment]
        return found

    @property
    def locals(self) -> Mapping[str, Value]:
        """Arguments and automatic variables of the innermost program that have a value."""
        activation = self._run.history.robot.trace.activation(self.finished)
        found: dict[str, Value] = {}
        if activation is None:
            return found
        program = self._run.history.code.programs[activation.program]
        slots = (*program.formals, *program.autos)
        for slot, bound in zip(slots, activation.slots, strict=True):
            cells = bound.elements.values() if isinstance(bound, Array) else (bound,)
            for cell in cells:
                value = cell.at(self.finished)
                if value is not UNDEFINED:
                    _, bracket, subscripts = cell.name.partition("[")
                    name = (
                        slot.name + bracket + subscripts if isinstance(bound, Array) else slot.name
                    )
                    found[name] = value  # type: ignore[assignment]
        return found

    @property
    def call_stack(self) -> tuple[Cause, ...]:
        """The step that every active program of the robot is at, outermost first."""
        return self._stack(self._run.history.robot)

    @property
    def process_stack(self) -> tuple[Cause, ...]:
        """The same of the process control program."""
        return self._stack(self._run.history.process)

    @property
    def robot(self) -> ProgramState | None:
        """The robot program; None when none was executed yet."""
        return self._program(self._run.history.robot)

    @property
    def process(self) -> ProgramState | None:
        """The process control program; None when none was executed yet."""
        return self._program(self._run.history.process)

    @property
    def awaits_answer(self) -> bool:
        """Whether a PROMPT waits for a line."""
        asked = False
        for event in self._run.events:
            if event.time_s > self.time_s:
                break
            if isinstance(event, Prompted):
                asked = True
            elif isinstance(event, Answered | ProgramEnded):
                asked = False
        return asked

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
    def instruction(self) -> Cause | None:
        """The step that the robot program executes next, or waits at."""
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
        return "".join(event.text for event in self._events(Printed))

    # --- parts --------------------------------------------------------------------------------

    def _events(self, kind: type[E]) -> list[E]:
        return [
            event
            for event in self._run.events
            if event.time_s <= self.time_s and isinstance(event, kind)
        ]

    def _stack(self, program: ProgramHistory) -> tuple[Cause, ...]:
        causes = self._run.history.code.causes
        activation = program.trace.activation(self.finished)
        if activation is None:
            return ()
        following = program.trace.following(self.finished, self._run.history.finished)
        if following is None:
            following = program.place
        if following is None:
            return ()
        stack = [causes[following]]
        at: Activation | None = activation
        while at is not None and at.called_from is not None:
            stack.append(causes[at.called_from])
            at = at.caller
        return tuple(reversed(stack))

    def _program(self, program: ProgramHistory) -> ProgramState | None:
        spell = self._run.spell(self.time_s, is_robot=program.is_robot)
        if spell is None:
            return None
        stack = self._stack(program)
        cause = stack[-1] if stack else None
        if isinstance(spell, ProgramEnded):
            done = spell.ending in FINISHED
            status = ProgramStatus.COMPLETED if done else ProgramStatus.STOPPED
            cause = spell.cause
        else:
            waits = program.waits and self.time_s >= self._run.history.now_s
            status = ProgramStatus.WAITING if waits else ProgramStatus.RUNNING
        return ProgramState(
            self._run.executed(self.time_s, is_robot=program.is_robot),
            status,
            program.cycles_done,
            program.cycles_left,
            program.priority,
            cause,
        )
