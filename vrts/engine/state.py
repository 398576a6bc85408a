"""A run at one instant: all that can be asked."""

from bisect import bisect_right
from collections.abc import Hashable, Iterator, Mapping
from typing import TypeVar

from vrts.base.pose import IDENTITY, Pose
from vrts.base.source import Span
from vrts.engine.history import ProgramHistory
from vrts.engine.memory.cells import UNDEFINED, Array, cells_of
from vrts.engine.memory.event_order import QUESTION, progress, spells, tracks_of
from vrts.engine.memory.events import (
    AnalogChanged,
    Cause,
    Event,
    Printed,
    ProgramEnded,
    ProgramProgressed,
    ProgramStarted,
    Prompted,
    SignalChanged,
    SpeedChanged,
    SwitchChanged,
)
from vrts.engine.memory.records import (
    INSTANT,
    Ending,
    Lie,
    Placement,
    ProgramState,
    ProgramStatus,
    pose_of,
)
from vrts.engine.memory.trace import Activation
from vrts.engine.record import Record
from vrts.ir.module import Module
from vrts.ir.system import SWITCHES
from vrts.ir.values import Value
from vrts.robots.kinematics.kinematics import hand_pose
from vrts.robots.model import Configuration

E = TypeVar("E", bound=Event)


FINISHED = (Ending.COMPLETED.value, Ending.HALTED.value)  # nothing is left to go on with


class State:
    """A run at one instant; parts are worked out when they are asked for."""

    __slots__ = ("_finished", "_run", "_within", "time_s")

    def __init__(self, run: Record, time_s: float, finished: int | None) -> None:
        """Remember the run and the instant; None is after all that happened in its tick."""
        self._run = run
        self._finished = self._within = finished
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
        return hand_pose(self._run.scene.robot.arm, self.configuration)

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
        motion = self._run.motion_begun(self.time_s)
        if motion is not None and self.time_s <= motion.end_s:
            return self.X_WF @ motion.X_FT
        return self.X_WF @ self.X_FT

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
        for event in self._events(SignalChanged):
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
        motion = self._run.motion_begun(self.time_s)
        return 100.0 * motion.speed_fraction if motion is not None else 100.0

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
        return self.locals_of(self._run.history.robot.trace.activation(self.finished))

    def locals_of(self, activation: Activation | None) -> Mapping[str, Value]:
        """Return the same of any program that is being executed."""
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
        return isinstance(self._last(QUESTION), Prompted)

    @property
    def cause(self) -> Cause | None:
        """The instruction of the motion under way, else the one the program is at."""
        motion = self._run.motion_begun(self.time_s)
        if motion is not None and self.time_s < motion.end_s:
            return motion.cause
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
        whole = self._within is None
        known = self._run.happened(kind, self.time_s) if whole else self._happened()
        return [event for event in known if isinstance(event, kind)]

    def _last(self, track: Hashable) -> Event | None:
        """Return the last event of a track of `event_order`."""
        if self._within is None:
            return self._run.last(track, self.time_s)
        found: Event | None = None
        for event in self._happened():
            if track in tracks_of(event):
                found = event
        return found

    def _happened(self) -> Iterator[Event]:
        """Go through what has happened, within a tick as far as statements are finished."""
        run = self._run
        count = bisect_right(run.events, self.time_s, key=lambda event: event.time_s)
        for event, number in zip(run.events[:count], run.event_numbers[:count], strict=True):
            if number <= self.finished or event.time_s < self.time_s - INSTANT:
                yield event

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
        spell = self._last(spells(is_robot=program.is_robot))
        if not isinstance(spell, ProgramStarted | ProgramProgressed | ProgramEnded):
            return None  # none was executed yet
        stack = self._stack(program)
        cause = stack[-1] if stack else None
        at = self._last(progress(is_robot=program.is_robot))
        assert isinstance(at, ProgramProgressed)  # one comes with the beginning
        if isinstance(spell, ProgramEnded):
            done = spell.ending in FINISHED
            status = ProgramStatus.COMPLETED if done else ProgramStatus.STOPPED
            cause = spell.cause
        elif isinstance(spell, ProgramProgressed) and not spell.running:
            status = ProgramStatus.STOPPED if stack else ProgramStatus.NOT_RUNNING
        else:
            waits = program.waits and self.time_s >= self._run.history.now_s
            status = ProgramStatus.WAITING if waits else ProgramStatus.RUNNING
        return ProgramState(at.program, status, at.cycles_done, at.cycles_left, at.priority, cause)
