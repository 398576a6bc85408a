"""What graders have decided, by student: as the page shows it."""

from collections import defaultdict
from collections.abc import Mapping
from fractions import Fraction
from types import MappingProxyType
from typing import NamedTuple

from vrts.desk.book.at_once import made_at_once
from vrts.desk.book.versions import items_told
from vrts.desk.told import (
    ChangeTold,
    CommentTold,
    ConflictTold,
    GivenTold,
    GraderTold,
    HistoryTold,
    ItemTold,
    Looked,
    Side,
)
from vrts.marking.by_hand.decisions.counting import counted
from vrts.marking.by_hand.decisions.ledger import Filed, Ledger
from vrts.marking.by_hand.decisions.records import (
    ChangeMark,
    Comment,
    Decide,
    Excuse,
    Extend,
    Finish,
    Give,
    Undo,
)
from vrts.marking.by_hand.decisions.state import Conflict, OfStudent, State, students_of
from vrts.marking.by_hand.decisions.words import sentence_of
from vrts.marking.exports.numbers import number


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
    set_by: tuple[str, ...] = ()  # whose marks by hand take the place of it, ids
    otherwise: str = ""  # that all finished with one mark which is not the final one


class Decided(NamedTuple):
    """What was decided about a class."""

    students: Mapping[str, Mine] = MappingProxyType({})
    items: tuple[ItemTold, ...] = ()
    conflicts: tuple[ConflictTold, ...] = ()
    graders: tuple[GraderTold, ...] = ()
    alone: Mapping[str, float | None] = MappingProxyType({})  # marks that whoever looks would give
    at_once: tuple[tuple[str, ...], ...] = ()  # names of records that one deed has written

    def of(self, student: str) -> Mine:
        """Return what was decided about a student."""
        return self.students.get(student, NOTHING)

    def beside(self, record: str) -> tuple[str, ...]:
        """Return the names of records that were written with one, by one deed; () for none."""
        return next((names for names in self.at_once if record in names), ())


NOTHING = Mine()


def told_of(ledger: Ledger, state: State, programs: Mapping[str, str], me: str) -> Decided:
    """Return what graders decided as the page shows it.

    Args:
        ledger: The records that whoever looks may see.
        state: What they come to.
        programs: By id of the class, sha256 of the program that is marked now, or `none`.
        me: Id of whoever looks.
    """
    undone = counted(ledger.records).undone
    history: dict[str, list[HistoryTold]] = defaultdict(list)
    whose: dict[str, tuple[str, ...]] = {}
    undoes: dict[str | None, int] = {
        one.name: len(one.said.records) for one in ledger.records if isinstance(one.said, Undo)
    }
    for one in ledger.records:
        students = tuple(dict.fromkeys(students_of(one.said)))
        if isinstance(one.said, Decide):
            named = (one.said.keep, *one.said.over)
            every = (who for name in named for who in whose.get(name, ()))
            students = one.said.students or tuple(dict.fromkeys(every))
        whose[one.name] = students
        by = undone.get(one.name)
        told = _history(one, by, len(students), undoes.get(by, 0))
        for student in students:
            history[student].append(told)
    return Decided(
        {
            student: _mine(state.of(student), tuple(history[student]), program, me)
            for student, program in programs.items()
            if student in history or student in state.students
        },
        items_told(ledger, state, undone),
        tuple(_conflict(one) for one in state.conflicts),
        tuple(GraderTold(grader.id, grader.name) for grader in ledger.graders),
        at_once=tuple(made_at_once(ledger, undone)),
    )


def _mine(found: OfStudent, history: tuple[HistoryTold, ...], program: str, me: str) -> Mine:
    due = found.extension[0].said if found.extension else None
    looked = tuple(_looked(one, program) for one in found.finished)
    comments = (*found.comments, *found.lapsed)
    return Mine(
        tuple(_comment(one, program, me) for one in comments if isinstance(one.said, Comment)),
        tuple(_given(one) for one in found.given if isinstance(one.said, Give)),
        tuple(_change(one) for one in found.mark if isinstance(one.said, ChangeMark)),
        tuple(sorted(history, key=lambda one: one.at)),
        found.assigned,
        looked,
        due.due if isinstance(due, Extend) else None,
        any(isinstance(one.said, Excuse) for one in found.mark),
        bool(found.conflicts),
        tuple(
            dict.fromkeys(
                one.grader
                for one in found.mark
                if isinstance(one.said, ChangeMark) and one.said.mark is not None
            )
        ),
    )


def _comment(one: Filed, program: str, me: str) -> CommentTold:
    said = one.said
    assert isinstance(said, Comment)
    return CommentTold(
        one.name,
        one.grader,
        one.who,
        said.at,
        said.line,
        said.time_s,
        said.text,
        said.private,
        bool(said.program) and said.program != program,
        one.grader == me,
    )


def _given(one: Filed) -> GivenTold:
    said = one.said
    assert isinstance(said, Give)
    where = said.line, said.time_s
    return GivenTold(one.name, said.item, one.grader, said.at, *where, said.students)


def _change(one: Filed) -> ChangeTold:
    said = one.said
    assert isinstance(said, ChangeMark)
    delta, mark = _points(said.delta), _points(said.mark)
    return ChangeTold(one.name, one.grader, said.at, delta, mark, said.reason)


def _looked(one: Filed, program: str) -> Looked:
    said = one.said
    assert isinstance(said, Finish)
    stale = bool(said.program) and said.program != program
    return Looked(one.grader, _points(said.mark), stale)


def _history(one: Filed, undone_by: str | None, students: int, undone: int) -> HistoryTold:
    what = sentence_of(one), undone_by, students
    return HistoryTold(one.name, one.grader, one.who, one.said.at, *what, undone=undone)


def _points(text: str | None) -> float | None:
    return None if text is None else float(number(Fraction(text)))


def _conflict(one: Conflict) -> ConflictTold:
    sides = (Side(side.name, side.who, side.said.at, sentence_of(side)) for side in one.sides)
    return ConflictTold(one.id, one.about, one.student, one.sentence, tuple(sides))
