"""What expressions read, as it was at an instant: it stands in for a program in execution.

The engine's closures take their values from cells, signals and the arm of a context. Here is one
whose cells hold what the histories of a run say.
"""

from bisect import bisect_right
from collections.abc import Callable, Mapping
from functools import cached_property

from vrts.base.pose import IDENTITY, Pose
from vrts.base.source import Span
from vrts.controllers.model import ControllerModel
from vrts.debug.conditions.tracks import Tracks
from vrts.engine.memory.cells import UNDEFINED, Array, Bound, Cell, Memory
from vrts.engine.memory.facts import Aim, Executed, Facts
from vrts.engine.memory.records import Ending
from vrts.engine.memory.track import Track, Value
from vrts.engine.motion.settings import InForce, Settings, Speed
from vrts.engine.programs.signals import known
from vrts.engine.run import Run
from vrts.ir.instructions import SpeedUnit
from vrts.ir.system import SWITCHES
from vrts.robots.kinematics.choice import Request
from vrts.robots.model import Arm, ArmBranch, Configuration, Gripper


class Past:
    """A program in execution, as far as expressions look at it."""

    def __init__(self, run: Run, tracks: Callable[[], Tracks]) -> None:
        """Begin at the first instant, without variables."""
        self._run, self._tracks = run, tracks
        self.now, self.finished, self.asks_process = 0.0, 0, False
        self.slots: list[Bound] = []
        self.memory = _Variables(self)
        self.signals = _Signals(self)
        self.system = _System(self)
        self.planner = _Arm(self)
        self.hand = _Hand(self)
        self.robot, self.process = _Program(self, robot=True), _Program(self, robot=False)

    def stand(self, now: float, finished: int, memory: Memory, *, process: bool) -> None:
        """Go to an instant, with variables of its own, as one of the two programs."""
        self.now, self.finished, self.asks_process = now, finished, process
        self.memory.bound = memory.bound
        self.system.forget()

    @cached_property
    def facts(self) -> Facts | None:
        """What was noted of the machine; None where nothing was."""
        return self._run.machine.system.facts

    @property
    def tracks(self) -> Tracks:
        """All changes of signals and switches."""
        return self._tracks()

    @property
    def run(self) -> Run:
        """Whose past it is."""
        return self._run

    def state_of(self, name: int | str) -> bool | None:
        """Return the state of a signal or switch; None where it is as at first."""
        return self._tracks().at(name, self.now, self.finished)

    def was(self, track: Track[Value], before: Value) -> Value:
        """Return what was noted last, or what was so before anything was noted."""
        found = track.at(self.now, self.finished)
        return before if found is None else found

    @property
    def told(self) -> Facts:
        """What was noted of the machine, which is so where this is asked."""
        assert self.facts is not None
        return self.facts

    @property
    def _asking(self) -> "_Program":
        return self.process if self.asks_process else self.robot

    @property
    def priority(self) -> int:
        """The priority of the program that asks."""
        return self._asking.told.priority

    @property
    def last_error(self) -> "_Error | None":
        """The last run-time error of the program that asks."""
        number = self._asking.told.error
        return _Error(number) if number else None


class _Error:
    """A run-time error."""

    def __init__(self, number: int) -> None:
        self.number = number


class _Variables:
    """Variables of an expression, and how many the controller counts."""

    def __init__(self, past: Past) -> None:
        self._past = past
        self.bound: list[Bound] = []

    def cells(self) -> list[Cell]:
        """Return those of the expression."""
        return Memory(self.bound).cells()

    @property
    def size(self) -> int:
        """How many cells the controller has."""
        past = self._past
        arrays = [b for b in past.run.history.memory.bound if isinstance(b, Array)]
        made = sum(bisect_right(array.made, past.finished) for array in arrays)
        return past.was(past.told.sizes, 0) + made


class _Program:
    """One of the two programs in execution."""

    ending = Ending.RUNNING
    phase = True  # `wake` tells whether it is blocked

    def __init__(self, past: Past, *, robot: bool) -> None:
        self._past, self._is_robot = past, robot

    @property
    def told(self) -> Executed:
        """What it tells of itself."""
        facts = self._past.told
        return self._past.was(facts.robot if self._is_robot else facts.process, Executed())

    @property
    def program(self) -> str:
        """Which one was run last."""
        return self.told.program

    @property
    def running(self) -> bool:
        """Whether it runs."""
        return self.told.running

    @property
    def frames(self) -> tuple[Executed, ...]:
        """Where it may go on: nowhere, or in one program."""
        return (self.told,) if self.told.kept else ()

    @property
    def wake(self) -> float:
        """Until when it is blocked amid a step [s]; 0 where it is not, or asks itself."""
        past, facts = self._past, self._past.told
        itself = past.asks_process is not self._is_robot
        if itself:
            return 0.0
        wakes = facts.robot_wakes if self._is_robot else facts.process_wakes
        # the robot program has its turn before the other one asks
        k = wakes.count(past.now, past.finished + self._is_robot)
        history = past.run.history
        trace = (history.robot if self._is_robot else history.process).trace
        if not k or trace.executed(past.finished) != trace.executed(wakes.numbers[k - 1] - 1):
            return 0.0
        return wakes.values[k - 1]


class _Signals:
    """Signals: whether each is on."""

    def __init__(self, past: Past) -> None:
        self._past = past

    @property
    def on(self) -> "_Signals":
        return self

    def __contains__(self, number: int) -> bool:
        return self._past.state_of(number) or False

    def holds(self, number: int, span: Span | None) -> bool:
        """Return what `Signals.holds` of the engine does."""
        if number == 0:
            return True
        known(number, span)
        return (abs(number) in self) is (number > 0)

    def count(self, channel: int) -> float:
        """Return what an analog input reads [counts]."""
        analog = self._past.run.scenario.analog
        return next((v for t, c, v in reversed(analog) if c == channel and t <= self._past.now), 0)


