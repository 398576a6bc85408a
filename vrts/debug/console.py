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
from vrts.ir.commands import Answer, Command, SetLocal, SetVariable
from vrts.ir.module import Module
from vrts.ir.values import Type, Value, type_of_value
from vrts.lang.names import key
from vrts.lang.typed.commands import read_command
from vrts.monitor import words
from vrts.monitor.desk import Desk, Situation
from vrts.monitor.folder import WorkingFolder
from vrts.monitor.listings import value_text
from vrts.monitor.monitor import Monitor
from vrts.report.because import chain_lines
from vrts.why.asking import Unknown, why_at, why_of

_ASSIGNED = re.compile(
    r"\s*(?P<name>[$#]?[A-Za-z][\w.]*)\s*(?:\[(?P<index>[^\]=]{1,60})\])?\s*=\s*(?P<value>[^=].*)"
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
                name, index = assigned["name"], assigned["index"]
                shown = self.give(f"{name}[{index}]" if index else name, assigned["value"], frame)
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
        """Give a variable the value of an expression; return the value as it is shown.

        A location may be given as it is shown: six numbers.

        Raises:
            CannotTell: The expression has no value, or one of another kind than the variable, or
                the variable is one of a program that has called another.
        """
        debugger = self._debugger
        frame = frame or next(iter(frames(debugger.run, debugger.at, process=False)), None)
        base, _, inside = name.replace(" ", "").rstrip("]").partition("[")
        base = key(base)
        subscripts = tuple(self._whole(p, frame) for p in inside.split(",")) if inside else ()
        value = self.value(_as_location(base, text), frame)
        _fits(base, value)
        known: Mapping[str, Value] = debugger.state.variables
        command: Command = SetVariable(base, subscripts, value)
        if frame is not None and base in frame.declared(debugger.run):
            if not frame.innermost:
                raise CannotTell(f"`{name}` can be changed once `{frame.cause.program}` goes on")
            known = frame.locals(debugger.run, debugger.at)
            command = SetLocal(base, subscripts, value, frame.process)
        before = known.get(_cell(base, subscripts))
        if before is not None and type_of_value(before) is not type_of_value(value):
            raise CannotTell(f"`{name}` holds a value of another kind")
        refused = debugger.change([command])
        if refused:
            raise CannotTell(refused[0])
        return value_text(value)

    def _whole(self, text: str, frame: Frame | None) -> int:
        value = self.value(text, frame)
        if not isinstance(value, float) or not 0.0 <= value <= 32767.0:
            raise CannotTell("an index is from 0 to 32767")
        return round(value)

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


def _cell(name: str, subscripts: tuple[int, ...]) -> str:
    return f"{name}[{','.join(map(str, subscripts))}]" if subscripts else name


def _is_command(line: str, debugger: Debugger) -> bool:
    command, found = read_command(SourceFile("console", line), debugger.dialect)
    return command is not None or not any(_unknown(d) for d in found)


def _unknown(found: Diagnostic) -> bool:
    return found.rule.slug in ("unknown-command", "invalid-command")


def _refused(said: Sequence[str]) -> str:
    return "".join(f"{words.starred(text)}" for text in said)
