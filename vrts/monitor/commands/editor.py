"""EDIT: the line editor. It shows a step, asks for the step, and goes on.

See [manual language/editor].
"""

import re
from typing import NamedTuple

from vrts.base.pose import IDENTITY
from vrts.engine.memory.records import ProgramStatus
from vrts.ir.commands import Command, SetVariable
from vrts.ir.values import Type
from vrts.lang.names import key
from vrts.lang.syntax.expressions import Application
from vrts.lang.typed.commands import CommandLine
from vrts.lang.typed.entry import check_step
from vrts.monitor import words
from vrts.monitor.commands.files import problems_of
from vrts.monitor.commands.teaching import successor
from vrts.monitor.commands.values import fits, present
from vrts.monitor.desk import (
    Desk,
    Mode,
    Refused,
    Situation,
    Turn,
    cell,
    is_name,
    program_name,
    whole,
)
from vrts.monitor.programs import StoredProgram, canonical, listed

MAX_STEPS = 65_000  # as in files
MAX_CHARACTERS = 255  # of a step

_COMMAND = re.compile(
    r"""(?!\w[\w.]*(?:\[[^\]]*\])?[ ]*=)  # an assignment to `i` or `p1` is a step
    (?P<letter>TS|[CDEFILMPRST])(?=$|[ \d])[ ]?(?P<rest>.*)""",
    re.IGNORECASE | re.VERBOSE,
)
_COUNT = re.compile(r"[ ]*(\d{1,5})?[ ]*")
_NAMED = re.compile(r"[ ]*([A-Za-z][\w.]*)[ ]*(?:,[ ]*(\d{1,5}))?[ ]*", re.ASCII)
_PROMPT = 7  # columns of the prompt
_CODE = 15  # column at which a listing shows an instruction


