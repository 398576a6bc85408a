"""What a line may go on with: commands, instructions, and names in memory."""

import re
from collections.abc import Iterable

from vrts.engine.run import State
from vrts.lang.dialect import Dialect
from vrts.lang.vocabulary.commands import COMMANDS, look_up_command
from vrts.lang.vocabulary.lookup import spellings
from vrts.monitor.desk import Desk

_WORD = re.compile(r"(?:[$#]?[A-Za-z][\w.]*|[$#])$", re.ASCII)
_PROGRAMS = frozenset(
    {"EXECUTE", "EDIT", "LISTP", "DIRECTORY", "DELETE", "DELETEP", "COPY", "RENAME", "PCEXECUTE"}
)
_FILES = frozenset({"LOAD", "FLIST", "FDELETE", "FCOPY", "FRENAME", "STORE"})


def completions(line: str, desk: Desk, state: State) -> list[str]:
    """Return the words that the last one of a line may become, in order."""
    match = _WORD.search(line)
    start = match.group() if match is not None else ""
    before = line[: len(line) - len(start)].strip()
    if not before:
        return _starting(start.upper(), COMMANDS)
    word = look_up_command(before.split()[0]).word
    text = word.text if word is not None else ""
    if text.rstrip("PLRS") in _FILES or text in _FILES:
        return _starting(start, (entry.name for entry in desk.folder.entries()))
    if text in _PROGRAMS:
        return _starting(start.lower(), desk.programs)
    names = {name.partition("[")[0] for name in state.variables}
    found = _starting(start.lower(), {*names, *desk.programs})
    if text == "DO" and len(before.split()) == 1:
        return [*_instructions(start, desk.dialect), *found]
    return found


def _instructions(start: str, dialect: Dialect) -> list[str]:
    return _starting(start.upper(), spellings(dialect)) if start else []


def _starting(start: str, words: Iterable[str]) -> list[str]:
    return sorted(word for word in words if word.startswith(start))
