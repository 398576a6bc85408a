"""What the name of a download's layout tells of one hand-in, before any file is looked at."""

from datetime import datetime
from typing import NamedTuple

from vrts.marking.intake.row import Student


class HandIn(NamedTuple):
    """The files of one student in one attempt."""

    key: str  # the same for all attempts of a student
    words: tuple[str, ...]  # of which the identifier is made
    student: Student
    files: tuple[str, ...]
    order: tuple[int, ...] = ()  # attempts of a student are sorted by this
    received: datetime | None = None
    flagged: bool | None = None  # late; None: the platform does not call anything late
    group: str = ""


class Layout(NamedTuple):
    """A way in which platforms pack downloads, found in one."""

    title: str
    hand_ins: tuple[HandIn, ...]
    remarks: tuple[str, ...] = ()
    canvas: bool = False  # copies are numbered as Canvas does it
