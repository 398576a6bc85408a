"""What decisions rest on, remembered of the last states: so that none is about what has changed."""

from collections import OrderedDict
from collections.abc import Iterable, Mapping
from typing import Final, NamedTuple

from vrts.desk.book.book import Book, found_out
from vrts.marking.by_hand.overrides import program_of

KEPT: Final = 32  # states


class Fact(NamedTuple):
    """What was shown of a row that a decision may rest on."""

    mark: tuple[object, ...]  # final mark, and what it is made of
    program: str  # sha256, or `none`


class Facts(NamedTuple):
    """The same of a class."""

    rows: Mapping[str, Fact]
    items: Mapping[str, str]  # version by id
    undone: frozenset[str]  # names of records


class Remembered:
    """The facts of the last states, by revision."""

    def __init__(self) -> None:
        """Remember nothing."""
        self._kept: OrderedDict[str, Facts] = OrderedDict()

    def keep(self, revision: str, book: Book) -> None:
        """Remember a state."""
        self._kept[revision] = facts_of(book)
        self._kept.move_to_end(revision)
        if len(self._kept) > KEPT:
            self._kept.popitem(last=False)

    def of(self, revision: str) -> Facts | None:
        """Return the facts of a state; None where it is too long ago, or of another desk."""
        return self._kept.get(revision)


def facts_of(book: Book) -> Facts:
    """Return what decisions may rest on."""
    rows: dict[str, Fact] = {}
    undone: set[str] = set()
    for row in book.rows.rows:
        mine = book.decided.of(row.id)
        doubts = tuple(doubt.reason for doubt in row.unsafe)
        mark = (
            row.final,
            None if row.change is None else row.change.delta,  # also where the mark ends at a bound
            row.result.mark,
            row.result.kind,
            doubts,
            mine.excused,
            mine.conflict,
        )
        rows[row.id] = Fact(mark, program_of(found_out(row)))
        undone |= {one.record for one in mine.history if one.undone_by is not None}
    items = {item.id: item.version for item in book.decided.items if item.version}
    return Facts(rows, items, frozenset(undone))


def changed_rows(then: Facts, now: Facts, students: Iterable[str]) -> list[str]:
    """Return the students whose marks or programs are not what they were."""
    return [name for name in students if then.rows.get(name) != now.rows.get(name)]
