"""When hand-ins are due, what lateness costs, and which of several counts; also of an exam."""

from dataclasses import dataclass
from datetime import datetime, timedelta
from enum import Enum
from fractions import Fraction
from typing import NamedTuple

from vrts.check.rules.scheme import TOTAL


class Keep(Enum):
    """Which of several hand-ins of a student counts."""

    LATEST = "latest"
    BEST = "best"  # by the mark after what lateness costs


class LateStep(NamedTuple):
    """What being late by more than a while costs."""

    after: timedelta
    points: Fraction


@dataclass(frozen=True, slots=True)
class LateRules:
    """When hand-ins are due, and what lateness costs."""

    due: datetime  # aware
    grace: timedelta = timedelta(0)  # so much later still costs nothing
    per_day: Fraction = Fraction(0)  # points for each day begun
    steps: tuple[LateStep, ...] = ()  # instead: the last one that applies
    most: Fraction = TOTAL  # points that lateness costs at most
    closed: datetime | None = None  # what comes after this gets 0
    opens: datetime | None = None  # of an exam: what comes before this gets 0; None: no exam
    attempts: int | None = None  # so many of a student's hand-ins count, the first; None: all

    @property
    def is_exam(self) -> bool:
        """Whether only what comes while an exam is open counts."""
        return self.opens is not None
