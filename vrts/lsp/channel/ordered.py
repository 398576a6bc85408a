"""What is ordered to be done with a program, and what came of it, as lines of JSON and back."""

import json
from typing import NamedTuple

PATIENCE_S = 180.0  # for what is ordered, whatever it does
CPU_S = 120  # of it
FAULT = 70  # status of a fault in vrts


class Ordered(NamedTuple):
    """A program, and what is to be done with it."""

    work: str  # "run", "verify" or "debug"
    path: str  # of the program; a task beside it tells the scene
    text: str  # of the buffer
    entry: str | None = None  # program to execute; None: the task's, else the main one
    others: tuple[tuple[str, str], ...] = ()  # paths and texts of what belongs together with it


class Done(NamedTuple):
    """What came of it."""

    status: int  # as the command of the same name ends with
    short: str  # a few lines
    text: str  # everything
    page: str = ""  # HTML, with the run to go through forward and back


def line_of_ordered(message: Ordered | Done) -> bytes:
    """Return a line that says what is ordered, or what came of it."""
    return json.dumps(message).encode() + b"\n"


def ordered_of(line: bytes) -> Ordered:
    """Return what is ordered from the line that it was written as."""
    work, path, text, entry, others = json.loads(line)
    return Ordered(work, path, text, entry, tuple((p, t) for p, t in others))


def done_of(line: bytes) -> Done:
    """Return what came of it; of an empty line that its process did not live to tell."""
    if not line:
        why = f"it was stopped after {CPU_S} s of processor time, or by a fault in vrts"
        return Done(FAULT, why, f"{why}: the log of the editor shows which\n")
    return Done(*json.loads(line))
