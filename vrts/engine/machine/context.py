"""What compiled instructions and expressions work on: the plain state of the machine.

A `Context` is one program in execution, the robot program or the process control program. Both
share the `System`: memory, arm, hand, signals, terminal.
"""

import math
from enum import IntEnum
from typing import TYPE_CHECKING, NamedTuple

from vrts.engine.faults import RuntimeFault
from vrts.engine.machine.reactions import Watch
from vrts.engine.memory.cells import Bound, Cell, Memory, copy_bound
from vrts.engine.memory.event_log import EventLog
from vrts.engine.memory.events import Cause, Found
from vrts.engine.memory.log import Log
from vrts.engine.memory.records import Ending
from vrts.engine.memory.trace import Activation, Trace
from vrts.ir.instructions import HandAction

if TYPE_CHECKING:
    from vrts.base.diagnostic import Diagnostic
    from vrts.engine.code.executable import Executable
    from vrts.engine.hand.hand import Hand
    from vrts.engine.machine.signals import Signals
    from vrts.engine.machine.terminal import Terminal
    from vrts.engine.motion.planner import Planner


class FrameKind(IntEnum):
    """Why a program was called."""

    CALL = 0
    REACTION = 1
    ERROR = 2


class Interrupted(NamedTuple):
    """What a step that waits had come to when a reaction interrupted it."""

    phase: int
    until: float
    operands: object
    fault: RuntimeFault | None
    priority: int


class Frame:
    """One activation of a program."""

    __slots__ = (
        "cases",
        "increments",
        "index",
        "interrupted",
        "kind",
        "limits",
        "program",
        "slots",
    )

    def __init__(self, program: int, slots: list[Bound], loops: int, cases: int) -> None:
        """Start at the first instruction."""
        self.program = program  # number of the executable program
        self.index = 0  # next instruction
        self.slots = slots
        self.limits: list[float | None] = [None] * loops
        self.increments: list[float] = [0.0] * loops
        self.cases: list[float | str] = [0.0] * cases
        self.kind = FrameKind.CALL
        self.interrupted: Interrupted | None = None  # of the frame below

    def copy(self, copies: dict[int, Bound]) -> "Frame":
        """Return an independent frame over copied cells."""
        other = Frame(self.program, [copy_bound(slot, copies) for slot in self.slots], 0, 0)
        other.index = self.index
        other.limits = self.limits.copy()
        other.increments = self.increments.copy()
        other.cases = self.cases.copy()
        other.kind, other.interrupted = self.kind, self.interrupted
        return other


class System:
    """What both programs share, apart from the parts that have files of their own."""

    __slots__ = (
        "analog",
        "answers",
        "answers_read",
        "clock_reads",
        "events",
        "executable",
        "hand",
        "held_base",
        "held_tool",
        "memory",
        "parameters",
        "planner",
        "powered",
        "process",
        "random_state",
        "robot",
        "scheduled",
        "signals",
        "switches",
        "terminal",
        "timers",
        "tracing",
        "warned",
    )

    robot: "Context"
    process: "Context"

    def __init__(
        self,
        executable: "Executable",
        memory: Memory,
        planner: "Planner",
        hand: "Hand",
        signals: "Signals",
        terminal: "Terminal",
        seed: int,
    ) -> None:
        """Start at time 0."""
        self.executable = executable
        self.memory = memory
        self.planner = planner
        self.hand = hand
        self.signals = signals
        self.terminal = terminal
        self.events = EventLog()
        self.timers: dict[int, float] = {}  # time at which a timer stood at zero [s]
        self.random_state = seed & 0xFFFFFFFF
        self.switches: dict[str, bool] = {}  # those that differ from the start
        self.parameters: dict[str, Cell] = {}  # "HAND.TIME", "NEST.POS[1]"
        self.analog: dict[int, float] = {}  # outputs [counts]
        self.scheduled: list[tuple[float, int, bool]] = []  # signals that PULSE and DLYSIG set
        self.answers: Log[str] = Log()  # lines for PROMPT
        self.answers_read = 0
        self.clock_reads = 0  # of TIMER and the like: loops that read them may end
        self.held_tool = Cell("TOOL")
        self.held_base = Cell("BASE")
        self.powered = True
        self.tracing = False  # the switch TRACE, for speed
        self.warned: frozenset[str] = frozenset()

    def copy(self, copies: dict[int, Bound]) -> "System":
        """Return an independent system that shares the past, still without its programs."""
        other = System(
            self.executable,
            self.memory.copy(copies),
            self.planner.copy(),
            self.hand.copy(),
            self.signals.copy(),
            self.terminal.copy(),
            self.random_state,
        )
        other.events = self.events.copy()
        other.timers = self.timers.copy()
        other.switches = self.switches.copy()
        other.parameters = {name: cell.copy() for name, cell in self.parameters.items()}
        other.analog = self.analog.copy()
        other.scheduled = self.scheduled.copy()
        other.answers, other.answers_read = self.answers.copy(), self.answers_read
        other.clock_reads = self.clock_reads
        other.held_tool, other.held_base = self.held_tool.copy(), self.held_base.copy()
        other.powered, other.tracing, other.warned = self.powered, self.tracing, self.warned
        return other

    def cells(self) -> list[Cell]:
        """Return the cells that are no variables of programs."""
        return [self.held_tool, self.held_base, *self.parameters.values()]

    def set_parameter(self, name: str, value: float, finished: int) -> None:
        """Set a parameter of the controller."""
        cell = self.parameters.get(name)
        if cell is None:
            cell = self.parameters[name] = Cell(name)
        cell.assign(value, finished)

    def is_on(self, switch: str) -> bool:
        """Return whether a system switch is on."""
        from vrts.ir.system import SWITCHES

        return self.switches.get(switch, SWITCHES[switch].on)


