"""A monitor over a controller, in simulated time: lines in, everything the terminal shows out."""

from collections.abc import Mapping

from vrts.base.source import SourceFile
from vrts.engine.controller import Controller, advance
from vrts.engine.events import CommandRefused, Found, Printed
from vrts.engine.run import State
from vrts.ir.commands import Command, Do, Panic, TimedCommand
from vrts.ir.module import Module
from vrts.ir.values import Value
from vrts.monitor import words
from vrts.monitor.desk import Turn, executes
from vrts.monitor.monitor import Monitor, told

REST = 20.0  # [s] longest time an arm takes to come to rest [assumed]
TICK = 0.028  # [s] after which a command has taken effect


class Dialogue:
    """What terminal, browser and emulated controller drive."""

    def __init__(self, controller: Controller, monitor: Monitor) -> None:
        """Go on from where the controller is."""
        self.controller = controller
        self.monitor = monitor
        self._told = 0  # events of the run that have been shown
        self._at_start = True  # of a line of the terminal

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
        return self.monitor.prompt(self.state)

    @property
    def busy(self) -> bool:
        """Whether a robot program executes and waits for no answer."""
        state = self.state
        return executes(state.robot) and not state.awaits_answer

    def enter(self, line: str) -> str:
        """Take a line; return what the terminal shows until its commands have taken effect."""
        self._at_start = True  # RETURN was typed
        return self._carry_out(self.monitor.enter(line, self.state, self._calculate))

    def interrupt(self) -> str:
        """Take Ctrl-C."""
        self._at_start = True
        return self._carry_out(self.monitor.interrupt(self.state, self._calculate))

    def issue(self, command: Command) -> str:
        """Give a command that was not typed; return what the terminal shows."""
        return self._carry_out(Turn(commands=(command,)))

    def load(self, source: SourceFile) -> str:
        """Take what a file holds into memory."""
        return self._carry_out(self.monitor.load(source, self.state, self._calculate))

    def advance(self, until_s: float) -> str:
        """Let time pass; return what the terminal shows meanwhile."""
        self.controller.advance(max(until_s, self.time_s))
        return self._news()

    def settle(self, most_s: float) -> str:
        """Let time pass until the program has stopped or asks something, but not longer."""
        self.controller.advance_until_stopped(most_s)
        return self._news()

    def truncate(self, time_s: float) -> None:
        """Go back to an earlier time; what was typed since is forgotten by the controller."""
        run = self.controller.truncate(time_s)
        self._told = len(run.events)

    # --- what the terminal shows ----------------------------------------------------------------

    def _carry_out(self, turn: Turn) -> str:
        shown = self._on_a_line(turn.text)
        for command in turn.commands:
            self.controller.issue(command, self.time_s)
        if turn.commands:
            self.controller.advance(self.time_s + TICK)
        return shown + self._news()

    def _news(self) -> str:
        """Return what the events that have not been shown yet write."""
        events = self.controller.run.events
        new, self._told = events[self._told :], len(events)
        shown: list[str] = []
        for event in new:
            text = told(event)
            shown.append(self._after(text) if isinstance(event, Printed) else self._on_a_line(text))
        return "".join(shown)

    def _on_a_line(self, text: str) -> str:
        """Return words of the monitor: they begin on a line of their own."""
        return self._after(text if self._at_start or not text else f"\n{text}")

    def _after(self, text: str) -> str:
        if text:
            self._at_start = text.endswith("\n")
        return text

    # --- expressions ----------------------------------------------------------------------------

    def _calculate(self, module: Module) -> Mapping[str, Value] | str:
        """Execute a module of one step on a fork of the run; return its variables, or words."""
        run = self.controller.run
        at = run.until_s
        commands = [TimedCommand(at, Do(module))]
        if executes(run.at(at).robot):  # which excludes DO, so the fork stops it first
            commands = [TimedCommand(at, Panic()), TimedCommand(at + REST, Do(module))]
        until = commands[-1].time_s + 2 * TICK
        fork = advance(run, until, commands)
        for event in fork.events[len(run.events) :]:
            if isinstance(event, CommandRefused):
                return event.words
            if isinstance(event, Found) and event.diagnostic.is_error:
                return words.val_words(event.diagnostic) or event.diagnostic.headline
        return fork.at(until).variables
