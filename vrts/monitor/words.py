"""What the monitor says: VAL's words between asterisks, then ours below them."""

import re
from collections.abc import Iterable

from vrts.base.diagnostic import Diagnostic

_SAYS = re.compile(r"VAL-II says \*(.+)\*")

ILLEGAL_COMMAND = "Illegal monitor command"
ILLEGAL_NOW = "Illegal when program executing"
ILLEGAL_VALUE = "Illegal value"
MISSING_ARGUMENT = "Missing argument"
UNEXPECTED_TEXT = "Unexpected text at end of line"
UNDEFINED = "Undefined program or variable name"
UNDEFINED_VALUE = "Undefined value"
NOT_EXECUTABLE = "Program not executable"
PROGRAM_EXISTS = "Program already exists"
IN_USE = "Program is in use"
FILE_EXISTS = "File already exists"
NO_FILE = "Nonexistent file"
MIXING = "Mixing of types"
INVALID_NUMBER = "Invalid number format"
INVALID_NAME = "Invalid program or variable name"
NOT_INSTALLED = "Option not installed"
ILLEGAL_IN_DO = "Illegal in DO"
STRUCTURE = "Control structure error"
NO_ROOM = "Not enough storage area"
SURE = "Are you sure (Y/N)?"


def starred(words: str, *below: str) -> str:
    """Return words of VAL on a line of their own, and lines of ours below."""
    return "".join(f"{line}\n" for line in (f"*{words}*", *below))


def val_words(found: Diagnostic) -> str | None:
    """Return the words that VAL has for a diagnostic, without asterisks."""
    for note in found.notes:
        match = _SAYS.search(note)
        if match is not None:
            return match[1]
    return None


def refusal(found: Diagnostic, *, help_too: bool = True) -> str:
    """Return what the monitor prints for a finding: VAL's words, what is wrong, what to do."""
    words = val_words(found)
    help_ = found.help if help_too else ()
    if words is None:
        return starred(found.headline[:1].upper() + found.headline[1:], *help_)
    said = () if found.headline.lower() == words.lower() else (found.headline,)
    return starred(words, *said, *help_)


def first_refusal(found: Iterable[Diagnostic]) -> str | None:
    """Return what is printed for the first error; None when there is none."""
    worst = next((d for d in found if d.is_error), None)
    return None if worst is None else refusal(worst)
