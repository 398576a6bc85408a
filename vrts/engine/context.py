"""What compiled instructions and expressions work on: the plain state of the machine."""

from typing import TYPE_CHECKING

from vrts.engine.cells import Bound, Memory, copy_bound
from vrts.engine.events import Cause, Event
from vrts.engine.faults import RuntimeFault
from vrts.ir.instructions import HandAction

if TYPE_CHECKING:
    from vrts.engine.hand import Hand
    from vrts.engine.planner import Planner
    from vrts.engine.signals import Signals
    from vrts.engine.terminal import Terminal


class Frame:
    """One activation of a program."""

    __slots__ = ("cases", "increments", "index", "limits", "program", "slots")

    def __init__(self, program: int, slots: list[Bound], loops: int, cases: int) -> None:
        """Start at the first instruction."""
        self.program = program  # number of the executable program
        self.index = 0  # next instruction
        self.slots = slots
        self.limits: list[float | None] = [None] * loops
        self.increments: list[float] = [0.0] * loops
        self.cases: list[float | str] = [0.0] * cases

    def copy(self, copies: dict[int, Bound]) -> "Frame":
        """Return an independent frame over copied cells."""
        other = Frame(self.program, [copy_bound(slot, copies) for slot in self.slots], 0, 0)
        other.index = self.index
        other.limits = self.limits.copy()
        other.increments = self.increments.copy()
        other.cases = self.cases.copy()
        return other


class Context:
    """State that expressions read and instructions change. Everything in it is plain data."""

    __slots__ = (
        "events",
        "fault",
        "frames",
        "hand",
        "hand_time",
        "memory",
        "next_hand",
        "now",
        "phase",
        "planner",
        "random_state",
        "signals",
        "slots",
        "terminal",
        "timers",
        "until",
        "wake",
    )

    def __init__(
        self,
        memory: Memory,
        planner: "Planner",
        hand: "Hand",
        signals: "Signals",
        terminal: "Terminal",
        hand_time: float,
        seed: int,
    ) -> None:
        """Start at time 0 with nothing executing."""
        self.memory = memory
        self.planner = planner
        self.hand = hand
        self.signals = signals
        self.terminal = terminal
        self.hand_time = hand_time  # [s] wait after an immediate hand instruction
        self.now = 0.0  # time of the tick [s]
        self.frames: list[Frame] = []
        self.slots: list[Bound] = []  # of the innermost frame
        self.phase = 0  # of an instruction that takes several ticks
        self.until = 0.0  # [s] end of a wait of that instruction
        self.fault: RuntimeFault | None = None  # ends the program when the motion has ended
        self.next_hand: list[tuple[HandAction, Cause]] = []  # to begin with the next motion
        self.events: list[Event] = []
        self.wake = 0.0  # [s] a blocked instruction need not be looked at before
        self.timers: dict[int, float] = {}  # time at which a timer stood at zero [s]
        self.random_state = seed & 0xFFFFFFFF

    def copy(self) -> "Context":
        """Return an independent context that shares the past."""
        copies: dict[int, Bound] = {}
        other = Context(
            self.memory.copy(copies),
            self.planner.copy(),
            self.hand.copy(),
            self.signals.copy(),
            self.terminal.copy(),
            self.hand_time,
            self.random_state,
        )
        other.now, other.wake, other.until = self.now, self.wake, self.until
        other.phase, other.fault = self.phase, self.fault
        other.next_hand = self.next_hand.copy()
        other.events = self.events.copy()
        other.timers = self.timers.copy()
        other.frames = [frame.copy(copies) for frame in self.frames]
        other.slots = other.frames[-1].slots if other.frames else []
        return other
