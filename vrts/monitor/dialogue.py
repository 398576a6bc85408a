"""A monitor over a controller, in simulated time: lines in, everything the terminal shows out."""

from collections.abc import Mapping, Sequence

from vrts.base.source import SourceFile
from vrts.engine.controller import Controller, advance, truncate
from vrts.engine.events import CommandRefused, Event, Found
from vrts.engine.records import ProgramState
from vrts.engine.run import State
from vrts.ir.commands import Command, Do, Panic, TimedCommand
from vrts.ir.module import Module
from vrts.ir.values import Value
from vrts.monitor import words
from vrts.monitor.desk import ALONE, Situation, Turn, executes
from vrts.monitor.monitor import Monitor
from vrts.monitor.teller import Teller

REST = 20.0  # [s] longest time an arm takes to come to rest [assumed]
_LATE = 100  # events among the last ones before which another may still come to stand
TICK = 0.028  # [s] after which a command has taken effect


class Dialogue:
    """What terminal, browser and emulated controller drive."""

    def __init__(self, controller: Controller, monitor: Monitor) -> None:
        """Go on from where the controller is."""
        self.controller = controller
        self.monitor = monitor
        self._told: Sequence[Event] = ()  # events of the run that have been shown
        self._teller = Teller()
        self._robot: ProgramState | None = None  # that was last, DO aside

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
        return executes(self.state.robot) and not self.state.awaits_answer

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
        if self.busy or self.state.robot is not None:
            self.controller.advance_until_stopped(most_s)
            self.controller.advance(self.time_s + 0.5 * TICK)  # what comes next comes after it all
        return self._news()

    def truncate(self, time_s: float) -> None:
        """Go back to an earlier time; what was typed since is forgotten by the controller."""
        run = self.controller.truncate(time_s)
        self._told = run.events

    @property
    def _now(self) -> Situation:
        """Return the controller as commands see it."""
        state = self.state
        robot = state.robot
        if robot is None or robot.program != ALONE:
            self._robot = robot
        return Situation(state, self._calculate, robot if executes(robot) else self._robot)

    # --- what the terminal shows ----------------------------------------------------------------

    def _carry_out(self, turn: Turn) -> str:
        shown = self._teller.words(turn.text)
        for command in turn.commands:
            self.controller.issue(command, self.time_s)
        if turn.commands:
            self.controller.advance(self.time_s + TICK)
        return shown + self._news()

    def _news(self) -> str:
        """Return what the events that have not been shown yet write."""
        events = self.controller.run.events
        first = max(0, len(self._told) - _LATE)
        known = set(map(id, self._told[first:]))
        new = [event for event in events[first:] if id(event) not in known]
        self._told = events
        return self._teller.told(new)

    # --- expressions ----------------------------------------------------------------------------

    def _calculate(self, module: Module) -> Mapping[str, Value] | str:
        """Execute a module of one step on a fork of the run; return its variables, or why not."""
        run = self.controller.run
        at = run.until_s
        commands = [TimedCommand(at, Do(module))]
        if executes(run.at(at).robot):  # which excludes DO, so the fork stops it first
            commands = [TimedCommand(at, Panic()), TimedCommand(at + REST, Do(module))]
        until = commands[-1].time_s + 2 * TICK
        fork = advance(truncate(run, at), until, commands)  # truncated: with a past of its own
        for event in fork.events[len(run.events) :]:
            if isinstance(event, CommandRefused):
                return words.starred(event.words)
            if isinstance(event, Found) and event.diagnostic.is_error:
                return words.refusal(event.diagnostic, help_too=False)
        return fork.at(until).variables
