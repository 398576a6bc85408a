"""What is decided about a class: a pure function of the graders' files, whatever their order."""

from collections import defaultdict
from collections.abc import Collection, Hashable, Iterable, Iterator, Mapping, Sequence
from datetime import datetime
from fractions import Fraction
from types import MappingProxyType
from typing import NamedTuple

from vrts.check.task.score import in_tenths
from vrts.marking.by_hand.decisions.counting import counted
from vrts.marking.by_hand.decisions.items import ItemNow, items_of
from vrts.marking.by_hand.decisions.ledger import Filed, Ledger
from vrts.marking.by_hand.decisions.marks import Groups, is_base, mark_of
from vrts.marking.by_hand.decisions.records import (
    Assign,
    ChangeMark,
    Comment,
    Decide,
    Decision,
    Excuse,
    Extend,
    Finish,
    Give,
)
from vrts.marking.by_hand.decisions.settled import Settled, settled
from vrts.marking.by_hand.decisions.words import sentence_of

MARK, EXTENSION, FINISH, ITEM = "mark", "extension", "finish", "item"


class Conflict(NamedTuple):
    """What graders have decided differently: none of it counts."""

    id: str  # the same as long as it is about the same
    about: str  # MARK, EXTENSION, FINISH or ITEM
    student: str  # "" of an item
    sentence: str
    sides: tuple[Filed, ...]


class OfStudent(NamedTuple):
    """What is decided about one student."""

    comments: tuple[Filed, ...] = ()
    given: tuple[Filed, ...] = ()  # an item may be given more than once, and counts once
    mark: tuple[Filed, ...] = ()  # changes or excuses that count
    changes: Groups = ()  # the same changes: those in a group say the same, and count once
    later: frozenset[str] = frozenset()  # names of gives that come behind the mark that counts
    extension: tuple[Filed, ...] = ()  # that say the same
    assigned: tuple[str, ...] = ()  # ids of graders
    finished: tuple[Filed, ...] = ()  # the last of each grader
    preferred: tuple[Filed, Filed] | None = None  # the `finish` that counts, and who decided that
    lapsed: tuple[Filed, ...] = ()  # about another program: they do not count
    conflicts: tuple[Conflict, ...] = ()


NOTHING = OfStudent()


class State(NamedTuple):
    """What is decided about a class."""

    items: Mapping[str, ItemNow] = MappingProxyType({})
    students: Mapping[str, OfStudent] = MappingProxyType({})  # about whom anything is decided
    conflicts: tuple[Conflict, ...] = ()
    unknown: tuple[tuple[Filed, str], ...] = ()  # records, and ids of students who are not there
    without_item: tuple[Filed, ...] = ()  # that give an item which is not there

    def of(self, student: str) -> OfStudent:
        """Return what is decided about a student."""
        return self.students.get(student, NOTHING)


class Prepared(NamedTuple):
    """Decisions of a class, so that each student can be asked for."""

    items: Mapping[str, ItemNow] = MappingProxyType({})
    of_items: Mapping[str, Conflict] = MappingProxyType({})  # by id of the item
    decides: tuple[Filed, ...] = ()
    about: Mapping[str, Sequence[Filed]] = MappingProxyType({})  # records that count, by student
    given: tuple[Filed, ...] = ()  # records that give items
    dangling: tuple[tuple[str, str], ...] = ()  # records, and others they name that are not there
    circular: tuple[str, ...] = ()  # undos in a circle, which have no effect
    counting: tuple[Filed, ...] = ()  # all that nobody has undone

    def of(self, student: str, program: str | None = None) -> OfStudent:
        """Return what is decided about a student.

        Args:
            student: Id.
            program: sha256 of the program that is marked now, or `none`; None: it is not looked.
        """
        if student not in self.about:
            return NOTHING
        live = {name for name, item in self.items.items() if item.points and not item.withdrawn}
        found = _of_student(student, self.about[student], self.decides, program, live)
        mine = dict.fromkeys(_item(one) for one in found.given)
        return found._replace(
            given=tuple(one for one in found.given if _item(one) in self.items),
            conflicts=(
                *found.conflicts,
                *(self.of_items[item] for item in mine if item in self.of_items),
            ),
        )

    @property
    def without_item(self) -> tuple[Filed, ...]:
        """Records that give an item which is not there."""
        return tuple(one for one in self.given if _item(one) not in self.items)

    def unknown(self, known: Collection[str]) -> tuple[tuple[Filed, str], ...]:
        """Return records, and ids of students in them who are not in the class."""
        return tuple(
            (one, student)
            for student in sorted(self.about)
            if student not in known
            for one in self.about[student]
        )


def prepared(ledger: Ledger) -> Prepared:
    """Return the decisions in a ledger, ready to be asked for."""
    counting, _, circular, dangling = counted(ledger.records)
    decides = tuple(one for one in counting if isinstance(one.said, Decide))
    items, differing = items_of(ledger.records, counting, decides)
    about: dict[str, list[Filed]] = defaultdict(list)
    for one in counting:
        for student in dict.fromkeys(students_of(one.said)):
            about[student].append(one)
    return Prepared(
        items,
        {name: _of_item(name, sides) for name, sides in differing.items()},
        decides,
        dict(about),
        tuple(one for one in counting if isinstance(one.said, Give)),
        (*dangling, *_kept_nothing(ledger, decides)),
        circular,
        counting,
    )


