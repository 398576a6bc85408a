"""The operator's dialogue at any instant of a run: commands of the monitor, and expressions."""

import re
from collections.abc import Mapping, Sequence
from pathlib import Path

from vrts.base.diagnostic import Diagnostic
from vrts.base.source import SourceFile
from vrts.check.rules.hints import Hints, without_remedy
from vrts.debug.debugger import Debugger
from vrts.debug.evaluating import CannotTell, evaluate, worked_out
from vrts.debug.frames import Frame, frames
from vrts.debug.giving import Target, command_for, given, target_of
from vrts.engine.memory.cells import Bound
from vrts.ir.commands import Answer, Command, SetLocal
from vrts.ir.module import Module
from vrts.ir.values import Type, Value, type_of_value
from vrts.lang.typed.commands import read_command
from vrts.monitor import words
from vrts.monitor.desk import Desk, Situation
from vrts.monitor.folder import WorkingFolder
from vrts.monitor.listings import value_text
from vrts.monitor.monitor import Monitor
from vrts.report.because import chain_lines
from vrts.why.asking import Unknown, why_at, why_of

_ASSIGNED = re.compile(
    r"\s*(?P<name>[$#]?[A-Za-z][\w.]*\s*(\[[^\]=]{1,60}\]|\([^)=]{1,60}\))?)\s*=\s*(?P<value>[^=].*)"
)
_WHY = re.compile(r"\s*why(?:\s+(?P<of>[$#]?[A-Za-z][\w.]*\s*(?:\[[-\d, ]+\])?))?\s*", re.I)
NO_HINTS = "the task allows no hints"
_NUMBER = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)")


