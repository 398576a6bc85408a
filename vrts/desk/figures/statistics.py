"""A class in numbers."""

from collections import defaultdict
from collections.abc import Iterable, Sequence
from statistics import fmean, median
from typing import Final

from msgspec.structs import replace

from vrts.desk.book.book import Book
from vrts.desk.figures.bars import bars
from vrts.desk.figures.discrimination import discrimination
from vrts.desk.figures.told import (
    AttemptFigures,
    CheckFigures,
    Double,
    GraderFigures,
    Statistics,
)
from vrts.desk.told import CauseTold
from vrts.marking.result import Check
from vrts.marking.row import Row

BARS: Final = 10  # of marks
CHECK_BARS: Final = 5
MOST_CAUSES: Final = 100
_SMALL: Final = 1e-9  # points


def statistics(book: Book, causes: Sequence[CauseTold]) -> Statistics:
    """Return the statistics of a class; who is excused, or has no mark, counts in none of them.

    Args:
        book: The state.
        causes: Of the class, the commonest first.
    """
    rows = book.rows.rows
    marks = [row.final for row in rows if row.final is not None and not _excused(book, row)]
    return Statistics(
        bars(marks, 0.0, float(book.rows.total), BARS),
        _mean(marks),
        _median(marks),
        tuple(_checks(rows)),
        tuple(_causes(book, causes))[:MOST_CAUSES],
        tuple(_attempts(book)),
        tuple(_progress(book)),
        tuple(_graders(book)),
        tuple(_double(book)),
    )


def _causes(book: Book, causes: Sequence[CauseTold]) -> Iterable[CauseTold]:
    """Yield causes without those who are excused."""
    excused = {row.id for row in book.rows.rows if _excused(book, row)}
    for one in causes:
        left = tuple(student for student in one.students if student not in excused)
        if left:
            yield replace(one, count=len(left), students=left)


def _excused(book: Book, row: Row) -> bool:
    return book.decided.of(row.id).excused


def _checks(rows: Sequence[Row]) -> Iterable[CheckFigures]:
    found: dict[str, list[tuple[Check, float]]] = defaultdict(list)
    for row in rows:
        whole = sum(check.points for check in row.result.checks)
        for check in row.result.checks:
            found[check.id].append((check, whole - check.points))
    for name, made in found.items():
        points = [check.points for check, _ in made]
        most = max(check.most for check, _ in made)
        yield CheckFigures(
            name,
            made[0][0].title,
            most,
            len(made),
            round(fmean(points), 4),
            sum(check.points > check.most - _SMALL for check, _ in made),
            sum(_got_nothing(check) for check, _ in made),
            discrimination(points, [others for _, others in made]),
            bars(points, min(0.0, *points), max(most, *points), CHECK_BARS),
        )


def _got_nothing(check: Check) -> bool:
    """Return whether a check earned nothing, or, where it can only cost, cost something."""
    return check.points < _SMALL if check.most else check.points < -_SMALL


def _attempts(book: Book) -> Iterable[AttemptFigures]:
    found: dict[int, list[float]] = defaultdict(list)
    for row in book.rows.rows:
        if row.final is None or _excused(book, row) or not row.handed_in.file:
            continue
        found[len(book.attempts_of(row))].append(row.final)
    for number in sorted(found):
        marks = found[number]
        yield AttemptFigures(number, len(marks), _mean(marks), _median(marks))


def _progress(book: Book) -> Iterable[AttemptFigures]:
    """Yield the marks of attempts by their number, where those of a student were all marked."""
    if not any(row.handed_in.attempts for row in book.rows.rows):
        return
    found: dict[int, list[float]] = defaultdict(list)
    for row in book.rows.rows:
        tried = book.attempts_of(row)
        if _excused(book, row) or (len(tried) > 1 and not row.handed_in.attempts):
            continue
        for number, one in enumerate(tried, 1):
            if one.mark is not None:
                found[number].append(one.mark)
    for number in sorted(found):
        marks = found[number]
        yield AttemptFigures(number, len(marks), _mean(marks), _median(marks))


def _graders(book: Book) -> Iterable[GraderFigures]:
    assigned: dict[str, int] = defaultdict(int)
    finished: dict[str, list[float | None]] = defaultdict(list)
    for mine in book.decided.students.values():
        for who in mine.assigned:
            assigned[who] += 1
        for one in mine.finished:
            finished[one.who].append(one.mark)
    known = {grader.id for grader in book.decided.graders}
    for who in sorted({*assigned, *finished, *known}):
        given = [mark for mark in finished[who] if mark is not None]
        yield GraderFigures(who, assigned[who], len(finished[who]), _mean(given))


def _double(book: Book) -> Iterable[Double]:
    """Yield rows that several graders have finished, those first on which they differ most."""
    found: list[Double] = []
    for student, mine in book.decided.students.items():
        marks = {one.who: one.mark for one in mine.finished if not one.stale}
        if len(marks) < 2:
            continue
        given = [mark for mark in marks.values() if mark is not None]
        both = len(given) == len(marks)
        apart = round(max(given) - min(given), 4) if both else None
        found.append(Double(student, marks, apart))
    return sorted(found, key=lambda one: (-(one.difference or 0.0), one.student))


def _mean(values: Sequence[float]) -> float | None:
    return round(fmean(values), 4) if values else None


def _median(values: Sequence[float]) -> float | None:
    return round(median(values), 4) if values else None