def _kept_nothing(ledger: Ledger, decides: Iterable[Filed]) -> Iterator[tuple[str, str]]:
    names = {one.name for one in ledger.records}
    for one in decides:
        if isinstance(one.said, Decide) and one.said.keep not in names:
            yield one.name, one.said.keep


def state_of(ledger: Ledger, programs: Mapping[str, str] | None = None) -> State:
    """Return what is decided.

    Args:
        ledger: Of the graders' files.
        programs: By id of the class, sha256 of the program that is marked now, or `none`. What is
            about another program lapses, and what is about nobody is told. None: it is not looked.
    """
    ready = prepared(ledger)
    asked = sorted(ready.about if programs is None else ready.about.keys() & programs.keys())
    students = {
        student: ready.of(student, None if programs is None else programs[student])
        for student in asked
    }
    of_students = (one for found in students.values() for one in found.conflicts)
    return State(
        ready.items,
        {student: found for student, found in students.items() if found != NOTHING},
        (*ready.of_items.values(), *(one for one in of_students if one.student)),
        () if programs is None else ready.unknown(programs),
        ready.without_item,
    )


def students_of(said: Decision) -> tuple[str, ...]:
    """Return whom a record is about."""
    match said:
        case Comment() | Finish():
            return (said.student,)
        case Give() | ChangeMark() | Extend() | Excuse() | Assign():
            return said.students
        case _:
            return ()


def program_in(said: Decision, student: str) -> str:
    """Return the sha256 of the program that a record is about; "" where it does not say."""
    match said:
        case Comment() | Finish():
            return said.program
        case Give() | ChangeMark():
            return said.programs.get(student, "")
        case _:
            return ""


def _item(one: Filed) -> str:
    assert isinstance(one.said, Give)
    return one.said.item


def _of_student(
    student: str,
    records: Sequence[Filed],
    decides: Sequence[Filed],
    program: str | None,
    live: Collection[str],
) -> OfStudent:
    last: dict[tuple[str, str], Filed] = {}  # in one file later takes the place of earlier
    added: list[Filed] = []
    for one in records:
        kind = _kind(one.said)
        if kind is None:
            added.append(one)
        else:
            last[kind, one.grader] = one
    of_mark = [one for one in added if isinstance(one.said, ChangeMark | Excuse | Give)]
    replaced = _replaced(of_mark)
    kept: dict[str, list[Filed]] = defaultdict(list)
    lapsed: list[Filed] = []
    for kind, one in (*(("", one) for one in added), *((k, one) for (k, _), one in last.items())):
        bound = program_in(one.said, student)
        if one.name in replaced:
            continue
        if program is not None and bound and bound != program:
            lapsed.append(one)
        else:
            kept[kind].append(one)
    conflicts: list[Conflict] = []
    mark = mark_of(student, of_mark, {one.name for one in lapsed}, live, decides)
    for about, sides in mark.conflicts:
        found = _conflict(MARK, student, sides)
        conflicts.append(found._replace(id=f"{found.id} {about}") if about else found)

    def of(kind: str) -> Settled:
        found = settled(sorted(kept[kind], key=_place), _content, decides, student)
        if found.sides:
            conflicts.append(_conflict(kind, student, found.sides))
        return found

    extension, finish = of(EXTENSION), of(FINISH)
    named = (one.said.graders for one in kept["assign"] if isinstance(one.said, Assign))
    decided = finish.decided
    return OfStudent(
        tuple(one for one in kept[""] if isinstance(one.said, Comment)),
        mark.given,
        mark.mark,
        mark.changes,
        mark.later,
        extension.kept,
        tuple(sorted({grader for graders in named for grader in graders})),
        tuple(sorted((one for one in last.values() if isinstance(one.said, Finish)), key=_place)),
        None if decided is None else (finish.kept[0], decided),
        tuple(sorted(lapsed, key=_place)),
        tuple(conflicts),
    )


def _replaced(records: Sequence[Filed]) -> set[str]:
    """Return the names of changes and excuses in whose place a later one of their grader is."""
    bases = {one.grader: one.said.number for one in records if is_base(one.said)}  # the last
    return {
        one.name
        for one in records
        if not isinstance(one.said, Give) and one.said.number < bases.get(one.grader, 0)
    }


def _kind(said: Decision) -> str | None:
    """Return what a record is about, where a later one takes its place; None where it adds."""
    match said:
        case Extend():
            return EXTENSION
        case Finish():
            return FINISH
        case Assign():
            return "assign"
        case _:
            return None


def _content(one: Filed) -> Hashable:
    said = one.said
    match said:
        case Extend():
            return datetime.fromisoformat(said.due)
        case Finish():
            return None if said.mark is None else in_tenths(Fraction(said.mark))
        case _:
            return None


def _place(one: Filed) -> tuple[str, int]:
    return one.grader, one.said.number


def _conflict(kind: str, student: str, sides: Sequence[Filed]) -> Conflict:
    return Conflict(f"{kind} {student}", kind, student, _sentence(sides), tuple(sides))


def _of_item(name: str, sides: Sequence[Filed]) -> Conflict:
    return Conflict(f"{ITEM} {name}", ITEM, "", _sentence(sides), tuple(sides))


def _sentence(sides: Sequence[Filed]) -> str:
    return "graders differ: " + "; ".join(_told(sides))


def _told(sides: Sequence[Filed]) -> Iterator[str]:
    for one in sides:
        yield f"{one.who} ({one.name}): {sentence_of(one)}"