class Console:
    """Reads lines; what they change is another future of the run."""

    def __init__(
        self,
        debugger: Debugger,
        folder: Path,
        sources: Sequence[SourceFile],
        hints: Hints = Hints.EDIT,
    ) -> None:
        """Take a debugger, the folder of files, the sources in memory, and what may be told."""
        self._hints = hints
        self._debugger = debugger
        desk = Desk(WorkingFolder(folder), debugger.dialect, asks=False, replace=True)
        self._monitor = Monitor(desk)
        for source in sources:
            self._monitor.load(source, self._now)

    def take_over(self, other: "Console") -> None:
        """Read lines with the programs that another console has in memory."""
        self._monitor = other._monitor

    @property
    def reads_on(self) -> bool:
        """Whether the next line belongs to a command that asks for more: EDIT, POINT."""
        return not self._monitor.at_commands

    def enter(self, line: str, frame: Frame | None = None) -> str:
        """Take a line; return what there is to show.

        While the program waits for a line of the terminal, the line is that. Otherwise it is an
        expression, a value given to a variable (`x = 5`), or a command of the monitor.

        Args:
            line: What was typed.
            frame: Whose arguments and automatic variables there are; None: those of the innermost
                program of the robot.
        """
        debugger = self._debugger
        if self._monitor.at_commands:
            if debugger.asks:
                return _refused(debugger.change([Answer(line)]))
            assigned = _ASSIGNED.fullmatch(line)
            if assigned is not None:
                shown = self.give(assigned["name"], assigned["value"], frame)
                return f"{shown}\n"
            asked = _WHY.fullmatch(line)
            if asked is not None and "why" not in debugger.state.variables:
                return f"{self.why(asked['of'])}\n"
            try:
                value = self.value(line, frame)
            except CannotTell as problem:
                if not _is_command(line, debugger):
                    return f"{problem}\n"
            else:
                return f"{value_text(value)}\n"
        turn = self._monitor.enter(line, self._now)
        text = turn.text
        if turn.commands:
            text += _refused(debugger.change(turn.commands))
        return text

    def why(self, name: str | None = None) -> str:
        """Return why the arm does what it does, or a variable or a thing is what it is.

        Only what happened, and by which step: it compares nothing with what would be right.
        """
        debugger = self._debugger
        if self._hints is Hints.NOTHING:
            return NO_HINTS
        at = debugger.at
        try:
            if name:
                chain = why_of(debugger.run, name, at.time_s, at.finished)
            else:
                chain = why_at(debugger.run, at.time_s)
        except Unknown as problem:
            return str(problem)
        return "\n".join([chain.effect, *(f"  {each}" for each in chain_lines(chain, Hints.PLACE))])

    def allowed(self, found: Diagnostic) -> Diagnostic:
        """Return what may be told of what went wrong: no remedy where the task allows no hints."""
        return without_remedy(found) if self._hints is Hints.NOTHING else found

    def value(self, text: str, frame: Frame | None = None) -> Value:
        """Return the value of an expression; `frame` as for `enter`.

        Raises:
            CannotTell: It has none.
        """
        debugger = self._debugger
        seen = None if frame is None else frame.seen(debugger.run, debugger.at)
        return evaluate(debugger.run, debugger.at, text, debugger.dialect, seen)

    def give(self, name: str, text: str, frame: Frame | None = None) -> str:
        """Give a variable or a signal the value of an expression; return what it has then.

        A location may be given as it is shown: six numbers. A signal may be `on` or `off`.

        Raises:
            CannotTell: The expression has no value, or the name stands for nothing that can be
                given it, or the controller refuses it. Nothing has changed then.
        """
        debugger = self._debugger
        frame = frame or next(iter(frames(debugger.run, debugger.at, process=False)), None)

        def reads(part: str) -> Value:
            return self.value(part, frame)

        target = target_of(name, reads)
        value = given(_as_location(target.name, text), target, reads)
        state = debugger.state
        command: Command
        if frame is not None and target.name in frame.declared(debugger.run):
            if not frame.innermost:
                raise CannotTell(f"`{name}` can be changed once `{frame.cause.program}` goes on")
            before = frame.locals(debugger.run, debugger.at).get(target.shown)
            if before is not None and type_of_value(before) is not type_of_value(value):
                raise CannotTell(f"`{name}` holds a value of another kind")
            command = SetLocal(target.name, target.subscripts, value, frame.process)
        else:
            command = command_for(target, value, state, self._bound(target.name), debugger.dialect)
        if target.name:
            _fits(target.name, value)
        with debugger.whole():
            refused = debugger.change([command])
            if refused:
                raise CannotTell(refused[0])
            now = self._now_of(target, frame)
            wanted = value if not target.signal else -1.0 if value else 0.0
            if now is None or now != wanted:
                raise CannotTell(f"the controller does not let `{target.shown}` be changed")
        return value_text(now)

    def _bound(self, name: str) -> Bound | None:
        """Return what a name stands for, if a program or a value knows it."""
        run = self._debugger.run
        return next((item for item in run.history.memory.bound if item.name == name), None)

    def _now_of(self, target: Target, frame: Frame | None) -> Value | None:
        """Return what the controller has now, after a change."""
        debugger = self._debugger
        state = debugger.state
        if target.speed:
            return state.monitor_speed
        if target.signal:
            on = (abs(target.signal) in state.signals) is (target.signal > 0)
            return -1.0 if on else 0.0
        if frame is not None and target.name in frame.declared(debugger.run):
            inside = frames(debugger.run, debugger.at, process=frame.process)
            return inside[0].locals(debugger.run, debugger.at).get(target.shown)
        return state.variables.get(target.shown)

    @property
    def _now(self) -> Situation:
        debugger = self._debugger
        state = debugger.state
        return Situation(state, self._calculate, state.robot, debugger.asks)

    def _calculate(self, module: Module) -> Mapping[str, Value] | str:
        debugger = self._debugger
        return worked_out(debugger.run, debugger.at, module, debugger.state.locals)


def _as_location(name: str, text: str) -> str:
    """Return six numbers, as locations are shown, as an expression; any other text as it is."""
    numbers = text.replace(",", " ").split()
    if len(numbers) != 6 or not all(_NUMBER.fullmatch(number) for number in numbers):
        return text
    return f"{'#PPOINT' if name.startswith('#') else 'TRANS'}({','.join(numbers)})"


def _fits(name: str, value: Value) -> None:
    wanted = {"$": Type.STRING, "#": Type.JOINTS}.get(name[0])
    kind = type_of_value(value)
    if wanted is not None and kind is not wanted:
        raise CannotTell(f"`{name}` cannot hold such a value")
    if wanted is None and kind in (Type.STRING, Type.JOINTS):
        raise CannotTell(f"`{name}` cannot hold such a value")


def _is_command(line: str, debugger: Debugger) -> bool:
    command, found = read_command(SourceFile("console", line), debugger.dialect)
    return command is not None or not any(_unknown(d) for d in found)


def _unknown(found: Diagnostic) -> bool:
    return found.rule.slug in ("unknown-command", "invalid-command")


def _refused(said: Sequence[str]) -> str:
    return "".join(f"{words.starred(text)}" for text in said)
