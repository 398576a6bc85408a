"""What the intake finds out about a hand-in: who, which file, why, when, and what is wrong."""

import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from datetime import datetime
from enum import Enum
from typing import NamedTuple

from vrts.marking.unsafe import Doubt


class Platform(Enum):
    """Who gave out an id of a student; the values are those of the table."""

    MOODLE = "moodle"  # the number in "Participant 123456", which stands in the worksheet too
    CANVAS = "canvas"
    SIS = "sis"  # of the student information system: Canvas and Gradescope pass it on
    GRADESCOPE = "gradescope"  # of the submission


def plain_id(text: str) -> str:
    """Return an id of a platform as it can stand in a list of ids."""
    return " ".join(text.replace(";", " ").split())


@dataclass(frozen=True, slots=True)
class Student:
    """Whoever handed in, as far as the download tells; "" for what it does not tell."""

    name: str
    email: str = ""
    login: str = ""
    ids: Mapping[str, str] = field(default_factory=dict[str, str])  # by `Platform.value`


class Kind(Enum):
    """What is wrong with a hand-in; the values are those of the table."""

    MISSING = "missing"  # nothing was handed in
    EMPTY = "empty"
    AMBIGUOUS = "ambiguous"  # more than one program, and nothing says which
    NOT_TEXT = "not plain text"
    TOO_LARGE = "too large"
    ARCHIVE = "archive refused"
    UNREADABLE = "unreadable"  # damaged, a link, or not permitted
    EXCUSED = "excused"  # said by the teacher: not marked, and no 0


class Problem(NamedTuple):
    """Why there is nothing to mark."""

    kind: Kind
    sentence: str  # says what is, and how to hand in well


class Attempt(NamedTuple):
    """One of several hand-ins of a student."""

    file: str
    received: datetime | None


class Tried(NamedTuple):
    """An attempt that was marked to choose among them."""

    file: str
    received: datetime | None
    mark: float | None  # as computed, before lateness; None: there is none


@dataclass(frozen=True, slots=True)
class Row:
    """One hand-in, which is one row of results."""

    identifier: str  # unique, also without regard to case, and safe as a file name
    student: Student
    file: str | None  # as in the download; `work.zip!pick.v2` for a file in a zip; None: none
    why: str  # one sentence: why this file
    received: datetime | None = None  # aware, told by the platform: never the date of a file
    flagged: bool | None = None  # by the platform: late, or on time as it is not called late
    late: bool | None = None  # the same as said by the teacher; None: nothing else was said
    due: datetime | None = None  # an own deadline, given by the teacher; None: that of the task
    attempts: tuple[Attempt, ...] = ()  # what can be marked, in order; the last is `file`
    others: tuple[str, ...] = ()  # files that were not chosen
    group: str = ""  # the same for students who handed in together
    problem: Problem | None = None
    chosen_by: datetime | None = None  # the own deadline with what graders gave, if any
    doubts: tuple[Doubt, ...] = ()  # why another attempt may be what counts
    tried: tuple[Tried, ...] = ()  # all attempts, where the best of several counts

    @property
    def title(self) -> str:
        """The name of the file as shown to the student, without folders; "" for none."""
        return re.split(r"[/!]", self.file)[-1] if self.file else ""

    @property
    def called_late(self) -> bool | None:
        """Whether it is called late, the teacher before the platform; None: nobody tells."""
        return self.flagged if self.late is None else self.late

    @property
    def attempt(self) -> int:
        """The number of the attempt, from 1, as far as the download tells."""
        return max(1, len(self.attempts))


class Intake(NamedTuple):
    """What a download holds."""

    layout: str  # in words: "Moodle, a folder for each student"
    rows: tuple[Row, ...]
    remarks: tuple[str, ...]  # sentences about what is no hand-in, or looks odd
