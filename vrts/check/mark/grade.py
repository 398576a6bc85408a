"""A mark and where every lost point went."""

from dataclasses import dataclass
from enum import Enum
from fractions import Fraction
from typing import NamedTuple

from vrts.base.diagnostic import Moment
from vrts.base.source import Span
from vrts.check.verdict import Answer

REVIEW = "to be reviewed"  # begins the obstacles that a person has to look at


class Status(Enum):
    """What became of a submission."""

    GRADED = "graded"
    DOES_NOT_COMPILE = "does not compile"
    STOPPED = "stopped by an error"  # run-time error; what was achieved counts
    LIMIT = "stopped by a limit"
    UNREADABLE = "unreadable"  # not plain text, empty, too large


class Loss(NamedTuple):
    """Points lost to one cause."""

    points: Fraction
    kind: str  # "target", "via", "contact", "drop", "demand", "time", "program", "rounding"
    sentence: str  # "at 12.4 s, line 17 `MOVES base2_put`, the held can1 hits base1"
    hint: str  # what to look at; never the solution
    span: Span | None
    moment: Moment | None
    check: str = ""  # name of the verdict it rests on; "" for what is about the whole


class Earned(NamedTuple):
    """What one thing that is asked for earned."""

    check: str  # name of the verdict it rests on
    title: str
    kind: str  # "target", "via", "contact", "demand", "time", "rounding"
    answer: Answer | None  # None: not reached
    points: Fraction
    most: Fraction  # 0: it can only cost
    message: str  # what is wrong; "" where nothing is


@dataclass(frozen=True, slots=True)
class Grade:
    """The mark, 0 to 10, and its explanation. `losses` add up to 10 - mark exactly."""

    mark: Fraction  # a multiple of 1/10
    status: Status
    targets: Fraction  # T
    vias: Fraction  # V
    contacts: Fraction  # C
    time: Fraction  # D
    losses: tuple[Loss, ...]  # costliest first; then "time", "task", "rounding"
    ready: bool  # for the real robot
    obstacles: tuple[str, ...]  # why it is not ready, most serious first
    duration_s: float | None  # EXECUTE to program end
    demands: Fraction = Fraction(0)  # E, lost by zones, limits and rules of the task
    lowest: Fraction | None = None  # mark if all that is undetermined went wrong; None: nothing is
    earned: tuple[Earned, ...] = ()  # in the order of the task; adds up to the mark exactly
