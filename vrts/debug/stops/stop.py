"""What it is to stand somewhere, and where the user wishes to stand."""

from dataclasses import dataclass, field
from enum import Enum
from typing import NamedTuple

from vrts.debug.alarms import Alarm, Filter
from vrts.debug.breakpoints import Breakpoint, Watch
from vrts.debug.passages import Instant
from vrts.engine.memory.events import Cause


class Why(Enum):
    """Why it stands where it stands; the values are words of the debug adapter protocol."""

    ENTRY = "entry"
    STEP = "step"
    BREAKPOINT = "breakpoint"
    CHANGE = "data breakpoint"
    ALARM = "exception"
    GOTO = "goto"
    GO = "go"  # somebody asked for this place: an event, a call, a mark
    BEGIN = "begin"
    END = "end"


class Way(Enum):
    """How far a step goes."""

    INTO = "into"  # to the next step of any program
    OVER = "over"  # ... of this program, or of what called it
    OUT = "out"  # ... of what called it


class Stop(NamedTuple):
    """Where it has come to stand, and why."""

    instant: Instant
    why: Why
    text: str = ""
    process: bool = False  # the process control program came there
    ids: tuple[int, ...] = ()  # of breakpoints
    alarm: Alarm | None = None
    by: Cause | None = None  # the step that did what the text says, where it is an earlier one

    @property
    def cause(self) -> Cause | None:
        """The step to blame, whose line is to be shown; None: that of the present step."""
        return self.by if self.alarm is None else self.alarm.cause


class Logged(NamedTuple):
    """What a log point wrote on the way."""

    instant: Instant
    text: str
    breakpoint: int


@dataclass(slots=True)
class Wishes:
    """Where the user wishes to stop."""

    lines: list[Breakpoint] = field(default_factory=list[Breakpoint])
    watches: list[Watch] = field(default_factory=list[Watch])
    filters: frozenset[Filter] = frozenset()
