"""What compiled instructions and expressions work on: the plain state of the machine."""

from typing import TYPE_CHECKING

from vrts.engine.cells import Bound, Memory, copy_bound

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
        "frames",
        "hand",
        "hand_time",
        "memory",
        "now",
        "phase",
        "planner",
        "random_state",
        "signals",
        "slots",
        "terminal",
        "timers",
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
        self.wake = 0.0  # [s] a blocked instruction need not be looked at before
        self.timers: dict[int, float] = {}  # time at which a timer stood at zero [s]
        self.random_state = seed & 0xFFFFFFFF
