"""The controller's machine: one robot program, tick by tick.

Order within a tick: commands, signal inputs, the hand, then at most `STEPS_A_TICK` steps of the
program. Motion needs no work of its own, because it is planned as polynomials when it is issued.
Ticks in which nothing can happen are skipped.
"""

import math
from typing import NamedTuple

from vrts.base.diagnostic import Diagnostic
from vrts.engine.context import Context
from vrts.engine.events import Cause, Found, ProgramEnded, ProgramStarted, SignalChanged
from vrts.engine.executable import Executable
from vrts.engine.faults import RuntimeFault
from vrts.engine.hand import Hand
from vrts.engine.outcomes import (
    BLOCKED,
    CYCLE_ENDED,
    HALTED,
    INSTANT,
    MOTIONS,
    OUTPUT,
    PAUSED,
    SIMULATED_TIME,
    STATEMENTS,
    SWITCHED,
    LimitReached,
)
from vrts.engine.planner import Planner
from vrts.engine.records import Ending
from vrts.engine.signals import Signals
from vrts.engine.terminal import Terminal
from vrts.ir.commands import Execute, TimedCommand
from vrts.scene.model import Scenario, Scene

STEPS_A_TICK = 100  # of the robot program [assumed, val2.md 3.7]
HAND_TIME = "hand.time"  # parameter: wait after OPENI, CLOSEI, RELAXI [s]


class Place(NamedTuple):
    """Where the program is: program number and next instruction of every frame, outermost first."""

    time_s: float
    frames: tuple[tuple[int, int], ...]


