"""What a marking was: by which task, with which options, when. Stands beside its results.

It is written first, and again in the end: where results are, there is always something that tells
what they are of.
"""

from datetime import datetime, timedelta
from fractions import Fraction
from typing import Literal

import msgspec

from vrts.check.task.late_rules import LateRules, LateStep
from vrts.marking.result import Damaged, Exact, Record, decoded
from vrts.marking.submission.one import Wanted
from vrts.marking.submission.setting import Place

SCHEMA = "vrts.marking/1"
NAME = "marking.json"


class Late(Record, frozen=True):
    """What lateness cost by the task, for deadlines that are moved after marking."""

    due: datetime
    grace_s: float
    per_day: Exact
    steps: tuple[tuple[float, Exact], ...]  # late by more than so many s costs so many points
    most: Exact
    closed: datetime | None

    @classmethod
    def of(cls, rules: LateRules | None) -> "Late | None":
        """Return rules as they are written; None where lateness costs nothing."""
        if rules is None:
            return None
        steps = ((step.after.total_seconds(), str(step.points)) for step in rules.steps)
        return cls(
            rules.due,
            rules.grace.total_seconds(),
            str(rules.per_day),
            tuple(steps),
            str(rules.most),
            rules.closed,
        )

    @property
    def rules(self) -> LateRules:
        """The same as a task has them."""
        return LateRules(
            self.due,
            timedelta(seconds=self.grace_s),
            Fraction(self.per_day),
            tuple(LateStep(timedelta(seconds=s), Fraction(points)) for s, points in self.steps),
            Fraction(self.most),
            self.closed,
        )


class About(Record, frozen=True):
    """One marking of a class."""

    schema: Literal["vrts.marking/1"]
    title: str
    place: Place  # paths as they were given
    submissions: tuple[str, ...]
    wanted: Wanted
    vrts: str
    command: tuple[str, ...]
    finished: datetime | None  # with its offset; None: it goes on, or was interrupted
    intake_sha256: str = ""  # of intake.csv as written; "": it was edited
    begun: datetime | None = None  # with its offset; None: of an earlier vrts
    late: Late | None = None  # None: lateness costs nothing, or of an earlier vrts

    @property
    def when(self) -> datetime:
        """The end of the marking; while there is none, its begin."""
        found = self.finished or self.begun
        assert found is not None, "nothing else is read"
        return found


def to_bytes(about: About) -> bytes:
    """Return a marking as JSON, laid out for people."""
    return msgspec.json.format(msgspec.json.encode(about), indent=1) + b"\n"


def from_bytes(data: bytes) -> About:
    """Return the marking that JSON stands for.

    Raises:
        Damaged: It is none.
    """
    about = decoded(data, About)
    if about.finished is None and about.begun is None:
        raise Damaged("it does not tell when the marking was")
    return about
