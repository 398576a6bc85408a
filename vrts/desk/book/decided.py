"""What graders have decided, by student: as the page shows it."""

from collections.abc import Mapping
from types import MappingProxyType
from typing import NamedTuple

from vrts.desk.book.opened import Opened
from vrts.desk.told import (
    ChangeTold,
    CommentTold,
    ConflictTold,
    GivenTold,
    GraderTold,
    HistoryTold,
    ItemTold,
    Looked,
)
from vrts.marking.row import Class


class Mine(NamedTuple):
    """What was decided about one student."""

    comments: tuple[CommentTold, ...] = ()
    given: tuple[GivenTold, ...] = ()
    changes: tuple[ChangeTold, ...] = ()
    history: tuple[HistoryTold, ...] = ()
    assigned: tuple[str, ...] = ()
    finished: tuple[Looked, ...] = ()
    due: str | None = None
    excused: bool = False
    conflict: bool = False


class Decided(NamedTuple):
    """What was decided about a class."""

    students: Mapping[str, Mine] = MappingProxyType({})
    items: tuple[ItemTold, ...] = ()
    conflicts: tuple[ConflictTold, ...] = ()
    graders: tuple[GraderTold, ...] = ()

    def of(self, student: str) -> Mine:
        """Return what was decided about a student."""
        return self.students.get(student, NOTHING)


NOTHING = Mine()


def decide(opened: Opened) -> tuple[Class, Decided, tuple[str, ...]]:
    """Return a class with all decisions, what they are, and what could not be read.

    Raises:
        CannotRead: A file cannot be read.
        Refused: A file has errors.
    """
    return opened.rows, Decided(), ()