class Machine:
    """All state of a run in progress. Mutable; a Run holds one and never changes it again."""

    def __init__(self, executable: Executable, scene: Scene, scenario: Scenario) -> None:
        """Stand at time 0 with nothing executing."""
        arm, gripper = scene.robot.arm, scene.robot.gripper
        self.executable = executable
        self.scene = scene
        self.scenario = scenario
        self.tick = arm.tick
        self.context = Context(
            executable.memory(),
            Planner(arm, scenario.configuration or arm.ready, scene.X_FT),
            Hand(scene, scenario.hand_opening),
            Signals(scenario.inputs),
            Terminal(),
            scenario.parameters.get(HAND_TIME, gripper.stroke_time),
            scenario.seed,
        )
        self.initial_configuration = self.context.planner.configuration
        self.initial_opening = scenario.hand_opening
        self.next_tick = 0
        self.issued: tuple[TimedCommand, ...] = ()  # by time; those obeyed come first
        self.obeyed = 0
        self.commands: tuple[TimedCommand, ...] = ()  # still to come
        self.ending = Ending.NOT_STARTED
        self.ended_s: float | None = None
        self.started_s = 0.0
        self.program: tuple[str, int] = ("", 0)  # of EXECUTE: name and cycles left
        self.statements = 0
        self.places: list[Place] = []

    def copy(self) -> "Machine":
        """Return an independent machine that shares the past."""
        other = Machine.__new__(Machine)
        other.__dict__.update(self.__dict__)
        other.context = self.context.copy()
        other.places = self.places.copy()
        return other

    @property
    def running(self) -> bool:
        """Whether a program executes."""
        return self.ending is Ending.RUNNING

    def issue(self, commands: tuple[TimedCommand, ...]) -> None:
        """Add commands, at times from now on, to those still to come."""
        self.know((*self.issued, *commands))

    def know(self, issued: tuple[TimedCommand, ...]) -> None:
        """Take these for all commands ever issued; those obeyed are among them."""
        self.issued = tuple(sorted(issued, key=lambda c: c.time_s))
        self.commands = self.issued[self.obeyed :]

    def advance(self, until_s: float) -> None:
        """Run every tick up to a time [s]."""
        while True:
            now = self.next_tick * self.tick
            if now > until_s + INSTANT or not self._has_work():
                break
            self._run_tick(now)
        self.context.hand.settle_until(until_s, self.context.events)

    def _has_work(self) -> bool:
        return self.running or bool(self.commands)

    def _run_tick(self, now: float) -> None:
        c = self.context
        c.now = now
        while self.commands and self.commands[0].time_s <= now + INSTANT:
            command, self.commands = self.commands[0].command, self.commands[1:]
            self.obeyed += 1
            self._obey(command)
        for signal, on in c.signals.sample(now):
            c.events.append(SignalChanged(now, signal, on, None))
        c.hand.settle_until(now, c.events)
        c.wake = now
        if self.running:
            self._run_program()
            self._note_place()
        self.next_tick += 1
        if self.running and c.wake > now:
            self._skip_to(c.wake)
        elif not self.running and self.commands:
            self._skip_to(self.commands[0].time_s)

    def _skip_to(self, time_s: float) -> None:
        times = [time_s]
        if self.commands:
            times.append(self.commands[0].time_s)
        coming = self.context.signals.next_input_s
        if coming is not None:
            times.append(coming)
        tick = math.ceil(min(times) / self.tick - INSTANT / self.tick)
        self.next_tick = max(self.next_tick, tick)

    def _obey(self, command: Execute) -> None:
        c = self.context
        number = self.executable.numbers[command.program]
        c.frames = [self.executable.frame(number, self.executable.fresh_slots(number))]
        c.slots = c.frames[0].slots
        program = self.executable.programs[number].program
        steps = program.steps
        c.frames[0].index = steps[min(command.step, len(steps)) - 1] if steps else 0
        c.phase, c.next_hand = 0, []
        c.planner.reset_settings()
        self.program = (command.program, command.cycles or 1)
        self.started_s = c.now
        self.ending, self.ended_s = Ending.RUNNING, None
        c.events.append(ProgramStarted(c.now, command.program))

    def _run_program(self) -> None:
        try:
            self._run_steps()
            self._check_limits()
        except RuntimeFault as fault:
            self._end(Ending.ERROR, fault.diagnostic(self._cause().span))
        except LimitReached as limit:
            self._end(Ending.LIMIT, limit.diagnostic)

    def _run_steps(self) -> None:
        c = self.context
        for _ in range(STEPS_A_TICK):
            frame = c.frames[-1]
            outcome = self.executable.programs[frame.program].steps[frame.index](c)
            self.statements += 1
            if outcome >= 0:
                frame.index = outcome
            elif outcome == BLOCKED:
                return
            elif outcome == CYCLE_ENDED:
                if not self._begin_cycle():
                    self._end(Ending.COMPLETED, None)
                    return
            elif outcome == HALTED:
                self._end(Ending.HALTED, None)
                return
            elif outcome == PAUSED:
                self._end(Ending.PAUSED, None)
                return
            else:
                assert outcome == SWITCHED
        c.wake = c.now

    def _begin_cycle(self) -> bool:
        name, cycles = self.program
        if cycles == 1:
            return False
        c = self.context
        self.program = (name, cycles - 1 if cycles > 0 else cycles)
        number = self.executable.numbers[name]
        c.frames = [self.executable.frame(number, self.executable.fresh_slots(number))]
        c.slots = c.frames[0].slots
        c.planner.reset_settings()
        return True

    def _end(self, ending: Ending, diagnostic: Diagnostic | None) -> None:
        """End the program; it is over when the arm stands still."""
        c = self.context
        cause = self._cause()
        if diagnostic is not None:
            c.events.append(Found(c.now, diagnostic, cause))
        self.ending = ending
        self.ended_s = max(c.now, c.planner.settled_at)
        c.events.append(ProgramEnded(self.ended_s, ending.value, cause))

    def _check_limits(self) -> None:
        limits, c = self.scenario.limits, self.context
        span = self._cause().span
        elapsed = c.now - self.started_s
        if self.statements > limits.statements:
            raise LimitReached(
                STATEMENTS,
                f"the program is still running after {limits.statements:,} steps",
                span,
                f"it was stopped here, after {elapsed:.0f} s of simulated time",
                "check that every loop comes to an end",
            )
        if elapsed > limits.time_s:
            raise LimitReached(
                SIMULATED_TIME,
                f"the program is still running after {limits.time_s:.0f} s",
                span,
                "it was stopped here, at the longest time it may take",
                "if no loop repeats for ever, the arm is too slow: look at SPEED",
            )
        if len(c.planner.motions) > limits.motions:
            raise LimitReached(
                MOTIONS,
                f"the program makes more than {limits.motions:,} motions",
                span,
                "it was stopped here",
                "check that every loop comes to an end",
            )
        if c.terminal.characters > limits.output_characters:
            raise LimitReached(
                OUTPUT,
                f"the program writes more than {limits.output_characters:,} characters",
                span,
                "it was stopped here",
                "check the loop that writes",
            )

    def _cause(self) -> Cause:
        frame = self.context.frames[-1]
        causes = self.executable.programs[frame.program].causes
        return causes[min(frame.index, len(causes) - 1)]

    def _note_place(self) -> None:
        frames = tuple((frame.program, frame.index) for frame in self.context.frames)
        if not self.places or self.places[-1].frames != frames:
            self.places.append(Place(self.context.now, frames))
