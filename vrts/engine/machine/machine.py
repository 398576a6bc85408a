"""The controller's machine: two programs and an arm, tick by tick.

Order within a tick: commands, faults of the scenario, signal inputs and sensors, the hand, then
reactions, at most `STEPS_A_TICK` steps of the robot program, as many of the process control
program. Motion needs no work of its own, because it is planned as polynomials when it is issued.
Ticks in which nothing can happen are skipped.
"""

import math
from array import array
from bisect import bisect_right

from vrts.base.diagnostic import Diagnostic
from vrts.engine.code.executable import Executable
from vrts.engine.code.steps.motion_steps import CUT_SHORT
from vrts.engine.faults import RuntimeFault
from vrts.engine.hand.hand import Hand
from vrts.engine.machine.endless import Watcher
from vrts.engine.machine.execution import execute, fail
from vrts.engine.machine.limits import stuck
from vrts.engine.machine.obey import obey
from vrts.engine.machine.sensing import Sensing
from vrts.engine.memory.cells import Bound, cells_of
from vrts.engine.memory.events import (
    Found,
    MotionEnded,
    MotionStarted,
    SignalChanged,
    SwitchChanged,
)
from vrts.engine.memory.records import INSTANT, Ending
from vrts.engine.motion.planner import Planner
from vrts.engine.motion.remarks import worded
from vrts.engine.programs.context import Context
from vrts.engine.programs.cycles import end as end_program
from vrts.engine.programs.cycles import note_progress, place, rest
from vrts.engine.programs.signals import Signals
from vrts.engine.programs.stopped import Stopped
from vrts.engine.programs.system import System
from vrts.engine.programs.terminal import Terminal
from vrts.ir.commands import TimedCommand
from vrts.ir.runtime_errors import RuntimeErrorKind
from vrts.scene.model import FaultKind, Scenario, Scene

STEPS_A_TICK = 100  # of each program [assumed, manual language/processes#share]


class Lineage:
    """Which version of a machine wrote last to the histories that versions share."""

    __slots__ = ("writes",)

    def __init__(self) -> None:
        """Start with nothing written."""
        self.writes = 0