STOPPED = (
    "frames",
    "activation",
    "phase",
    "until",
    "operands",
    "fault",
    "priority",
    "watches",
    "reactions_wait",
    "error_program",
    "last_error",
    "program",
    "cycles_left",
    "cycles_done",
    "kept_cycles",
    "ending",
    "started_s",
    "step_was_cut",
)  # attributes of a Context that belong to the program it executes


class Stopped(NamedTuple):
    """A program that stopped and may go on, while another is executed in its place."""

    values: dict[str, object]

    def copy(self, copies: dict[int, Bound]) -> "Stopped":
        """Return an independent copy over copied cells."""
        values = dict(self.values)
        frames: list[Frame] = [frame.copy(copies) for frame in values["frames"]]  # type: ignore[attr-defined]
        values["frames"] = frames
        values["watches"] = [watch.copy() for watch in values["watches"]]  # type: ignore[attr-defined]
        values["activation"] = _activations(values["activation"], frames)  # type: ignore[arg-type]
        return Stopped(values)


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
        "program",
        "reactions_wait",
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
        other = Context(system, is_robot=self.is_robot)
        for name in (
            "now",
            "finished",
            "phase",
            "until",
            "operands",
            "fault",
            "wake",
            "priority",
            "reactions_wait",
            "error_program",
            "last_error",
            "listed",
            "program",
            "cycles_left",
            "cycles_done",
            "kept_cycles",
            "ending",
            "started_s",
            "step_was_cut",
            "steps_left",
            "finishing",
            "last_step",
            "at_once",
        ):
            setattr(other, name, getattr(self, name))
        other.trace = self.trace.copy()
        other.next_hand = self.next_hand.copy()
        other.watches = [watch.copy() for watch in self.watches]
        other.frames = [frame.copy(copies) for frame in self.frames]
        other.slots = other.frames[-1].slots if other.frames else []
        other.activation = _activations(self.activation, other.frames)
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
            program = self.system.executable.programs[caller.program]
            at = caller.index - (frame.kind is FrameKind.CALL)  # a call is done, a wait is not
            called_from = program.base + min(max(at, 0), len(program.causes) - 1)
        self.frames.append(frame)
        self.slots = frame.slots
        self.activation = Activation(frame.program, frame.slots, called_from, self.activation)
        self.trace.activate(self.finished, self.activation)

    def stop(self) -> "Stopped":
        """Return all that going on needs, and forget it."""
        kept = Stopped({name: getattr(self, name) for name in STOPPED})
        self.frames, self.watches = [], []
        return kept

    def restore(self, kept: "Stopped") -> None:
        """Be again where a stopped program was."""
        for name, value in kept.values.items():
            setattr(self, name, value)
        self.slots = self.frames[-1].slots if self.frames else []
        self.trace.activate(self.finished, self.activation)

    def leave(self) -> Frame:
        """End the innermost program, which is not the first; what it interrupted goes on."""
        frame = self.frames.pop()
        self.slots = self.frames[-1].slots
        assert self.activation is not None
        self.activation = self.activation.caller
        self.trace.activate(self.finished, self.activation)
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
        self.trace.activate(self.finished, None)

    def wait_for_change(self) -> None:
        """Be looked at again whenever something has changed."""
        self.wake = math.inf

    def report(self, diagnostic: "Diagnostic", cause: Cause | None) -> None:
        """Note a finding on the way."""
        self.events.append(Found(self.now, diagnostic, cause))


def _activations(old: Activation | None, frames: list[Frame]) -> Activation | None:
    """Return the activations of copied frames."""
    chain: list[Activation] = []
    while old is not None:
        chain.append(old)
        old = old.caller
    found: Activation | None = None
    for activation, frame in zip(reversed(chain), frames, strict=True):
        found = activation._replace(slots=frame.slots, caller=found)
    return found
