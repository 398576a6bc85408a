"""What both programs share: memory, arm, hand, signals, terminal, settings of the controller."""

from vrts.engine.hand.hand import Hand
from vrts.engine.memory.cells import Bound, Cell, Memory
from vrts.engine.memory.event_log import EventLog
from vrts.engine.memory.log import Log
from vrts.engine.motion.planner import Planner
from vrts.engine.programs.loaded import Programs
from vrts.engine.programs.outside import Kind, Outside, Question, Undecided
from vrts.engine.programs.signals import Signals
from vrts.engine.programs.terminal import Terminal
from vrts.ir.system import SWITCHES
from vrts.scene.model import Locks


class System:
    """What both programs share, apart from the parts that have files of their own."""

    __slots__ = (
        "analog",
        "answers",
        "answers_read",
        "clock_reads",
        "draws",
        "events",
        "hand",
        "held_base",
        "held_tool",
        "locks",
        "memory",
        "outside",
        "parameters",
        "planner",
        "powered",
        "programs",
        "random_state",
        "scheduled",
        "signals",
        "switches",
        "terminal",
        "timers",
        "tracing",
        "warned",
    )

    def __init__(
        self,
        programs: Programs,
        memory: Memory,
        planner: Planner,
        hand: Hand,
        signals: Signals,
        terminal: Terminal,
        seed: int,
    ) -> None:
        """Start at time 0."""
        self.programs = programs
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
        self.locks = Locks()  # what programs may not set
        self.draws: tuple[float, ...] = ()  # what RANDOM draws next, before the seed decides
        self.outside: Outside | None = None  # None: what is not known is waited for

    def copy(self, copies: dict[int, Bound]) -> "System":
        """Return an independent system that shares the past, still without its programs."""
        other = System.__new__(System)
        other.programs = self.programs
        other.memory = self.memory.copy(copies)
        other.planner, other.hand = self.planner.copy(), self.hand.copy()
        other.signals, other.terminal = self.signals.copy(), self.terminal.copy()
        other.random_state = self.random_state
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
        other.locks, other.draws = self.locks, self.draws
        other.outside = None if self.outside is None else self.outside.copy()
        return other

    def next_answer(self) -> str | None:
        """Take the next line for PROMPT; None when there is none yet.

        Raises:
            Undecided: There is none, and answers are free.
        """
        if self.answers_read < len(self.answers):
            self.answers_read += 1
            return self.answers[self.answers_read - 1]
        if self.outside is not None and self.outside.answers:
            raise Undecided(Question(Kind.ANSWER))
        return None

    def cells(self) -> list[Cell]:
        """Return the cells that are no variables of programs."""
        return [self.held_tool, self.held_base, *self.parameters.values()]

    def set_parameter(self, name: str, value: float, finished: int) -> None:
        """Set a parameter of the controller."""
        cell = self.parameters.get(name)
        if cell is None:
            cell = self.parameters[name] = Cell(name)
        cell.assign(value, finished)

    def parameter(self, name: str, otherwise: float) -> float:
        """Return a parameter of the controller, or what it is at the start."""
        cell = self.parameters.get(name)
        return cell.value if cell is not None and isinstance(cell.value, float) else otherwise

    def is_on(self, switch: str) -> bool:
        """Return whether a system switch is on."""
        known = SWITCHES.get(switch)
        return self.switches.get(switch, known is not None and known.on)
