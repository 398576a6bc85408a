"""The board of a course: a row for each student, a cell for each assignment."""

from collections.abc import Iterable, Mapping, Sequence
from fractions import Fraction
from functools import lru_cache
from typing import NamedTuple

from vrts.course.board.causes import causes_of, foremost, in_a_row
from vrts.course.board.told import (
    AttemptTold,
    BoardTold,
    CellTold,
    ColumnTold,
    StudentTold,
    WaitTold,
    WorkTold,
)
from vrts.live.store.course.attempts import Attempt
from vrts.live.store.course.people import Person

NOTHING = CellTold()


class Column(NamedTuple):
    """What the board has to know of an assignment."""

    id: str
    title: str
    opens: float = 0.0  # Unix time [s]; 0: it is open
    due: float = 0.0  # Unix time [s]; 0: there is no deadline
    best: bool = False  # whether the best attempt counts, and not the last
    marked: bool = False  # whether the course says where its marking is


class Presence(NamedTuple):
    """Who is in which room now, and who waits there."""

    rooms: Mapping[int, str]  # name of the room, by account
    hands: Sequence[WaitTold] = ()


def board(
    title: str,
    columns: Sequence[Column],
    people: Iterable[Person],
    attempts: Iterable[Attempt],
    presence: Presence,
    now: float,
) -> BoardTold:
    """Return the board of a course.

    Args:
        title: Of the course.
        columns: Its assignments.
        people: Of its lists; staff has no row.
        attempts: Of everybody, in the order of time.
        presence: Who is there now.
        now: Unix time [s].
    """
    students = [person for person in people if person.rank == "student"]
    of: dict[int, dict[str, list[Attempt]]] = {one.account: {} for one in students}
    for attempt in attempts:
        if attempt.account in of:
            of[attempt.account].setdefault(attempt.assignment, []).append(attempt)
    rows = [
        StudentTold(
            one.account,
            one.name,
            one.key,
            one.team,
            one.listed,
            presence.rooms.get(one.account, ""),
            tuple(_cell(of[one.account].get(column.id, ()), column) for column in columns),
        )
        for one in students
        if one.listed or of[one.account]  # who has left without handing in has no row
    ]
    told = tuple(_column(column, k, rows, of) for k, column in enumerate(columns))
    causes = [
        cause
        for column in columns
        for cause in causes_of(
            {who: mine.get(column.id, ()) for who, mine in of.items()}, column.id
        )
    ]
    waits = (*presence.hands, *_for_marks(students, of))
    waiting = tuple(sorted(waits, key=lambda one: (one.why != "hand", one.since, one.id)))
    return BoardTold(title, now, told, tuple(rows), tuple(causes), waiting)


def work_of(person: Person, attempts: Iterable[Attempt]) -> WorkTold:
    """Return everything that somebody has handed in, in the order of time."""
    told = tuple(
        AttemptTold(
            one.assignment,
            one.number,
            one.at,
            one.state,
            _points(one.mark),
            _points(one.total) or 0.0,
            one.late,
            tuple((loss.cause, round(float(Fraction(loss.points)), 1)) for loss in one.causes),
        )
        for one in attempts
    )
    return WorkTold(person.account, person.name, told)


def counting(attempts: Sequence[Attempt], *, best: bool) -> Attempt | None:
    """Return the attempt whose mark counts, as far as the public checks tell; None: there is none.

    Of equally good ones the first counts, as in `vrts.marking.lateness.best`.
    """
    marked = [one for one in attempts if one.mark is not None]
    if not marked:
        return None
    return max(marked, key=lambda one: _points(one.mark) or 0.0) if best else marked[-1]


def _cell(attempts: Sequence[Attempt], column: Column) -> CellTold:
    if not attempts:
        return NOTHING
    last = attempts[-1]
    counts = counting(attempts, best=column.best)
    marked = next((one for one in reversed(attempts) if one.state == "marked"), None)
    cause = "" if marked is None else foremost(marked)
    return CellTold(
        len(attempts),
        None if counts is None else _points(counts.mark),
        _points(last.mark),
        last.at,
        last.state,
        last.late,
        cause,
        in_a_row(attempts, cause) if cause else 0,
    )


def _column(
    column: Column,
    k: int,
    rows: Sequence[StudentTold],
    of: Mapping[int, Mapping[str, Sequence[Attempt]]],
) -> ColumnTold:
    totals = (one.total for mine in of.values() for one in mine.get(column.id, ()) if one.total)
    total = _points(next(totals, None)) or 0.0
    marks = [row.cells[k].mark for row in rows if row.cells[k].mark is not None]
    given = [mark for mark in marks if mark is not None]
    return ColumnTold(
        column.id,
        column.title,
        column.opens,
        column.due,
        total,
        "best" if column.best else "latest",
        sum(row.cells[k].tries > 0 for row in rows),
        sum(total > 0.0 and mark >= total for mark in given),
        round(sum(given) / len(given), 2) if given else None,
        column.marked,
    )


def _for_marks(
    students: Iterable[Person], of: Mapping[int, Mapping[str, Sequence[Attempt]]]
) -> list[WaitTold]:
    """Return who waits for a mark."""
    return [
        WaitTold(one.account, one.name, "marking", attempt.at, "", attempt.assignment)
        for one in students
        for mine in of[one.account].values()
        for attempt in mine
        if attempt.state == "waiting"
    ]


@lru_cache(maxsize=1024)
def _points(text: str | None) -> float | None:
    """Return points as JSON has them: marks are multiples of a tenth."""
    return None if text is None else round(float(Fraction(text)), 2)