class Editing(NamedTuple):
    """Waits for a step, or for a letter that is a command of the editor."""

    program: StoredProgram
    step: int  # from 1; one beyond the last is a new one
    inserting: bool = False
    mark: str = "."  # behind the number of a step; AS has none

    @property
    def prompt(self) -> str:
        """Return the number of the step asked for."""
        return f"{self.step:5d}{self.mark}{'I' if self.inserting else '?'}"

    def enter(self, line: str, desk: Desk, now: Situation) -> Turn:
        """Take a step, or carry out a command of the editor."""
        if self.inserting:
            return self._insert(line, desk)
        if not line.strip():
            return self._go(min(self.step + 1, self._last + 1), desk)
        match = _COMMAND.match(line.lstrip(" "))
        if match is None:
            return self._replace_step(line, desk)
        return self._command(match["letter"].upper(), match["rest"], line, desk, now)

    def interrupt(self, desk: Desk, now: Situation) -> Turn:
        """Leave the editor, as E does."""
        return self._leave(desk, now)

    # --- steps ----------------------------------------------------------------------------------

    @property
    def _last(self) -> int:
        return len(self.program.lines)

    def shown(self, desk: Desk) -> str:
        """Return the present step as a listing has it; nothing behind the last."""
        return listed(self.program, desk.dialect, [self.step])

    def _go(self, step: int, desk: Desk) -> Turn:
        mode = self._replace(step=step, inserting=False)
        return Turn(mode.shown(desk), mode=mode)

    def _with(self, lines: tuple[str, ...]) -> "Editing":
        program = self.program._replace(lines=lines, modified=True)
        bad = frozenset(n for n in program.bad if n <= len(lines) and n != self.step)
        return self._replace(program=program._replace(bad=bad))

    def _checked(self, text: str, desk: Desk) -> str | None:
        """Return why a step is rejected, or None."""
        if len(text) > MAX_CHARACTERS:
            return words.starred(words.NO_ROOM, "a step has at most 255 characters")
        if not desk.has_room(self.program, text):
            return words.starred(words.NO_ROOM, "memory is full")
        found = check_step(text, desk.dialect, frozenset(desk.programs))
        return words.first_refusal(found)

    def _replace_step(self, text: str, desk: Desk) -> Turn:
        wrong = self._checked(text, desk)
        if wrong is not None:
            return Turn(wrong, mode=self)
        if self.step > MAX_STEPS:
            return Turn(words.starred(words.NO_ROOM), mode=self)
        at = self.step - 1
        lines = (*self.program.lines[:at], text.rstrip(), *self.program.lines[at + 1 :])
        return self._with(lines)._go(self.step + 1, desk)

    def _insert(self, line: str, desk: Desk) -> Turn:
        if line == "":
            return self._go(self.step, desk)
        wrong = self._checked(line, desk)
        if wrong is not None:
            return Turn(wrong, mode=self)
        return Turn(mode=self.inserted(line.rstrip()))

    def inserted(self, text: str) -> "Editing":
        """Return the editor behind a new step, put before the present one."""
        at = self.step - 1
        lines = (*self.program.lines[:at], text, *self.program.lines[at:])
        moved = frozenset(n + 1 if n >= self.step else n for n in self.program.bad)
        program = self.program._replace(lines=lines, modified=True, bad=moved)
        return self._replace(program=program, step=self.step + 1)

    # --- commands -------------------------------------------------------------------------------

    def _command(self, letter: str, rest: str, line: str, desk: Desk, now: Situation) -> Turn:
        match letter:
            case "E" | "I" | "L" if rest.strip():
                return self._refuse(f"{letter} stands alone")
            case "E":
                return self._leave(desk, now)
            case "I":
                return Turn(mode=self._replace(inserting=True))
            case "L":
                return self._go(max(self.step - 1, 1), desk)
            case "C":
                return self._another(rest, desk, now)
            case "D" | "P" | "S":
                return self._counted(letter, rest, desk)
            case "F":
                return self._find(rest, desk)
            case "M":
                return self._exchange(rest, desk)
            case "R":
                return self._overwrite(rest, line, desk)
            case _:
                return self._teach(letter, rest, desk, now)

    def _refuse(self, reason: str, said: str = words.UNEXPECTED_TEXT) -> Turn:
        return Turn(words.starred(said, reason), mode=self)

    def _counted(self, letter: str, rest: str, desk: Desk) -> Turn:
        match = _COUNT.fullmatch(rest)
        if match is None:
            return self._refuse(f"a number follows {letter}")
        count = int(match[1] or 1)
        if letter == "S":
            return self._go(min(max(count, 1), self._last + 1), desk)
        if count == 0:
            return Turn(mode=self)
        if letter == "D":
            at = self.step - 1
            bad = frozenset(
                n if n < self.step else n - count
                for n in self.program.bad
                if not self.step <= n < self.step + count
            )
            lines = (*self.program.lines[:at], *self.program.lines[at + count :])
            program = self.program._replace(lines=lines, modified=True, bad=bad)
            return self._replace(program=program)._go(self.step, desk)
        last = min(self.step + count - 1, self._last)
        shown = listed(self.program, desk.dialect, range(self.step, last + 1))
        return Turn(shown, mode=self._replace(step=max(last, 1)))

    def _find(self, text: str, desk: Desk) -> Turn:
        wanted = text.upper()
        rows = canonical(self.program, desk.dialect)
        for number in range(self.step, self._last + 1):
            if wanted and wanted in rows[number - 1].upper():
                return self._go(number, desk)
        return Turn(f"there is no `{text}` from here on\n", mode=self)

    def _exchange(self, rest: str, desk: Desk) -> Turn:
        """M /old/new: any sign may stand for the slash."""
        mark = rest[:1]
        old, found, new = rest[1:].partition(mark) if mark else ("", "", "")
        if not found or not old:
            return self._refuse("write `M /old/new`")
        code = self._row(desk)
        at = code.upper().find(old.upper())
        if at < 0:
            return Turn(f"there is no `{old}` in this step\n", mode=self)
        return self._rewritten(code[:at] + new + code[at + len(old) :], desk)

    def _overwrite(self, text: str, line: str, desk: Desk) -> Turn:
        """R text: the characters of the step from the column in which the R stands."""
        code = self._row(desk)
        column = len(line) - len(line.lstrip(" ")) + _PROMPT - _CODE
        at = min(max(column, 0), len(code))
        return self._rewritten(code[:at] + text + code[at + len(text) :], desk)

    def _row(self, desk: Desk) -> str:
        """Return the present step as shown, from the column of instructions on."""
        return self.shown(desk)[_CODE:].rstrip("\n") if self.step <= self._last else ""

    def _rewritten(self, code: str, desk: Desk) -> Turn:
        """Put a changed instruction in place, with the label that it had."""
        wrong = self._checked(code, desk)
        if wrong is not None:
            return Turn(wrong, mode=self)
        label = self.shown(desk)[_CODE - 7 : _CODE].strip() if self.step <= self._last else ""
        at = self.step - 1
        text = f"{label} {code.strip()}".strip()
        lines = (*self.program.lines[:at], text, *self.program.lines[at + 1 :])
        return self._with(lines)._go(self.step, desk)

    def _teach(self, letter: str, rest: str, desk: Desk, now: Situation) -> Turn:
        word = "MOVES" if letter == "TS" else "MOVE"
        name = rest.strip() or "pos0"
        match = re.fullmatch(r"([#]?[A-Za-z][\w.]*)(?:\[(\d{1,5})\])?", name, re.ASCII)
        if match is None or not is_name(match[1]):
            return self._refuse("write `T location`", words.INVALID_NAME)
        indices = (int(match[2]),) if match[2] else ()
        return Turn(mode=TeachingSteps(self, word, key(match[1]), indices))

    # --- leaving --------------------------------------------------------------------------------

    def _another(self, rest: str, desk: Desk, now: Situation) -> Turn:
        match = _NAMED.fullmatch(rest)
        if match is None:
            return self._refuse("write `C program, step`", words.INVALID_NAME)
        left = self._leave(desk, now)
        try:
            following = edit(key(match[1]), int(match[2] or 1), desk, now)
        except Refused as refused:
            return Turn(left.text + refused.text, left.commands)
        return Turn(left.text + following.text, left.commands, following.mode)

    def _leave(self, desk: Desk, now: Situation) -> Turn:
        name = self.program.name
        desk.last_edited = (name, self.step)
        known = desk.programs.get(name)
        if not self.program.lines and known is None:
            return Turn()  # nothing was typed
        if known is not None and not self.program.modified and known.lines == self.program.lines:
            return Turn("".join(problems_of(known, desk)))
        installed = desk.install(self.program, now)
        problems = "".join(problems_of(desk.programs[name], desk))
        return Turn(problems + installed.text, installed.commands)


