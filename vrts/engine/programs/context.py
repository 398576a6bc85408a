"""What compiled instructions and expressions work on: one program in execution."""

import math

from vrts.base.diagnostic import Diagnostic
from vrts.engine.faults import RuntimeFault
from vrts.engine.memory.cells import Bound
from vrts.engine.memory.events import Cause, Found
from vrts.engine.memory.records import Ending
from vrts.engine.memory.trace import Activation, Trace
from vrts.engine.programs.frames import Frame, FrameKind, Interrupted, activations_of
from vrts.engine.programs.stopped import Stopped
from vrts.engine.programs.system import System
from vrts.engine.programs.watches import Watch
from vrts.ir.instructions import HandAction


class Context:
    """One program in execution. Everything in it is plain data."""

    __slots__ = (
        "activation",
        "at_once",
        "cycles_done",
        "cycles_left",
        "ending",
        "error_program",
        "events",
        "fault",
        "finished",
        "finishing",
        "frames",
        "hand",
        "is_robot",
        "kept_cycles",
        "last_error",
        "last_step",
        "listed",
        "memory",
        "next_hand",
        "now",
        "operands",
        "phase",
        "planner",
        "priority",
        "process",
        "program",
        "reactions_wait",
        "robot",
        "signals",
        "slots",
        "started_s",
        "step_was_cut",
        "steps_left",
        "system",
        "trace",
        "until",
        "wake",
        "watches",
    )

    robot: "Context"  # of the two programs; the machine makes them known to each other
    process: "Context"

    def __init__(self, system: System, *, is_robot: bool) -> None:
        """Start with nothing executing."""
        self.is_robot = is_robot
        self.trace = Trace()
        self.attach(system)
        self.now = 0.0  # time of the tick [s]
        self.finished = 0  # statements that will be finished when the present one is
        self.frames: list[Frame] = []
        self.slots: list[Bound] = []  # of the innermost frame
        self.activation: Activation | None = None  # the same for looking back
        self.phase = 0  # of an instruction that takes several ticks
        self.until = 0.0  # [s] end of a wait of that instruction
        self.operands: object = None  # what it has evaluated already
        self.fault: RuntimeFault | None = None  # ends the program when the motion has ended
        self.next_hand: list[tuple[HandAction, Cause]] = []  # to begin with the next motion
        self.wake = 0.0  # [s] a blocked instruction need not be looked at before; inf: a condition
        self.priority = 0
        self.watches: list[Watch] = []
        self.reactions_wait = False  # some have not been taken, for their priority
        self.error_program: int | None = None  # of REACTE
        self.last_error: RuntimeFault | None = None
        self.listed: tuple[Cause, int] | None = None  # step that TRACE wrote last
        self.program = ""  # of EXECUTE or PCEXECUTE: the one run last
        self.cycles_left = 0  # the present one included; negative is endless
        self.cycles_done = 0
        self.kept_cycles: int | None = None  # that PCEND took away
        self.ending = Ending.NOT_STARTED
        self.started_s = 0.0
        self.finishing = False  # the last step is done, the arm still moves
        self.last_step: Cause | None = None  # before the end of the cycle
        self.at_once = False  # it ends although the arm still moves: the monitor's DO
        self.step_was_cut = False  # stopped at a motion that was given, and would have failed
        self.steps_left: tuple[int, int | None] | None = None  # single steps, depth for whole calls

    def after(self, ticks: int) -> float:
        """Return the time of a later tick, to the last digit as it will be `now` [s].

        Times of ticks are products; a sum may be off by a last digit, and what begins at such a
        time would begin after what is commanded when the tick has come.
        """
        tick = self.planner.arm.tick
        return (round(self.now / tick) + ticks) * tick

    def attach(self, system: System) -> None:
        """Take the parts of a system."""
        self.system = system
        self.memory = system.memory
        self.planner = system.planner
        self.hand = system.hand
        self.signals = system.signals
        self.events = system.events

    def copy(self, system: System, copies: dict[int, Bound]) -> "Context":
        """Return an independent program in a copied system."""
        other = Context.__new__(Context)
        other.is_robot = self.is_robot
        other.attach(system)
        other.now = self.now
        other.finished = self.finished
        other.phase = self.phase
        other.until = self.until
        other.operands = self.operands
        other.fault = self.fault
        other.wake = self.wake
        other.priority = self.priority
        other.reactions_wait = self.reactions_wait
        other.error_program = self.error_program
        other.last_error = self.last_error
        other.listed = self.listed
        other.program = self.program
        other.cycles_left = self.cycles_left
        other.cycles_done = self.cycles_done
        other.kept_cycles = self.kept_cycles
        other.ending = self.ending
        other.started_s = self.started_s
        other.step_was_cut = self.step_was_cut
        other.steps_left = self.steps_left
        other.finishing = self.finishing
        other.last_step = self.last_step
        other.at_once = self.at_once
        other.trace = self.trace.copy()
        other.next_hand = self.next_hand.copy()
        other.watches = [watch.copy() for watch in self.watches]
        other.frames = [frame.copy(copies) for frame in self.frames]
        other.slots = other.frames[-1].slots if other.frames else []
        other.activation = activations_of(self.activation, other.frames)
        return other

    @property
    def running(self) -> bool:
        """Whether the program executes."""
        return self.ending is Ending.RUNNING

    def enter(self, frame: Frame) -> None:
        """Begin a program; the innermost one goes on when it returns."""
        called_from = None
        if self.frames:
            caller = self.frames[-1]
            program = self.system.programs.loaded[caller.program]
            at = caller.index - (frame.kind is FrameKind.CALL)  # a call is done, a wait is not
            called_from = program.base + min(max(at, 0), len(program.causes) - 1)
        self.frames.append(frame)
        self.slots = frame.slots
        self.activation = Activation(frame.program, frame.slots, called_from, self.activation)
        self._note_innermost()

    def stop(self) -> Stopped:
        """Return all that going on needs, and forget it."""
        kept = Stopped(*[getattr(self, name) for name in Stopped._fields])
        self.frames, self.watches = [], []
        return kept

    def restore(self, kept: Stopped) -> None:
        """Be again where a stopped program was."""
        for name, value in kept._asdict().items():
            setattr(self, name, value)
        self.slots = self.frames[-1].slots if self.frames else []
        self._note_innermost()

    def leave(self) -> Frame:
        """End the innermost program, which is not the first; what it interrupted goes on."""
        frame = self.frames.pop()
        self.slots = self.frames[-1].slots
        assert self.activation is not None
        self.activation = self.activation.caller
        self._note_innermost()
        if frame.interrupted is not None:
            kept = frame.interrupted
            self.phase, self.until, self.operands = kept.phase, kept.until, kept.operands
            self.fault, self.priority = kept.fault, kept.priority
        return frame

    def interrupt(self, frame: Frame, kind: FrameKind, priority: int) -> None:
        """Begin a program between two steps, or in the middle of one that waits."""
        frame.kind = kind
        frame.interrupted = Interrupted(
            self.phase, self.until, self.operands, self.fault, self.priority
        )
        self.phase, self.operands, self.fault = 0, None, None
        self.priority = priority
        self.enter(frame)

    def clear(self) -> None:
        """Forget every program that is being executed."""
        self.frames, self.slots, self.activation = [], [], None
        self.phase, self.operands, self.fault = 0, None, None
        self._note_innermost()

    def _note_innermost(self) -> None:
        """Note the innermost program from the statement under way on, of whichever program."""
        self.trace.activate(self.events.counted(), self.activation)

    def wait_for_change(self) -> None:
        """Be looked at again whenever something has changed."""
        self.wake = math.inf

    def report(self, diagnostic: Diagnostic, cause: Cause | None) -> None:
        """Note a finding on the way."""
        self.events.append(Found(self.now, diagnostic, cause))

    def look_again(self) -> None:
        """Let programs that wait for the arm look again: it may arrive earlier than they know."""
        for program in (self.robot, self.process):
            program.wake = min(program.wake, self.now)
            if self.system.facts is not None:
                self.system.facts.looked(robot=program.is_robot)
