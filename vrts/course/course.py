"""What a course is: its people as the file names them, its rooms, its assignments."""

import re
from dataclasses import dataclass, field
from datetime import datetime
from pathlib import Path
from typing import Final, Literal, NamedTuple

from vrts.course.slot_rules import SlotRules
from vrts.live.entrance.provider.settings import ProviderSettings
from vrts.live.rooms.own.limits import OwnLimits

COURSE_FILE: Final = "course.toml"
HANDED_IN: Final = "handed-in"  # in the course's folder
HANDING: Final = "handing"  # in the server's folder: pages about programs
EMAIL: Final = re.compile(r"[^@\s<>\"]+@[^@\s<>\"]+$")  # what an e-mail address looks like

Rank = Literal["teacher", "assistant", "student"]


class Staff(NamedTuple):
    """Somebody who teaches, as the file of the course names them."""

    rank: Rank
    name: str
    email: str  # by which they are known when they log in
    rooms: tuple[str, ...] = ()  # names of the rooms that an assistant may lead; empty: all


class Team(NamedTuple):
    """Students who share a robot of their own and hand in together."""

    name: str
    members: tuple[str, ...]  # e-mail addresses, or what the list of the class calls them


@dataclass(frozen=True, slots=True)
class Assignment:
    """A task that students of a course work on."""

    id: str  # names files and addresses: letters, digits, `-` and `_`
    task: Path  # folder of the task
    opens: datetime | None = None  # students see it from then on; None: always
    attempts: int | None = None  # how often one may hand in; None: as often as one likes
    team: bool = False  # teams hand in together
    marked: Path | None = None  # folder of its marking: later deadlines and excuses stand there


@dataclass(frozen=True, slots=True)
class Course:
    """A course, as its file says."""

    folder: Path  # of the file
    title: str
    roster: Path | None = None  # list of the class; None: the file names nobody but staff
    guests: bool = False  # whether the class code lets in who is on no list
    rooms: tuple[str, ...] = ("Class",)  # that all share
    scenes: tuple[str, ...] = ()  # besides those of the assignments
    own_robots: bool = True  # whether each student may have one
    limits: OwnLimits = field(default_factory=OwnLimits)  # of these robots
    staff: tuple[Staff, ...] = ()
    teams: tuple[Team, ...] = ()
    assignments: tuple[Assignment, ...] = ()
    slots: SlotRules | None = None  # times of a shared robot that can be booked; None: none
    login: ProviderSettings | None = None  # by which people log in; None: by passwords only

    @property
    def handed_in(self) -> Path:
        """The folder into which hand-ins are written: one for each assignment in it."""
        return self.folder / HANDED_IN
