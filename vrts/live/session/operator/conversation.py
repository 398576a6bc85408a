"""The monitor of a session: lines of several users in, text out; time is passed by others.

Unlike `monitor.Dialogue` it never lets time pass: a command takes effect at the tick that follows,
and what the terminal shows of it comes with the news of that tick.
"""

from collections.abc import Mapping, Sequence
from typing import NamedTuple

from vrts.base.source import SourceFile
from vrts.engine.controller import advance
from vrts.engine.memory.events import CommandRefused, Event, Found, ProgramStarted
from vrts.engine.memory.records import ProgramState, ProgramStatus
from vrts.ir.commands import Answer, Command, Do, Kill, Panic, TimedCommand
from vrts.ir.module import Module
from vrts.ir.values import Value
from vrts.live.session.growing.growing_run import GrowingRun
from vrts.live.session.operator.folders import Folders
from vrts.monitor import words
from vrts.monitor.desk import ALONE, Desk, Situation, Turn
from vrts.monitor.folder import CannotUse
from vrts.monitor.monitor import Monitor
from vrts.monitor.programs import StoredProgram
from vrts.monitor.teller import Standing, Teller


class Talked(NamedTuple):
    """All that a conversation knows between two commands, as plain values of the engine."""

    asks: bool
    owner: str
    robot: ProgramState | None
    killed: bool
    standing: tuple[object, ...]  # of the teller
    programs: tuple[tuple[object, ...], ...]  # in memory, in order
    last: tuple[object, ...]  # what was executed, edited and done last


class Conversation:
    """Who types, what the monitor knows, and what is shown."""

    def __init__(self, growing: GrowingRun, desk: Desk, folders: Folders) -> None:
        """Begin at the dot."""
        self.growing = growing
        self.monitor = Monitor(desk)
        self.asks = False  # a PROMPT waits for a line
        self._folders = folders
        self._owner = ""
        self._question = ""  # that a part of the monitor asks
        self._teller = Teller()
        self._robot: ProgramState | None = None  # that was last, DO aside
        self._killed = False

    def put_away(self) -> Talked | None:
        """Return all that is known; None: the monitor is in the middle of something."""
        if not self.monitor.at_commands:
            return None
        desk = self.monitor.desk
        last = (desk.last_executed, desk.last_process, desk.last_edited, desk.last_do)
        programs = tuple(map(tuple, desk.programs.values()))
        standing = tuple(self._teller.standing)
        return Talked(self.asks, self._owner, self._robot, self._killed, standing, programs, last)

    def take_back(self, talked: Talked) -> None:
        """Know what another one has known."""
        desk = self.monitor.desk
        self.asks, self._owner, self._robot, self._killed = talked[:4]
        self._teller.stand(Standing(*talked.standing))  # type: ignore[arg-type]
        for fields in talked.programs:
            program = StoredProgram(*fields)  # type: ignore[arg-type]
            desk.programs[program.name] = program
        desk.last_executed, desk.last_process, desk.last_edited, desk.last_do = talked.last  # type: ignore[assignment]
        if self._owner:
            desk.folder = self._folders.of(self._owner)

    @property
    def prompt(self) -> str:
        """What stands before the line that is typed next."""
        if self.monitor.at_commands:
            return "" if self.asks else "*" if self.growing.executing else "."
        return self._question

    @property
    def situation(self) -> Situation:
        """The controller as commands see it now."""
        state = self.growing.run.at(self.growing.time_s)
        robot = state.robot
        if robot is None or robot.program != ALONE:
            self._robot = robot
        if robot is not None and self.growing.executing:
            running = self.growing.machine.robot.program
            shown = robot._replace(program=running, status=ProgramStatus.RUNNING)
        else:
            shown = None if self._killed else self._robot
        return Situation(state, self._calculate, shown, state.awaits_answer)

    # --- in -----------------------------------------------------------------------------------

    def enter(self, line: str, owner: str) -> str:
        """Take a line of a user; return what the terminal shows at once."""
        left = self._hand_over(owner)
        echo = f"{self.prompt}{line}\n"
        self._teller.typed()
        return left + echo + self._carried_out(self.monitor.enter(line, self.situation))

    def interrupt(self, owner: str) -> str:
        """Take Ctrl-C of a user."""
        left = self._hand_over(owner)
        self._teller.typed()
        return left + self._carried_out(self.monitor.interrupt(self.situation))

    def upload(self, name: str, text: str, owner: str) -> tuple[str, str]:
        """Put a file into the user's folder and load it.

        Returns:
            What the terminal shows, and why it was refused, if it was.
        """
        left = self._hand_over(owner)
        try:
            self.monitor.desk.folder.write(name, text.encode(), replace=True)
        except CannotUse as problem:
            return left, problem.reason
        shown = self._teller.words(f"{name} uploaded\n")
        turn = self.monitor.load(SourceFile(name, text), self.situation)
        return left + shown + self._carried_out(turn), ""

    def issue(self, command: Command) -> None:
        """Give a command that nobody typed."""
        if isinstance(command, Do):
            self.situation  # noqa: B018 -- remembers the program that the instruction displaces
        self.growing.issue(command)

    # --- out ----------------------------------------------------------------------------------

    def told(self, events: Sequence[Event]) -> str:
        """Return what the terminal shows of what has happened."""
        if any(isinstance(event, ProgramStarted) and not event.process for event in events):
            self._killed = False
        return self._teller.told(events)

    # --- parts --------------------------------------------------------------------------------

    def _hand_over(self, owner: str) -> str:
        """Let another user type: a question or the editor of the one before is left."""
        if owner == self._owner:
            return ""
        self._owner = owner
        self.monitor.desk.folder = self._folders.of(owner)
        if self.monitor.at_commands:
            return ""
        return self._carried_out(self.monitor.interrupt(self.situation))

    def _carried_out(self, turn: Turn) -> str:
        if turn.mode is not None:
            self._question = turn.mode.prompt
        shown = self._teller.words(turn.text)
        for command in turn.commands:
            if isinstance(command, Answer):
                self._teller.answered(command.text)
            self._killed = self._killed or isinstance(command, Kill)
        self.growing.issue(*turn.commands)
        return shown

    def _calculate(self, module: Module) -> Mapping[str, Value] | str:
        """Execute a module of one step on a fork of the run; return its variables, or why not."""
        run = self.growing.run
        at = run.until_s
        commands = [TimedCommand(at, Do(module))]
        if self.growing.executing:  # which excludes DO, so the fork stops it first
            commands.insert(0, TimedCommand(at, Panic()))
        until = at + 2 * run.scene.robot.arm.tick
        fork = advance(run, until, commands)
        for event in fork.events[len(run.events) :]:
            if isinstance(event, CommandRefused):
                return words.starred(event.words)
            if isinstance(event, Found) and event.diagnostic.is_error:
                return words.refusal(event.diagnostic, help_too=False)
        return fork.at(until).variables
