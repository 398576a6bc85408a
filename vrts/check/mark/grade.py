"""A mark and where every lost point went."""

from dataclasses import dataclass
from enum import Enum
from fractions import Fraction
from typing import NamedTuple

from vrts.base.diagnostic import Moment
from vrts.base.source import Span
from vrts.check.rules.scheme import TOTAL
from vrts.check.verdict import Answer

REVIEW = "to be reviewed"  # begins the obstacles that a person has to look at
NOT_CHECKED = "collisions were not checked"  # one of the obstacles


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
    kind: str  # "target", "via", "limit", "contact", "drop", "demand", "time", "program", "task"
    sentence: str  # "at 12.4 s, line 17 `MOVES base2_put`, the held can1 hits base1"
    hint: str  # what to look at; never the solution
    span: Span | None
    moment: Moment | None
    check: str = ""  # name of the verdict it rests on; "" for what is about the whole


class Earned(NamedTuple):
    """What one thing that is asked for earned."""

    check: str  # name of the verdict it rests on
    title: str
    kind: str  # "target", "via", "limit", "contact", "demand", "time"
    answer: Answer | None  # None: not reached
    points: Fraction
    most: Fraction  # 0: it can only cost
    message: str  # what is wrong; "" where nothing is


class Most(NamedTuple):
    """How many points there are for what; they add up to the total."""

    targets: Fraction
    vias: Fraction
    time: Fraction
    rest: Fraction  # that the task does not give


class ShownParts(NamedTuple):
    """The parts as they are shown: targets + vias - contacts - limits - demands + time is the mark.

    What was taken off is less than it cost where there was nothing left to take it from.
    """

    targets: Fraction
    vias: Fraction
    contacts: Fraction
    limits: Fraction
    demands: Fraction
    time: Fraction
    most: Most


@dataclass(frozen=True, slots=True)
class Grade:
    """The mark, from 0 to the total, and its explanation.

    Losses and what was earned are in hundredths, as they are shown: they add up to what the mark
    lacks, and to the mark. T, V, C, D, E and L are exact.
    """

    mark: Fraction  # a multiple of 1/10
    status: Status
    targets: Fraction  # T
    vias: Fraction  # V
    contacts: Fraction  # C
    time: Fraction  # D
    losses: tuple[Loss, ...]  # broken limits, then costliest first; then "time", "task"
    ready: bool  # for the real robot
    obstacles: tuple[str, ...]  # why it is not ready, most serious first
    duration_s: float | None  # EXECUTE to program end
    demands: Fraction = Fraction(0)  # E, lost by zones, limits and rules of the task
    lowest: Fraction | None = None  # mark if all that is undetermined went wrong; None: nothing is
    earned: tuple[Earned, ...] = ()  # in the order of the task; adds up to the mark
    limits: Fraction = Fraction(0)  # L, lost by breaking limits of the robot
    total: Fraction = TOTAL  # the mark is out of so many points
    shown: ShownParts | None = None  # None: there was no run
