"""What a grader may see who marks rows by themselves: everybody else's view of them is hidden.

Rows that are assigned to two graders or more are marked twice, and that is worth something only
where neither knows what the other thinks. Until all of them have finished a row, each sees it as if
nobody else had given, written or changed anything on it. Later deadlines, excuses and assignments
are no opinions of a program: everybody sees them. So are undos, of which a grader is told whose
decision is undone.
"""

from collections import defaultdict
from collections.abc import Collection, Mapping
from typing import NamedTuple

from msgspec.structs import replace

from vrts.marking.by_hand.decisions.counting import counted
from vrts.marking.by_hand.decisions.ledger import Filed, Ledger
from vrts.marking.by_hand.decisions.records import (
    Assign,
    ChangeMark,
    Comment,
    Decide,
    Finish,
    Give,
)
from vrts.marking.by_hand.decisions.state import students_of

NOBODY: frozenset[str] = frozenset()


class Seen(NamedTuple):
    """A ledger as a grader may see it."""

    ledger: Ledger
    alone: frozenset[str] = NOBODY  # students whom the grader marks by themselves now
    hidden: frozenset[str] = NOBODY  # names of records of which something is left out


class Shared(NamedTuple):
    """A row that several graders mark."""

    assigned: tuple[str, ...]  # ids of graders, two or more
    finished: frozenset[str]  # who of them has finished the program that is marked now

    @property
    def is_open(self) -> bool:
        """Whether somebody has not finished."""
        return len(self.finished) < len(self.assigned)


def shared_rows(ledger: Ledger, programs: Mapping[str, str]) -> dict[str, Shared]:
    """Return by id the rows that are assigned to two graders or more.

    Args:
        ledger: All records.
        programs: By id of the class, sha256 of the program that is marked now, or `none`.
    """
    assigned: dict[str, dict[str, tuple[str, ...]]] = defaultdict(dict)  # by student and file
    finished: dict[str, dict[str, str]] = defaultdict(dict)  # the last program of each grader
    for one in counted(ledger.records).counting:
        match one.said:
            case Assign(students=students, graders=graders):
                for student in students:
                    assigned[student][one.grader] = graders
            case Finish(student=student, program=program):
                finished[student][one.grader] = program
            case _:
                pass
    found: dict[str, Shared] = {}
    for student, by_file in assigned.items():
        who = tuple(sorted({grader for graders in by_file.values() for grader in graders}))
        if len(who) > 1 and student in programs:
            fresh = {"", programs[student]}
            looked = finished[student]
            found[student] = Shared(who, frozenset(k for k in who if looked.get(k, "-") in fresh))
    return found


def seen_by(ledger: Ledger, me: str, programs: Mapping[str, str]) -> Seen:
    """Return a ledger as a grader may see it now.

    Args:
        ledger: All records.
        me: Id of the grader.
        programs: By id of the class, sha256 of the program that is marked now, or `none`.
    """
    shared = shared_rows(ledger, programs).items()
    alone = {name for name, row in shared if row.is_open and me in row.assigned}
    return by_one(ledger, me, alone)


def by_one(ledger: Ledger, me: str, students: Collection[str]) -> Seen:
    """Return a ledger without what others than a grader gave, wrote or changed on some rows."""
    if not students:
        return Seen(ledger)
    whose = {one.name: students_of(one.said) for one in ledger.records}
    opinions = {
        one.name for one in ledger.records if isinstance(one.said, Give | ChangeMark | Finish)
    }
    kept: list[Filed] = []
    hidden: set[str] = set()
    for one in ledger.records:
        seen = one if one.grader == me else _without(one, students, whose, opinions)
        if seen is not one:
            hidden.add(one.name)
        if seen is not None:
            kept.append(seen)
    return Seen(ledger._replace(records=tuple(kept)), frozenset(students), frozenset(hidden))


def _without(
    one: Filed,
    students: Collection[str],
    whose: Mapping[str, tuple[str, ...]],
    opinions: set[str],
) -> Filed | None:
    """Return a record without some students; None where nothing is left of it."""
    said = one.said
    match said:
        case Comment() | Finish():
            return None if said.student in students else one
        case Give() | ChangeMark():
            about = said.students
        case Decide() if opinions.intersection((said.keep, *said.over)):
            every = (who for name in (said.keep, *said.over) for who in whose.get(name, ()))
            about = said.students or tuple(dict.fromkeys(every))
        case _:
            return one
    left = tuple(student for student in about if student not in students)
    if len(left) == len(about):
        return one
    return one._replace(said=replace(said, students=left)) if left else None
