"""What both programs share: memory, arm, hand, signals, terminal, settings of the controller."""

from collections.abc import Callable

from vrts.engine.hand.hand import Hand
from vrts.engine.memory.cells import Bound, Cell, Memory
from vrts.engine.memory.event_log import EventLog
from vrts.engine.memory.facts import Facts
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
        self.facts: Facts | None = Facts()  # None: nobody will ask what they were
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
        # of a machine that shares what does not change with others (`futures.quiet`): parts them
        self.parts: Callable[[], None] | None = None

    def copy(self, copies: dict[int, Bound]) -> "System":
        """Return an independent system that shares the past, still without its programs."""
        other = self.half_copied(copies)
        other.own()
        return other

    def half_copied(self, copies: dict[int, Bound]) -> "System":
        """Return a system that shares what programs seldom change, until it has its `own`."""
        other = System.__new__(System)
        other.__dict__.update(self.__dict__)
        other.memory = self.memory.copy(copies)
        other.signals, other.terminal = self.signals.copy(), self.terminal.copy()
        other.events = self.events.copy()
        other.facts = None if self.facts is None else self.facts.copy()
        other.outside = None if self.outside is None else self.outside.copy()
        return other

    def own(self) -> None:
        """Have an arm, a hand and settings of its own."""
        self.parts = None
        self.planner, self.hand = self.planner.copy(), self.hand.copy()
        self.timers = self.timers.copy()
        self.switches = self.switches.copy()
        self.parameters = {name: cell.copy() for name, cell in self.parameters.items()}
        self.analog = self.analog.copy()
        self.scheduled = self.scheduled.copy()
        self.answers = self.answers.copy()
        self.held_tool, self.held_base = self.held_tool.copy(), self.held_base.copy()

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
