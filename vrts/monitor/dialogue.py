"""A monitor over a controller, in simulated time: lines in, everything the terminal shows out."""

from collections.abc import Mapping, Sequence

from vrts.base.source import SourceFile
from vrts.engine.controller import Controller, advance
from vrts.engine.memory.events import CommandRefused, Event, Found, ProgramStarted
from vrts.engine.memory.records import ProgramState
from vrts.engine.run import Run, State
from vrts.ir.commands import Answer, Command, Do, Kill, Panic, TimedCommand
from vrts.ir.module import Module
from vrts.ir.values import Value
from vrts.monitor import words
from vrts.monitor.desk import ALONE, Situation, Turn, executes
from vrts.monitor.monitor import Monitor
from vrts.monitor.teller import Teller

_LATE = 100  # events among the last ones before which another may still come to stand


class Dialogue:
    """What terminal, browser and emulated controller drive."""

    def __init__(self, controller: Controller, monitor: Monitor) -> None:
        """Go on from where the controller is."""
        self.controller = controller
        self.monitor = monitor
        self._told: Sequence[Event] = ()  # events of the run that have been shown
        self._teller = Teller()
        self._robot: ProgramState | None = None  # that was last, DO aside
        self._killed = False  # it was cleared
        self._known: tuple[Run, Situation] | None = None  # of the run as it is

    @property
    def time_s(self) -> float:
        """The simulated time that has been reached [s]."""
        return self.controller.run.until_s

    @property
    def state(self) -> State:
        """The controller now."""
        return self.controller.run.at(self.time_s)

    @property
    def prompt(self) -> str:
        """What stands before the line that is typed next."""
        return self.monitor.prompt(self._now)

    @property
    def busy(self) -> bool:
        """Whether a robot program executes and waits for no answer."""
        return self._now.executing and not self._now.asks

    def enter(self, line: str) -> str:
        """Take a line; return what the terminal shows until its commands have taken effect."""
        self._teller.typed()
        return self._carry_out(self.monitor.enter(line, self._now))

    def interrupt(self) -> str:
        """Take Ctrl-C."""
        self._teller.typed()
        return self._carry_out(self.monitor.interrupt(self._now))

    def issue(self, command: Command) -> str:
        """Give a command that was not typed; return what the terminal shows."""
        return self._carry_out(Turn(commands=(command,)))

    def load(self, source: SourceFile) -> str:
        """Take what a file holds into memory."""
        return self._carry_out(self.monitor.load(source, self._now))

    def advance(self, until_s: float) -> str:
        """Let time pass; return what the terminal shows meanwhile."""
        self.controller.advance(max(until_s, self.time_s))
        return self._news()

    def settle(self, most_s: float) -> str:
        """Let time pass until the program has stopped or asks something, but not longer."""
        if self.state.robot is not None:
            self.controller.advance_until_stopped(most_s)
            self.controller.advance(self.time_s + 0.5 * self._tick)  # what comes next comes after
        return self._news()

    def truncate(self, time_s: float) -> None:
        """Go back to an earlier time; what was typed since is forgotten by the controller."""
        run = self.controller.truncate(time_s)
        self._told = run.events

    @property
    def _tick(self) -> float:
        """Time after which a command has taken effect [s]."""
        return self.controller.run.scene.robot.arm.tick

    @property
    def _now(self) -> Situation:
        """Return the controller as commands see it."""
        run = self.controller.run
        if self._known is None or self._known[0] is not run:
            state = self.state
            robot = state.robot
            if robot is None or robot.program != ALONE:
                self._robot = robot
            shown = robot if executes(robot) else None if self._killed else self._robot
            asks = state.awaits_answer
            self._known = (run, Situation(state, self._calculate, shown, asks))
        return self._known[1]

    # --- what the terminal shows ----------------------------------------------------------------

    def _carry_out(self, turn: Turn) -> str:
        shown = self._teller.words(turn.text)
        for command in turn.commands:
            if isinstance(command, Answer):
                self._teller.answered(command.text)
            self._killed = self._killed or isinstance(command, Kill)
            self.controller.issue(command, self.time_s)
        if turn.commands:
            self.controller.advance(self.time_s + self._tick)
        return shown + self._news()

    def _news(self) -> str:
        """Return what the events that have not been shown yet write."""
        events = self.controller.run.events
        first = max(0, len(self._told) - _LATE)
        known = set(map(id, self._told[first:]))
        new = [event for event in events[first:] if id(event) not in known]
        self._told = events
        if any(isinstance(event, ProgramStarted) and not event.process for event in new):
            self._killed = False
        return self._teller.told(new)

    # --- expressions ----------------------------------------------------------------------------

    def _calculate(self, module: Module) -> Mapping[str, Value] | str:
        """Execute a module of one step on a fork of the run; return its variables, or why not."""
        run = self.controller.run
        at = run.until_s
        commands = [TimedCommand(at, Do(module))]
        if self._now.executing:  # which excludes DO, so the fork stops it first
            commands.insert(0, TimedCommand(at, Panic()))
        until = at + 2 * self._tick
        fork = advance(run, until, commands)
        for event in fork.events[len(run.events) :]:
            if isinstance(event, CommandRefused):
                return words.starred(event.words)
            if isinstance(event, Found) and event.diagnostic.is_error:
                return words.refusal(event.diagnostic, help_too=False)
        return fork.at(until).variables