class TeachingSteps(NamedTuple):
    """T and TS: each RECORD inserts a motion to the recorded location."""

    editing: Editing
    word: str
    name: str
    indices: tuple[int, ...]

    @property
    def prompt(self) -> str:
        """Return the step that RECORD would make."""
        return f"{self.editing.step:5d}.  {self.word} {cell(self.name, self.indices)}: "

    def enter(self, line: str, desk: Desk, now: Situation) -> Turn:
        """Record, or go back to the editor."""
        if not line.strip():
            return Turn(self.editing.shown(desk), mode=self.editing)
        if line.strip().upper() != "R":
            return Turn("press R to record, RETURN to end\n", mode=self)
        try:
            fits(self.name, Type.JOINTS if self.name[0] == "#" else Type.POSE, now)
        except Refused as refused:
            return Turn(refused.text, mode=self.editing)
        value = present(self.name, IDENTITY, now)
        command: Command = SetVariable(self.name, self.indices, value)
        step = f"{self.word} {cell(self.name, self.indices)}"
        editing = self.editing.inserted(step)
        shown = listed(editing.program, desk.dialect, [self.editing.step])
        following = successor(self.name, self.indices)
        if following is None:
            return Turn(shown, (command,), editing)
        mode: Mode = self._replace(editing=editing, name=following[0], indices=following[1])
        return Turn(shown, (command,), mode)

    def interrupt(self, desk: Desk, now: Situation) -> Turn:
        """Go back to the editor."""
        return Turn(mode=self.editing)


# --- EDIT -----------------------------------------------------------------------------------------


def edit_command(line: CommandLine, desk: Desk, now: Situation) -> Turn:
    """EDIT [program] [, step]: by default the program edited last, or the one that stopped."""
    first = line.operands[0] if line.operands else None
    step = None
    if len(line.operands) > 1 and line.operands[1] is not None:
        step = whole(line, line.operands[1], 1, desk, now)
    if isinstance(first, Application):  # `EDIT place(n)`: a new program with its formals
        name = key(first.name.text)
        return edit(name, step or 1, desk, now, formals=line.rest[len(first.name.text) :])
    if first is not None:
        name = program_name(first)
        known = desk.last_edited
        default = known[1] if known is not None and known[0] == name else 1
        return edit(name, default if step is None else step, desk, now)
    name, default = _last_one(desk, now)
    return edit(name, default if step is None else step, desk, now)


def edit(name: str, step: int, desk: Desk, now: Situation, *, formals: str = "") -> Turn:
    """Begin to edit a program at a step."""
    if now.occupies(name):
        raise Refused(words.starred(words.ILLEGAL_NOW, f"`{name}` is being executed"))
    program = desk.programs.get(name)
    if program is None:
        program = StoredProgram(name, f".PROGRAM {name}{_formals(formals)}", (), modified=True)
    at = min(max(step, 1), len(program.lines) + 1)
    editing = Editing(program, at, mark="" if desk.dialect.is_as else ".")
    return Turn(f"{program.header}\n{editing.shown(desk)}", mode=editing)


def _formals(written: str) -> str:
    match = re.match(r"\([\w.,$#& \[\]]*\)", written.strip(), re.ASCII)
    return match.group().lower() if match is not None else ""


def _last_one(desk: Desk, now: Situation) -> tuple[str, int]:
    robot = now.robot
    if robot is not None and robot.status is ProgramStatus.STOPPED and robot.cause is not None:
        stopped = (robot.cause.program, robot.cause.step)
        if stopped[0] in desk.programs:
            return stopped
    if desk.last_edited is None:
        raise Refused(words.starred(words.MISSING_ARGUMENT, "write `EDIT program`"))
    return desk.last_edited
