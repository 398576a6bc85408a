"""What the commands share: the debugger, whose steps are gone, and what each of them did."""

import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import NamedTuple, TypeAlias, TypeVar

from vrts.debug.console import Console
from vrts.debug.debugger import Debugger
from vrts.debug.evaluating import CannotTell
from vrts.debug.events.asking import Answer
from vrts.debug.files import LOCKED
from vrts.debug.frames import Frame, frames
from vrts.debug.history.listed import Listed
from vrts.debug.scripted.places import Place, source_of
from vrts.ir.values import Value
from vrts.monitor.listings import value_text

T = TypeVar("T")

_ASSIGNED = re.compile(r"\s*[$#]?[A-Za-z][\w.]*\s*(?:\[[^\]]*\])?\s*=\s*[^=].*")
_NOTHING = re.compile(r"`[^`\n]*` has no value")  # how an operand is refused


class Refusal(Exception):  # noqa: N818 -- names the situation
    """A command is not carried out; the text says why."""


class Row(NamedTuple):
    """Something that happened."""

    time_s: float
    kind: str
    text: str


@dataclass(slots=True)
class Done:
    """What a command did."""

    command: str
    place: Place | None = None  # where it stands afterwards
    ok: bool = True
    moved: bool = False  # whether it was to go somewhere
    said: list[str] = field(default_factory=list[str])
    value: Value | None = None
    reasons: list[str] = field(default_factory=list[str])
    table: Answer | None = None  # rows of events or calls
    log: list[Row] = field(default_factory=list[Row])
    goes: list[int | None] = field(default_factory=list[int | None])  # beside `said`: to `go` to

    def tell(self, lines: Sequence[Listed]) -> None:
        """Say lines, some of which one can go to."""
        self.said = [line.text for line in lines]
        self.goes = [line.go for line in lines]


@dataclass(slots=True)
class Session:
    """What the commands act on."""

    debugger: Debugger
    console: Console  # reads what is no command of the table
    restart: Callable[[], str] | None = None  # with the files as they are now; says what of it
    writes: bool = False  # whether commands of the monitor may change files
    write: Callable[[Path, bytes], None] | None = None  # a file, whole or not at all; may fail
    process: bool = False  # whose steps are gone
    last_id: int = 0

    def new_id(self) -> int:
        """Return a number for a breakpoint or a watch."""
        self.last_id += 1
        return self.last_id

    def frame(self) -> Frame | None:
        """Return the program whose arguments are looked at; None: the robot's innermost."""
        if not self.process:
            return None
        return next(iter(frames(self.debugger.run, self.debugger.at, process=True)), None)

    def place(self, text: str) -> tuple[str, int]:
        """Return the source and the line that `12` or `other.v2:12` means.

        Raises:
            Refusal: There is no such source, or it is no line.
        """
        file, _, number = text.rpartition(":")
        if not number.strip().isdecimal() or len(number) > 7:
            raise Refusal(
                f"`{text}` is no line: a number, or `other.v2:12`" if text else "which line?"
            )
        if not file:
            source = source_of(self.debugger, process=self.process)
            if source is None:
                raise Refusal("nothing was executed")
            return source.name, int(number)
        names = {p.span.source.name for p in self.debugger.run.history.code.programs}
        found = [name for name in names if name == file or name.endswith(f"/{file}")]
        if len(found) != 1:
            raise Refusal(f"no source is called `{file}`")
        return found[0], int(number)

    def enter(self, line: str, done: Done) -> None:
        """Hand a line to the console: an expression, a value given, a command of the monitor.

        Raises:
            Refusal: It would change files, and may not; or nobody understands it.
            CannotTell: What it gives has no value.
        """
        console, frame, failed = self.console, self.frame(), ""
        if not console.reads_on and not self.debugger.asks and not _ASSIGNED.fullmatch(line):
            try:
                done.value = console.value(line, frame)
            except CannotTell as problem:
                failed = str(problem).strip()
            else:
                done.said.append(value_text(done.value))
                return
        folder = console.folder
        folder.locked, folder.refused = not self.writes, False
        try:
            text = console.enter(line, frame)
        finally:
            folder.locked = False
        if folder.refused:
            raise Refusal(LOCKED)
        answer = text.strip()
        if answer and (answer == failed or answer.startswith("*") or _NOTHING.fullmatch(answer)):
            raise Refusal(text.rstrip())
        done.said += text.rstrip("\n").split("\n") if text.strip() else []


Deed: TypeAlias = Callable[[Session, str, Done], None]


def one_of(word: str, known: dict[str, T], command: str) -> T:
    """Return what a word stands for, or refuse."""
    if word.lower() in known:
        return known[word.lower()]
    words = ", ".join(f"`{each}`" for each in known if each)
    raise Refusal(f"`{command}` takes one of {words}, not `{word}`")


def nothing(rest: str, command: str) -> None:
    """Refuse what stands behind a command that takes nothing."""
    if rest:
        raise Refusal(f"`{command}` takes nothing behind it")


def is_assigned(line: str) -> bool:
    """Return whether a line gives a variable a value: `step = 5` is no step."""
    return _ASSIGNED.fullmatch(line) is not None
