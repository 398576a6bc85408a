"""All state of the controller's machine: two programs, an arm and a hand, at a tick.

`tick` lets it go on; the other modules of this room are parts of a tick.
"""

import math
from array import array
from bisect import bisect_right

from vrts.engine.code.executable import Executable
from vrts.engine.hand.hand import Hand
from vrts.engine.machine.sensing import Sensing
from vrts.engine.machine.watcher import Watcher
from vrts.engine.memory.cells import Bound, Cell, cells_of
from vrts.engine.memory.records import INSTANT
from vrts.engine.motion.planner import Planner
from vrts.engine.programs.context import Context
from vrts.engine.programs.signals import Signals
from vrts.engine.programs.stopped import Stopped
from vrts.engine.programs.system import System
from vrts.engine.programs.terminal import Terminal
from vrts.ir.commands import TimedCommand
from vrts.scene.model import Scenario, Scene


class Lineage:
    """Which version of a machine wrote last to the histories that versions share."""

    __slots__ = ("writes",)

    def __init__(self) -> None:
        """Start with nothing written."""
        self.writes = 0


class MidTick:
    """How far a tick has come: whose turn it is, and how much of the share is left.

    A statement that looks at something undecided has not begun; the tick then goes on from here.
    """

    __slots__ = ("changes", "finished", "process_first", "steps", "turn")

    def __init__(self, finished: int, changes: int, *, process_first: bool = False) -> None:
        """Stand before both programs.

        Args:
            finished: Statements finished before the tick.
            changes: How often signals had changed before the programs' turns.
            process_first: Whether the process control program has its turn before the robot
                program in this tick: usually it comes second.
        """
        self.finished = finished
        self.changes = changes
        self.process_first: bool | None = process_first  # None: that is not decided yet
        self.turn = 0  # of the programs; after the last one the tick is over
        self.steps: int | None = None  # left of the share; None: reactions come first

    def again(self) -> None:
        """Let both programs have another turn."""
        self.turn, self.steps = 0, None

    def copy(self) -> "MidTick":
        """Return an independent copy."""
        other = MidTick(self.finished, self.changes)
        other.process_first = self.process_first
        other.turn, other.steps = self.turn, self.steps
        return other


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
            Planner(arm, configuration, scene.X_FT, rate, scene.controller),
            Hand(scene, scenario.hand_opening),
            Signals(scenario.inputs, scenario.analog),
            Terminal(),
            scenario.seed,
        )
        self.initial_opening = scenario.hand_opening
        self.robot = Context(self.system, is_robot=True)
        self.process = Context(self.system, is_robot=False)
        self.wire()
        for name, value in scenario.parameters.items():
            self.system.set_parameter(name.upper(), value, 0)
        self.system.locks, self.system.draws = scenario.locks, scenario.draws
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
        self.turns_done = 0  # of the scenario's: see `MidTick.process_first`
        self.stopped: Stopped | None = None  # the program that stopped before a DO
        self.mid: MidTick | None = None  # a tick is under way
        self.watcher = Watcher()
        self.lineage = Lineage()
        self.written = 0
        self._tell()

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
        if self.mid is not None:
            other.mid = self.mid.copy()
        if self.stopped is not None:
            other.stopped = self.stopped.copy(copies)
        other.wire()
        return other

    def wire(self) -> None:
        """Let the parts know each other."""
        for c in (self.robot, self.process):
            c.robot, c.process = self.robot, self.process
        self.system.hand.planner = self.system.planner
        self.system.events.counted = self.counted
        facts = self.system.planner.facts = self.system.facts
        if facts is not None:
            facts.now = self.moment

    def counted(self) -> int:
        """Return how many statements are finished, the one under way included."""
        return max(self.finished, self.robot.finished, self.process.finished)

    def moment(self) -> tuple[float, int]:
        """Return the time of the tick under way [s], and `counted`."""
        robot, number = self.robot, self.finished
        if robot.finished > number:
            number = robot.finished
        other = self.process.finished
        return robot.now, other if other > number else number

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
        if self.system.facts is not None:
            self.system.facts.cut(self.now)

    def _tell(self) -> None:
        """Note what is so at the beginning."""
        self.system.planner.tell()
        self.system.planner.tell_settings()
        self.tell_memory()

    def tell_memory(self) -> None:
        """Note which programs and names are in memory."""
        facts = self.system.facts
        if facts is not None:
            facts.programs.turn(*self.moment(), self.system.programs.numbers)
            scalars = sum(isinstance(bound, Cell) for bound in self.system.memory.bound)
            facts.sizes.turn(*self.moment(), scalars)

    def take_over(self, executable: Executable) -> None:
        """Have other programs in memory from now on."""
        self.executable = executable
        self.system.programs = executable.programs
        self.tell_memory()

    # --- time -----------------------------------------------------------------------------------

    @property
    def now(self) -> float:
        """Time of the last tick that was run [s]."""
        return max(self.last_tick, 0) * self.tick

    def tick_of(self, time_s: float) -> int:
        """Return the number of the first tick that is not before a time [s]."""
        return math.ceil(time_s / self.tick - INSTANT / self.tick)

    @property
    def running(self) -> bool:
        """Whether a program executes."""
        return self.robot.running or self.process.running

    # --- commands -------------------------------------------------------------------------------

    def issue(self, commands: tuple[TimedCommand, ...]) -> None:
        """Add commands, at times from now on, to those still to come."""
        self.know((*self.issued, *commands))

    def know(self, issued: tuple[TimedCommand, ...]) -> None:
        """Take these for all commands ever issued; those obeyed are among them."""
        self.issued = tuple(sorted(issued, key=lambda c: c.order))
        coming = self.next_command_s
        if coming is not None:  # a tick that was to be skipped may be needed now
            self.next_tick = min(self.next_tick, max(self.tick_of(coming), self.last_tick + 1))

    @property
    def next_command_s(self) -> float | None:
        """When the next command is to be obeyed [s]; None when there is none."""
        return self.issued[self.obeyed].time_s if self.obeyed < len(self.issued) else None

    @property
    def due_after(self) -> int | None:
        """Statements after which the next command of this tick is to be obeyed."""
        if self.obeyed >= len(self.issued):
            return None
        timed = self.issued[self.obeyed]
        return timed.after if timed.time_s <= self.now + INSTANT else None


def in_turn(machine: Machine) -> tuple[Context, Context]:
    """Return both programs in the order of their turns in the tick under way."""
    mid = machine.mid
    if mid is not None and mid.process_first:
        return machine.process, machine.robot
    return machine.robot, machine.process


def program_under_way(machine: Machine) -> Context:
    """Return the program whose turn it is in the tick under way; else the robot program."""
    mid = machine.mid
    return machine.robot if mid is None else in_turn(machine)[min(mid.turn, 1)]


def statement_under_way(machine: Machine) -> tuple[int, int] | None:
    """Return whose turn it is in the tick under way, and how many statements are finished."""
    return None if machine.mid is None else (machine.mid.turn, machine.finished)