class _Timers:
    """The times at which timers stood at zero [s]."""

    def __init__(self, past: Past) -> None:
        self._past = past

    def get(self, number: int, otherwise: float) -> float:
        """Return that of a timer, if it was set."""
        track = self._past.told.timers.get(number)
        return otherwise if track is None else self._past.was(track, otherwise)


class _System:
    """Switches, parameters, programs, timers, chance."""

    clock_reads = 0  # nobody counts how often somebody looks
    outside = facts = None

    def __init__(self, past: Past) -> None:
        self._past = past
        self.timers = _Timers(past)
        self._state: int | None = None
        self._draws: tuple[float, ...] | None = None

    def forget(self) -> None:
        """Begin to draw anew."""
        self._state = self._draws = None

    @property
    def random_state(self) -> int:
        """The state of chance."""
        past = self._past
        if self._state is None:
            self._state = past.was(past.told.drawn, past.run.scenario.seed & 0xFFFFFFFF)
        return self._state

    @random_state.setter
    def random_state(self, state: int) -> None:
        self._state = state

    @property
    def draws(self) -> tuple[float, ...]:
        """What is drawn before the seed decides."""
        past = self._past
        if self._draws is None:
            every = past.run.scenario.draws
            self._draws = every[len(every) - past.was(past.told.left, len(every)) :]
        return self._draws

    @draws.setter
    def draws(self, draws: tuple[float, ...]) -> None:
        self._draws = draws

    @property
    def programs(self) -> "_Numbers":
        """The programs in memory."""
        return _Numbers(self._past.was(self._past.told.programs, {}))

    def parameter(self, name: str, otherwise: float) -> float:
        """Return what `System.parameter` of the engine does."""
        cell = self._past.run.history.memory.parameters.get(name)
        held = UNDEFINED if cell is None else cell.at(self._past.finished)
        return held if isinstance(held, float) else otherwise

    def is_on(self, switch: str) -> bool:
        """Return whether a switch is on."""
        state = self._past.state_of(switch)
        if state is None:
            first = SWITCHES.get(switch)
            return first is not None and first.on
        return state


class _Numbers:
    """Numbers of programs by name."""

    def __init__(self, numbers: Mapping[str, int]) -> None:
        self.numbers = numbers


class _Scale:
    """The monitor speed."""

    def __init__(self, rate: float) -> None:
        self.rate = rate


class _Arm:
    """Where the arm is and is to go, and what was set for its motions."""

    def __init__(self, past: Past) -> None:
        self._past = past

    @cached_property
    def arm(self) -> Arm:
        """The arm as its controller counts."""
        return self._past.run.scene.robot.arm

    @property
    def model(self) -> ControllerModel:
        """How its controller is taken to work."""
        return self._past.run.scene.controller

    @property
    def base(self) -> Pose:
        """What BASE has set."""
        held = self._past.run.history.memory.base.at(self._past.finished)
        return held if isinstance(held, Pose) else IDENTITY

    @property
    def tool(self) -> Pose:
        """What TOOL has set."""
        held = self._past.run.history.memory.tool.at(self._past.finished)
        return held if isinstance(held, Pose) else self._past.run.scene.X_FT

    @property
    def _aim(self) -> Aim:
        aim = self._past.told.aims.at(self._past.now, self._past.finished)
        assert aim is not None  # one is noted at the beginning
        return aim

    @property
    def dest(self) -> Configuration:
        """Where the last motion goes [rad]."""
        return self._aim.dest

    @property
    def destination(self) -> Pose:
        """DEST."""
        return self.base @ self._aim.X_BT

    @property
    def configuration(self) -> Configuration:
        """From where the next motion starts [rad]."""
        return self._aim.configuration

    @property
    def branch(self) -> ArmBranch:
        """On which arm branch that is."""
        return self._aim.branch

    @property
    def request(self) -> Request:
        """Which branch is asked for."""
        return self._aim.request

    @property
    def motion_end(self) -> float:
        """When the path of the last motion ends [s]."""
        return self._past.was(self._past.told.ends, 0.0)

    @property
    def braking_until(self) -> float:
        """When a stop under way is complete [s]."""
        return self._past.was(self._past.told.stops, 0.0)

    @property
    def scale(self) -> _Scale:
        """The monitor speed."""
        return _Scale(self._past.was(self._past.told.rates, 1.0))

    @property
    def settings(self) -> InForce:
        """Speeds, and what joints 4 and 6 may."""
        past, facts, found = self._past, self._past.told, InForce()
        speed = Speed(past.was(facts.speeds, 100.0), SpeedUnit.PERCENT)
        found.always = Settings(speed=speed, multiple=past.was(facts.turns, before=True))
        following = past.was(facts.next_speeds, 100.0)
        found.next = {"speed": Speed(following, SpeedUnit.PERCENT)}
        return found

    def configuration_at(self, time_s: float) -> Configuration:
        """Return the positions of the joints [rad]."""
        return self._past.run.timeline.configuration(time_s)


class _Hand:
    """The hand."""

    def __init__(self, past: Past) -> None:
        self._past = past

    @property
    def gripper(self) -> Gripper:
        """What it can."""
        return self._past.run.scene.robot.gripper

    def opening(self, time_s: float) -> float:
        """Return the opening [m]."""
        return self._past.run.timeline.opening(time_s)
