"""All that may ever leave for a controller: whatever is not listed here is not sent.

Nothing here executes a program or an instruction, moves the arm, enables power, calibrates, or
touches a disk. What a profile or a bundle holds cannot widen the list.
"""

import re
from enum import Enum

VERBS = frozenset(
    {
        *("STATUS", "DIRECTORY", "EDIT", "POINT"),
        *("LISTP", "LISTL", "LISTR", "LISTS", "LIST/P", "LIST/L", "LIST/R", "LIST/S"),
        *("DELETEP", "DELETE/P"),
    }
)
WHILE_RUNNING = frozenset(verb for verb in VERBS if verb.startswith("LIST")) | {"STATUS"}
LETTERS = frozenset({"E", "I"})  # of the editor: leave, insert
CANCELS = ("\x15", "\x18")  # Ctrl-U, Ctrl-X: take back what is typed of a line
MOST = 4096  # characters of a line

FORMS = f"{', '.join(sorted(VERBS))} with names, and {', '.join(sorted(LETTERS))} in the editor"

_NAMES = r"[$#]?[A-Za-z][\w.]*(\[\d+(,\d+)*\])?"
_FORMALS = r"\([\w.,$#&\[\] ]*\)"  # AS marks locations by &
_COMMAND = re.compile(
    rf"(?P<verb>[A-Z]+(/[A-Z])?)( {_NAMES}(?P<formals>{_FORMALS})?(, ?({_NAMES}|\d+))*)?", re.ASCII
)
_NUMBER = r"-?\d+(\.\d+)?"
_VALUES = re.compile(rf"{_NUMBER}(,{_NUMBER}){{5}}", re.ASCII)
_STEP = re.compile(r"[ -~]+")


class Prompt(Enum):
    """What the controller waits for."""

    READY = "the prompt at which no program executes"
    RUNNING = "the prompt at which a program executes"
    STEP = "the editor's question for a step"
    INSERT = "the editor's question for a step to be inserted"
    CHANGE = "the question for new components of a location"
    CONFIRM = "the question whether to go on"


def permits(text: str, prompt: Prompt) -> bool:
    """Return whether a line may be typed at a prompt."""
    if len(text) > MOST or not (text.isascii() and (text.isprintable() or not text)):
        return False
    match prompt:
        case Prompt.READY | Prompt.RUNNING:
            found = _COMMAND.fullmatch(text)
            verbs = VERBS if prompt is Prompt.READY else WHILE_RUNNING
            if found is None:
                return not text
            return found["verb"] in verbs and (not found["formals"] or found["verb"] == "EDIT")
        case Prompt.STEP | Prompt.INSERT:
            return not text or _STEP.fullmatch(text) is not None
        case Prompt.CHANGE:
            return not text or _VALUES.fullmatch(text) is not None
        case Prompt.CONFIRM:
            return text in ("", "Y")


def is_command_form(form: str) -> bool:
    """Return whether a profile's command can be permitted: `EDIT {name},{step}`."""
    try:
        text = form.format(name="a", step=1, formals="(b)")
    except (KeyError, IndexError, ValueError, AttributeError):
        return False
    return bool(text) and permits(text, Prompt.READY)


def is_letter(text: str) -> bool:
    """Return whether a profile's letter of the editor is one that is sent."""
    return text in LETTERS
