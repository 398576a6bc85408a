"""TEACH: each press of the pendant's RECORD key defines the next location."""

import re
from typing import NamedTuple

from vrts.base.pose import Pose
from vrts.ir.commands import SetVariable
from vrts.lang.typed.commands import CommandLine
from vrts.monitor import words
from vrts.monitor.commands.values import present, target
from vrts.monitor.desk import Desk, Refused, Situation, Turn, cell, is_name
from vrts.monitor.listings import location_row

_COUNTED = re.compile(r"(?P<stem>.*?)(?P<number>\d+)")
_INDEX_MOST = 32767


class Teaching(NamedTuple):
    """Waits for RECORD, which is a line `R`; an empty line ends it."""

    name: str
    indices: tuple[int, ...]
    frame: Pose  # of a compound: what stands before its last element

    @property
    def prompt(self) -> str:
        """Return what will be recorded next."""
        return f"{cell(self.name, self.indices)}: "

    def enter(self, line: str, desk: Desk, now: Situation) -> Turn:
        """Record the present position, or end."""
        if not line.strip():
            return Turn()
        if line.strip().upper() != "R":
            return Turn("press R to record, RETURN to end\n", mode=self)
        value = present(self.name, self.frame, now)
        following = successor(self.name, self.indices)
        if following is None:
            return Turn(words.starred(words.INVALID_NAME, "there are no further names"))
        name, indices = following
        shown = f"{cell(self.name, self.indices):<12}{location_row(value, desk.dialect.angles)}\n"
        recorded = SetVariable(self.name, self.indices, value)
        return Turn(shown, (recorded,), self._replace(name=name, indices=indices))

    def interrupt(self, desk: Desk, now: Situation) -> Turn:
        """End; what is recorded holds."""
        return Turn()


def teach(line: CommandLine, desk: Desk, now: Situation) -> Turn:
    """TEACH location."""
    if len(line.operands) != 1:
        raise Refused(words.starred(words.MISSING_ARGUMENT, f"write `{line.word.usage}`"))
    return Turn(mode=Teaching(*target(line, line.operands[0], desk, now)))


def successor(name: str, indices: tuple[int, ...]) -> tuple[str, tuple[int, ...]] | None:
    """Return the name after a name: p2 after p1, a[1] after a[0], grip1 after grip.

    None when it would be too long, or an index too large.
    """
    if indices:
        if indices[-1] >= _INDEX_MOST:
            return None
        return name, (*indices[:-1], indices[-1] + 1)
    match = _COUNTED.fullmatch(name)
    following = f"{match['stem']}{int(match['number']) + 1}" if match else f"{name}1"
    return (following, ()) if is_name(following) else None
