"""The monitor: a line goes in, text and commands for the controller come out.

Nothing here reads a terminal, a clock or the disk: files are those of the `Folder` it is given.
Terminal, browser and emulated controller drive the same one, through `dialogue.Dialogue`.
"""

import re
from collections.abc import Callable

from vrts.base.source import SourceFile
from vrts.ir.commands import Abort, AbortProcess, Answer
from vrts.lang.typed.commands import CommandLine, read_command
from vrts.lang.vocabulary.commands import IDLE_ONLY
from vrts.monitor import words
from vrts.monitor.commands import (
    editor,
    execution,
    files,
    helping,
    showing,
    teaching,
    texts,
    values,
)
from vrts.monitor.desk import Desk, Mode, Refused, Situation, Turn, executes
from vrts.monitor.folder import CannotUse

_QUALIFIED = re.compile(r"^([ ]*(?:LIST|DELETE))[ ]*/[ ]*([PLRS])\b", re.IGNORECASE)  # of AS
MAX_LINE = 1000  # characters that are looked at; no command or step is as long

Handler = Callable[[CommandLine, Desk, Situation], Turn]

HANDLERS: dict[str, Handler] = {
    **dict.fromkeys(execution.PLAIN, execution.plain),
    "BASE": execution.as_instruction,
    "CALIBRATE": execution.calibrate,
    "COPY": texts.copy,
    "DELETE": texts.delete,
    "DELETEL": values.delete,
    "DELETEP": texts.delete_programs,
    "DELETER": values.delete,
    "DELETES": values.delete,
    "DIRECTORY": texts.directory,
    "DISABLE": execution.as_instruction,
    "DO": execution.do,
    "DPOINT": values.delete,
    "EDIT": editor.edit_command,
    "ENABLE": execution.as_instruction,
    "EXECUTE": execution.execute,
    "FCOPY": files.copy_file,
    "FDELETE": files.delete_file,
    "FDIRECTORY": files.list_files,
    "FLIST": files.show_file,
    "FREE": showing.free,
    "FRENAME": files.rename_file,
    "HELP": helping.help_with,
    "HERE": values.here,
    "ID": showing.identify,
    "IO": showing.signals,
    "LISTF": files.list_files,
    "LISTL": values.list_locations,
    "LISTP": texts.list_programs,
    "LISTR": values.list_reals,
    "LISTS": values.list_strings,
    "LOAD": files.load,
    "LOADL": files.load,
    "LOADP": files.load,
    "NEXT": execution.steps,
    "PARAMETER": showing.parameter,
    "PCEND": execution.end_process,
    "PCEXECUTE": execution.execute_process,
    "PCSTATUS": showing.status,
    "POINT": values.point,
    "RENAME": texts.rename,
    "RESET": execution.reset,
    "SIGNAL": execution.signal,
    "SPEED": execution.speed,
    "SSTEP": execution.steps,
    "STATUS": showing.status,
    "STORE": files.store,
    "STOREL": files.store,
    "STOREP": files.store,
    "STORER": files.store,
    "STORES": files.store,
    "SWITCH": showing.switches,
    "TEACH": teaching.teach,
    "TIME": showing.time,
    "TOOL": execution.as_instruction,
    "WHERE": showing.where,
    "XSTEP": execution.steps,
    "ZERO": texts.zero,
}


class Monitor:
    """The operator's side of a controller."""

    def __init__(self, desk: Desk) -> None:
        """Begin at the dot."""
        self.desk = desk
        self._mode: Mode | None = None

    @property
    def at_commands(self) -> bool:
        """Whether the next line is a command, not an answer to a question or a step."""
        return self._mode is None

    def prompt(self, now: Situation) -> str:
        """Return what stands before the line that is typed next."""
        if self._mode is not None:
            return self._mode.prompt
        if now.asks:
            return ""  # the program has asked
        if self.desk.dialect.is_as:
            return ">"  # [manual language/monitor#prompt]
        return "*" if now.executing else "."

    def enter(self, line: str, now: Situation) -> Turn:
        """Take a line."""
        line = line.rstrip("\r\n")[:MAX_LINE]
        if self._mode is None and now.asks:
            return Turn(commands=(Answer(line),))
        try:
            turn = self._taken(line, now)
        except Refused as refused:
            turn = Turn(refused.text, mode=self._mode)
        except CannotUse as problem:
            turn = Turn(words.starred(problem.words, problem.reason), mode=self._mode)
        self._mode = turn.mode
        return turn

    def interrupt(self, now: Situation) -> Turn:
        """Take Ctrl-C: leave a question or the editor; at commands stop what executes."""
        if self._mode is not None:
            turn = self._mode.interrupt(self.desk, now)
            self._mode = turn.mode
            return turn
        robot = (Abort(),) if now.executing else ()
        process = (AbortProcess(),) if executes(now.state.process) else ()
        return Turn(commands=(*robot, *process))

    def load(self, source: SourceFile, now: Situation) -> Turn:
        """Take what a file holds into memory, as LOAD does."""
        return files.load_source(source, self.desk, now)

    def _taken(self, line: str, now: Situation) -> Turn:
        if self._mode is not None:
            return self._mode.enter(line, self.desk, now)
        if self.desk.dialect.is_as:
            line = _QUALIFIED.sub(r"\1\2", line)
        command, found = read_command(SourceFile("monitor", line), self.desk.dialect)
        if command is None:
            return Turn(words.first_refusal(found) or "")
        word = command.word
        if word.text in IDLE_ONLY and now.executing:
            raise Refused(words.starred(words.ILLEGAL_NOW))
        handler = HANDLERS.get(word.text)
        if handler is None:
            raise Refused(words.starred(words.NOT_INSTALLED, f"{word.text} is not simulated"))
        return handler(command, self.desk, now)
