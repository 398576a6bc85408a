"""The operator's dialogue at any instant of a run: commands of the monitor, and expressions."""

import re
from collections.abc import Mapping, Sequence
from pathlib import Path

from vrts.base.diagnostic import Diagnostic
from vrts.base.source import SourceFile
from vrts.check.rules.hints import Hints, without_remedy
from vrts.debug.debugger import Debugger, Stop, Why
from vrts.debug.evaluating import CannotTell, worked_out
from vrts.debug.events.asking import TABLES
from vrts.debug.events.asking import Answer as Told
from vrts.debug.files import Files, Lockable
from vrts.debug.frames import Frame, frames
from vrts.debug.giving import Target, command_for, given, target_of
from vrts.debug.history import answers
from vrts.debug.history.listed import Listed
from vrts.debug.marks.deeds import WORDS, Marking
from vrts.debug.marks.goals import Goals
from vrts.debug.passages import Instant
from vrts.engine.memory.cells import Bound
from vrts.ir.commands import Answer, Command, SetLocal
from vrts.ir.module import Module
from vrts.ir.values import Type, Value, type_of_value
from vrts.lang.typed.commands import read_command
from vrts.monitor import words
from vrts.monitor.desk import Desk, Situation
from vrts.monitor.listings import value_text
from vrts.monitor.monitor import Monitor
from vrts.pipeline.request import Request
from vrts.report.because import chain_lines
from vrts.why.chain import Link