class Machine:
    """All state of a run in progress. Mutable; a Run holds one and never changes it again."""

    def __init__(self, executable: Executable, scene: Scene, scenario: Scenario) -> None:
        """Stand at time 0 with nothing executing."""
        arm = scene.robot.arm
        self.scene = scene
        self.scenario = scenario
        self.tick = arm.tick
        rate = scenario.monitor_speed / 100.0
        configuration = scenario.configuration or arm.ready
        self.executable = executable
        self.system = System(
            executable.programs,
            executable.memory(),
            Planner(arm, configuration, scene.X_FT, rate),
            Hand(scene, scenario.hand_opening),
            Signals(scenario.inputs),
            Terminal(),
            scenario.seed,
        )
        self.initial_opening = scenario.hand_opening
        self.robot = Context(self.system, is_robot=True)
        self.process = Context(self.system, is_robot=False)
        self._wire()
        for name, value in scenario.parameters.items():
            self.system.set_parameter(name.upper(), value, 0)
        for answer in scenario.answers:
            self.system.answers.append(answer)
        self.sensing = Sensing(scene, scenario)
        self.next_tick = 0
        self.last_tick = -1  # the last one run
        self.issued: tuple[TimedCommand, ...] = ()  # by time; those obeyed come first
        self.obeyed = 0
        self.closed = False  # no further command will come
        self.ended_s: float | None = None  # the robot program is over and the arm stands still
        self.started_s = 0.0
        self.finished = 0  # statements of both programs
        self.ticks = array("I")  # ticks in which statements were executed
        self.counts = array("I")  # beside `ticks`: statements finished after it
        self.moved = 0  # motions whose start was noted
        self.arrived = 0  # motions whose end was noted
        self.faults_done = 0
        self.stopped: Stopped | None = None  # the program that stopped before a DO
        self.watcher = Watcher()
        self.lineage = Lineage()
        self.written = 0

    # --- versions -----------------------------------------------------------------------------

    def copy(self) -> "Machine":
        """Return an independent machine that shares the past."""
        other = Machine.__new__(Machine)
        other.__dict__.update(self.__dict__)
        copies: dict[int, Bound] = {}
        other.system = self.system.copy(copies)
        other.robot = self.robot.copy(other.system, copies)
        other.process = self.process.copy(other.system, copies)
        other.watcher = self.watcher.copy()
        if self.stopped is not None:
            other.stopped = self.stopped.copy(copies)
        other._wire()
        return other

    def _wire(self) -> None:
        for c in (self.robot, self.process):
            c.robot, c.process = self.robot, self.process
        self.system.hand.planner = self.system.planner
        self.system.events.counted = self.counted

    def counted(self) -> int:
        """Return how many statements are finished, the one under way included."""
        return max(self.finished, self.robot.finished, self.process.finished)

    def write(self) -> None:
        """Begin to add to the shared histories; part from versions that went on before."""
        if self.written != self.lineage.writes:
            self._part()
        self.lineage.writes += 1
        self.written = self.lineage.writes

    def _part(self) -> None:
        self.lineage = Lineage()
        kept = bisect_right(self.counts, self.finished)
        self.ticks, self.counts = self.ticks[:kept], self.counts[:kept]
        seen: set[int] = set()
        bounds: list[Bound] = [*self.system.memory.bound]
        for c in (self.robot, self.process):
            c.trace.cut(self.finished)
            c.trace.activate(self.finished, c.activation)
            bounds += [slot for frame in c.frames for slot in frame.slots]
        for bound in bounds:
            if id(bound) not in seen:
                seen.add(id(bound))
                for cell in cells_of(bound):
                    cell.cut(self.finished)
        for cell in self.system.cells():
            cell.cut(self.finished)

    def take_over(self, executable: Executable) -> None:
        """Have other programs in memory from now on."""
        self.executable = executable
        self.system.programs = executable.programs

    # --- what has happened --------------------------------------------------------------------

    @property
    def now(self) -> float:
        """Time of the last tick that was run [s]."""
        return max(self.last_tick, 0) * self.tick

    @property
    def running(self) -> bool:
        """Whether a program executes."""
        return self.robot.running or self.process.running

    def signals_to_come(self) -> bool:
        """Return whether inputs, faults or commands may still change something."""
        system = self.system
        return (
            system.signals.next_input_s is not None
            or bool(system.scheduled)
            or self.faults_done < len(self.scenario.faults)
            or self._next_command() is not None
        )

    def steps_between(self, first: int, last: int) -> str:
        """Return which steps the robot program executed between two counts of statements."""
        trace, causes = self.robot.trace, self.system.programs.causes
        begin, stop = trace.executed(first), trace.executed(last)
        steps = sorted(
            {causes[k].step for k in trace.instructions[begin:stop][-STEPS_A_TICK * 50 :]}
        )
        return f"{steps[0]} to {steps[-1]}" if len(steps) > 1 else str(steps[0])

    # --- commands -----------------------------------------------------------------------------

    def issue(self, commands: tuple[TimedCommand, ...]) -> None:
        """Add commands, at times from now on, to those still to come."""
        self.know((*self.issued, *commands))

    def know(self, issued: tuple[TimedCommand, ...]) -> None:
        """Take these for all commands ever issued; those obeyed are among them."""
        self.issued = tuple(sorted(issued, key=lambda c: c.order))
        coming = self._next_command()
        if coming is not None:  # a tick that was to be skipped may be needed now
            self.next_tick = min(self.next_tick, max(self._tick_of(coming), self.last_tick + 1))

    def _next_command(self) -> float | None:
        return self.issued[self.obeyed].time_s if self.obeyed < len(self.issued) else None

    # --- ticks --------------------------------------------------------------------------------

    def advance(self, until_s: float, *, stop_when_idle: bool = False) -> None:
        """Run every tick up to a time [s], or until nothing executes and nothing moves."""
        self.write()
        last = math.floor(until_s / self.tick + INSTANT / self.tick)
        while self.next_tick <= last and self.has_work():
            if stop_when_idle and self._idle():
                break
            self._run_tick(self.next_tick)
        self.settle(until_s)

    def settle(self, until_s: float) -> None:
        """Note what needs no tick: grasps, and motions that begin and end."""
        self.system.hand.settle_until(until_s, self.system.events)
        self._note_motions(until_s)

    def has_work(self) -> bool:
        """Return whether anything is still to be done."""
        if self.closed and not self.robot.running and self._next_command() is None:
            return False
        return self.running or self._next_event() is not None or self._next_command() is not None

    def _idle(self) -> bool:
        if self.last_tick < 0 or self._next_command() is not None:
            return False
        if self.robot.running and self.robot.wake != math.inf:
            return False
        if self.robot.running and self._future() is not None:
            return False
        return self.system.planner.settled_at <= self.now + INSTANT

    def _run_tick(self, tick: int) -> None:
        now = tick * self.tick
        self.last_tick, self.next_tick = tick, tick + 1
        system = self.system
        self.robot.now = self.process.now = now
        self._note_motions(now)
        self.obey(now)
        self._bring_faults_about(now)
        self._sample(now)
        system.hand.settle_until(now, system.events)
        before = self.finished
        on = system.signals.changes
        self._execute(now)
        while self._due_now():  # what a debugger does at the end of the tick
            self.obey(now)
            self._execute(now)
        progress = self.finished != before
        if progress:
            self.ticks.append(tick)
            self.counts.append(self.finished)
        self._look_for_loops(now)
        if self.running:
            self._plan_next(now, progress=progress, stirred=on != system.signals.changes)
        else:
            following = self._future()
            self._skip_to(following if following is not None else now)

    def _execute(self, now: float) -> None:
        for c in (self.robot, self.process):
            if c.running:
                execute(self, c, now)

    def _plan_next(self, now: float, *, progress: bool, stirred: bool) -> None:
        """Choose the next tick that has to be run."""
        programs = [c for c in (self.robot, self.process) if c.running]
        if any(c.wake <= now for c in programs):
            return  # some program goes on at the next tick
        if progress and any(c.wake == math.inf for c in programs):
            return  # what one program has changed another may wait for
        if stirred and any(c.watches for c in programs):
            return
        waking = min(c.wake for c in programs)
        if self.closed and waking < math.inf:  # the limit is noticed when it is reached
            latest = min(c.started_s for c in programs) + self.scenario.limits.time_s
            waking = min(waking, latest + self.tick)
        following = self._future()
        if following is not None and following < waking:
            waking = following
        if waking < math.inf:
            self._skip_to(waking)
        elif self.closed and self.robot.running:
            self.end(self.robot, Ending.LIMIT, stuck(self.robot, now))

    def _skip_to(self, time_s: float) -> None:
        self.next_tick = max(self.next_tick, self._tick_of(time_s))

    def _tick_of(self, time_s: float) -> int:
        return math.ceil(time_s / self.tick - INSTANT / self.tick)

    def _future(self) -> float | None:
        """Return when something next happens that programs may notice; None when nothing will."""
        times = [t for t in (self._next_command(), self._next_event()) if t is not None]
        return min(times, default=None)

    def _next_event(self) -> float | None:
        """Return when an input, a sensor, the hand or a fault may change something next."""
        system = self.system
        times = [system.signals.next_input_s, system.hand.next_s]
        if system.scheduled:
            times.append(system.scheduled[0][0])
        faults = self.scenario.faults
        if self.faults_done < len(faults):
            times.append(faults[self.faults_done].time_s)
        times.append(self.sensing.next_s(system, self.now, self.tick))
        known = [t for t in times if t is not None]
        return max(min(known), self.now + self.tick) if known else None

    # --- parts of a tick ----------------------------------------------------------------------

    def _note_motions(self, until_s: float) -> None:
        planner, events = self.system.planner, self.system.events
        committed = len(planner.motions) - (planner.pending is not None)
        while self.arrived < committed:
            motion = planner.motions[self.arrived]
            if self.moved == self.arrived:
                start = planner.scale.time(motion.start_s)
                if start > until_s + INSTANT:
                    return
                events.append(MotionStarted(start, self.moved, motion.cause))
                for remark in planner.remarks.pop(self.moved, ()):
                    finding = worded(remark, motion.cause.span)
                    events.append(Found(start, finding, motion.cause))
                self.moved += 1
            finish = planner.scale.time(motion.end_s)
            open_end = self.arrived == committed - 1 and planner.pending is not None
            if finish > until_s + INSTANT or open_end:
                return
            events.append(MotionEnded(finish, self.arrived, motion.cause))
            self.arrived += 1

    @property
    def due_after(self) -> int | None:
        """Statements after which the next command of this tick is to be obeyed."""
        if self.obeyed >= len(self.issued):
            return None
        timed = self.issued[self.obeyed]
        return timed.after if timed.time_s <= self.now + INSTANT else None

    def _due_now(self) -> bool:
        return self.due_after is not None and self.due_after <= self.finished

    def obey(self, now: float) -> None:
        """Obey the commands that are due."""
        while self.obeyed < len(self.issued) and self.issued[self.obeyed].time_s <= now + INSTANT:
            time_s, command, after = self.issued[self.obeyed]
            if after is not None and after > self.finished and time_s > now - self.tick + INSTANT:
                return  # it comes within this tick
            self.obeyed += 1
            self.finished += 1  # so that before and after can be told apart
            obey(command, self, now)
            for c in (self.robot, self.process):
                rest(c, self.finished)
            self.ticks.append(self.last_tick)
            self.counts.append(self.finished)

    def _bring_faults_about(self, now: float) -> None:
        faults, system = self.scenario.faults, self.system
        while self.faults_done < len(faults) and faults[self.faults_done].time_s <= now + INSTANT:
            fault = faults[self.faults_done]
            self.faults_done += 1
            match fault.kind:
                case FaultKind.INPUT_STUCK:
                    if system.signals.stick(fault.signal, on=fault.on):
                        system.events.append(SignalChanged(now, fault.signal, fault.on, None))
                case FaultKind.GRIPPER_SLIPS:
                    system.hand.let_slip(now, None, system.events)
                case FaultKind.EMERGENCY_STOP:
                    self._emergency_stop(now)

    def _emergency_stop(self, now: float) -> None:
        system = self.system
        system.planner.brake(now)
        system.hand.path_changed(now)
        system.powered = False
        system.switches["POWER"] = False
        system.events.append(SwitchChanged(now, "POWER", False, None))
        if self.robot.running:
            fault = RuntimeFault(
                RuntimeErrorKind.ROBOT_POWER_OFF, "the emergency stop was pressed", None
            )
            fail(self, self.robot, fault)

    def _sample(self, now: float) -> None:
        system = self.system
        changed = system.signals.sample(now)
        while system.scheduled and system.scheduled[0][0] <= now + INSTANT:
            _, number, state = system.scheduled.pop(0)
            if system.signals.turn(number, on=state):
                changed.append((number, state))
        changed += self.sensing.sample(system, now)
        for signal, on in changed:
            system.events.append(SignalChanged(now, signal, on, None))

    # --- programs -----------------------------------------------------------------------------

    def end(self, c: Context, ending: Ending, diagnostic: Diagnostic | None) -> None:
        """End a program; after an error the arm slows down along its path."""
        planner = self.system.planner
        if diagnostic is not None:
            c.events.append(Found(c.now, diagnostic, place(c)))
        if c.is_robot:
            if ending in (Ending.ERROR, Ending.LIMIT, Ending.ABORTED):
                planner.brake(c.now)
            else:
                planner.take_back(c.now)
            self.system.hand.path_changed(c.now)
            self.ended_s = max(c.now, self._tick_of(planner.settled_at) * self.tick)
            end_program(c, ending, self.ended_s)
            self._give_back()
        else:
            end_program(c, ending, c.now)

    def _give_back(self) -> None:
        """After the monitor's DO, put the program that stopped before it back in its place."""
        if self.stopped is None:
            return
        self.robot.finished = self.finished
        self.robot.restore(self.stopped)
        rest(self.robot, self.finished)
        self.stopped = None
        note_progress(self.robot, self.ended_s)

    def abort(self, c: Context) -> None:
        """End a program from outside."""
        c.step_was_cut = c.phase == CUT_SHORT
        self.end(c, Ending.ABORTED, None)

    def _look_for_loops(self, now: float) -> None:
        if self.closed and self.robot.running:
            finding = self.watcher.look(self, now)
            if finding is not None:
                self.end(self.robot, Ending.LIMIT, finding)
