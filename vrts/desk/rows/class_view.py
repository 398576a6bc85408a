"""The first screen: all rows, in short."""

from fractions import Fraction

from vrts.desk.book.book import Book, found_out
from vrts.desk.book.decided import Mine
from vrts.desk.rows.causes import causes_of, keys_of
from vrts.desk.rows.order import Place, places
from vrts.desk.told import CauseTold, Doubted, RowTold
from vrts.marking.exports.numbers import number
from vrts.marking.exports.steps import steps
from vrts.marking.result import Kind
from vrts.marking.row import Row

_MORE = 500  # characters of a sentence in the list


class Listed:
    """The rows and causes of one state of the folder, for one grader."""

    def __init__(self, book: Book, me: str) -> None:
        """Make the list.

        Args:
            book: The state.
            me: Id of whoever asks.
        """
        self.causes: tuple[CauseTold, ...] = causes_of(book.rows.rows)
        where = places(book, self.causes, me)
        self.rows = {row.id: _row(book, row, where[row.id]) for row in book.rows.rows}


def _row(book: Book, row: Row, place: Place) -> RowTold:
    result, mine = found_out(row), book.decided.of(row.id)
    late = row.late
    return RowTold(
        row.id,
        row.student.name,
        row.final,
        result.mark,
        result.total,
        row.result.kind.value,
        tuple(Doubted(doubt.reason.value, doubt.sentence[:_MORE]) for doubt in row.unsafe),
        result.ready,
        result.cause[:_MORE],
        result.line,
        result.time_s,
        keys_of(result),
        "" if late is None else late.sentence,
        _lost_by_lateness(row),
        mine.due,
        book.likeness.get(row.id),
        mine.assigned,
        mine.finished,
        len(mine.comments),
        _items(mine),
        _change(row),
        row.result.kind is Kind.EXCUSED,
        mine.conflict,
        has_report(row),
        place.order,
        place.why,
        mine.set_by,
        book.decided.alone.get(row.id, row.final),
        row.id in book.seen.alone,
        mine.otherwise,
    )


def has_report(row: Row) -> bool:
    """Return whether marking made a page about a row, where it made pages."""
    return found_out(row).program is not None


def _items(mine: Mine) -> tuple[str, ...]:
    return tuple(dict.fromkeys(one.item for one in mine.given))


def _change(row: Row) -> float | None:
    """Return what people changed, together; None where nobody did."""
    if row.change is None:
        return None
    by_hand = (step.points for step in steps(row)[_late_steps(row) :])
    return float(number(sum(by_hand, start=Fraction(0))))


def _lost_by_lateness(row: Row) -> float:
    late = (step.points for step in steps(row)[: _late_steps(row)])
    return float(number(-sum(late, start=Fraction(0))))


def _late_steps(row: Row) -> int:
    """Return how many of the steps are lateness; they come first."""
    return 0 if row.late is None or row.late.review else 1