_ASSIGNED = re.compile(
    r"\s*(?P<name>[$#]?[A-Za-z][\w.]*\s*(\[[^\]=]{1,60}\]|\([^)=]{1,60}\))?)\s*=\s*(?P<value>[^=].*)"
)
_ASKED = re.compile(
    r"\s*(?P<word>why|who|next|go)(?:\s+(?P<of>[$#]?[A-Za-z\d][\w.]*\s*"
    r"(?:\[[-\d, ]+\]|\(\s*\d+\s*\)|\s\d+|\s+output\s+\d+)?))?\s*",
    re.I,
)
_TOLD = re.compile(rf"\s*(?P<word>{'|'.join((*TABLES, *WORDS))})(?:\s+(?P<rest>.*?))?\s*", re.I)
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
        request: Request | None = None,
        files: Files | None = None,
    ) -> None:
        """Take a debugger, the folder of files, the sources in memory, and what may be told.

        `request` says what the programs were made of, None: of a saved run; `files`, from where.
        """
        self._hints = hints
        self._debugger = debugger
        self.folder = Lockable(folder)
        self.request, self.files = request, files
        self.goals = Goals(debugger.run)
        self.marking = Marking(debugger, self.goals)
        self.show(sources)

    @property
    def hints(self) -> Hints:
        """What the task allows to be told."""
        return self._hints

    def show(self, sources: Sequence[SourceFile]) -> None:
        """Have these programs in memory, and no others."""
        desk = Desk(self.folder, self._debugger.dialect, asks=False, replace=True)
        self._monitor = Monitor(desk)
        for source in sources:
            self._monitor.load(source, self._now)

    def take_over(self, other: "Console") -> None:
        """Read lines with the programs that another console has in memory."""
        self._monitor, self._hints = other._monitor, other._hints
        self.folder = other.folder
        self.request, self.files = other.request, other.files

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
            asked = _ASKED.fullmatch(line)
            if asked is not None and self._is_question(asked["word"].lower(), asked["of"]):
                return f"{self.ask(asked['word'].lower(), asked['of'] or '', frame)}\n"
            told = _TOLD.fullmatch(line)
            if told is not None and (told["rest"] or not self._is_variable(told["word"].lower())):
                return self._told(told["word"].lower(), told["rest"] or "", frame)
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

    def ask(self, word: str, name: str, frame: Frame | None = None) -> str:
        """Return the answer to `who`, `next`, `why` or `go`, with numbers to `go` to.

        Raises:
            CannotTell: `go` leads nowhere.
        """
        if word == "go":
            return self.go(name)
        try:
            return "\n".join(line.text for line in self.listed(word, name, frame))
        except CannotTell as problem:
            return str(problem)

    def listed(self, word: str, name: str | None, frame: Frame | None = None) -> list[Listed]:
        """Return the answer to `who`, `next` or `why`, line by line.

        `why` tells only what happened, and by which step: it compares nothing with what would be
        right.

        Raises:
            CannotTell: Nothing has this name, or the task allows no hints.
        """
        if word == "why":
            effect, links = self.causes(name, frame)
            lines = [Listed(effect)]
            goes: list[Instant] = []
            for text, _, place in links:
                if place is not None:
                    goes.append(place)
                    lines.append(Listed(f"{len(goes)} {text}", len(goes)))
                else:
                    lines.append(Listed(f"- {text}"))
        else:
            lines, goes = answers.rows(self.changed(word, name or "", frame))
        stops = [Stop(instant, Why.STEP) for instant in goes]
        self.goals.show(self._debugger.run, stops)
        return lines

    def changed(
        self, word: str, name: str, frame: Frame | None = None
    ) -> list[answers.Found | str]:
        """Return the last change of a name up to here, for `who`; for `next` the next one.

        Raises:
            CannotTell: Nothing has this name.
        """
        debugger = self._debugger
        if not name:
            raise CannotTell(f"`{word}` takes a name: of a variable, a signal, a thing, HERE")
        asked = answers.who if word == "who" else answers.following
        return asked(debugger.run, name, debugger.at, frame)

    def go(self, text: str) -> str:
        """Go to a numbered row of the last answer, or to a mark; return where it stands then.

        Raises:
            CannotTell: There is no such row and no such mark.
        """
        stop = self._debugger.go_to(self.goals.stop(self._debugger.run, text))
        about = f": {stop.text}" if stop.text else ""
        return f"at {stop.instant.time_s:.3f} s{about}"

    def table(self, name: str, text: str) -> Told:
        """Return the rows of `events` or `calls` that fit a question; `go` leads to each.

        Raises:
            CannotTell: The question cannot be read.
        """
        debugger = self._debugger
        answer = debugger.tables.asked(name, text, debugger.at)
        self.goals.show(debugger.run, [row.go for row in answer.rows])
        return answer

    def causes(
        self, name: str | None = None, frame: Frame | None = None
    ) -> tuple[str, list[tuple[str, Link, Instant | None]]]:
        """Return what is asked about, and its causes: in words, as links, where to see them.

        Raises:
            CannotTell: Nothing has this name, or the task allows no hints.
        """
        debugger = self._debugger
        if self._hints is Hints.NOTHING:
            raise CannotTell(NO_HINTS)
        chain = answers.why(debugger.run, name or None, debugger.at, frame)
        lines = chain_lines(chain, Hints.PLACE)
        places = [answers.place_of(debugger.run, link) for link in chain.links]
        return chain.effect, list(zip(lines, chain.links, places, strict=True))

    def _told(self, word: str, rest: str, frame: Frame | None) -> str:
        """Return what `events`, `calls`, `marks` and their like say."""
        try:
            if word in TABLES:
                answer = self.table(word, rest)
                return "".join(
                    f"{line}\n" for line in (*(r.text for r in answer.rows), *answer.says)
                )
            process = frame is not None and frame.process
            told = self.marking.told(word, rest, process=process)
            return "".join(f"{line.text}\n" for line in told)
        except CannotTell as problem:
            return f"{problem}\n"

    def _is_variable(self, word: str) -> bool:
        return word in self._debugger.state.variables

    def _is_question(self, word: str, name: str | None) -> bool:
        """Return whether a line asks: a variable of such a name is asked for its value."""
        if name is None and self._is_variable(word):
            return False
        return word != "next" or name is None or not name.strip().isdecimal()

    def allowed(self, found: Diagnostic) -> Diagnostic:
        """Return what may be told of what went wrong: no remedy where the task allows no hints."""
        return without_remedy(found) if self._hints is Hints.NOTHING else found

    def value(self, text: str, frame: Frame | None = None) -> Value:
        """Return the value of an expression; `frame` as for `enter`.

        Raises:
            CannotTell: It has none.
        """
        debugger = self._debugger
        at, process = debugger.at, frame is not None and frame.process
        robot = debugger.run.history.robot.trace
        activation = robot.activation(at.finished) if frame is None else frame.activation
        return debugger.stops.value(text, at, activation, debugger.hear, process=process)

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
