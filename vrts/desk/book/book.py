"""The state of a marking at one moment, as a value: rows, decisions, likeness."""

from collections.abc import Mapping
from functools import cached_property

from msgspec.structs import replace

from vrts.desk.book.alone import Seen
from vrts.desk.book.decided import Decided
from vrts.desk.book.opened import Opened
from vrts.desk.told import Attempt, Likeness
from vrts.marking.by_hand.decisions.ledger import NONE
from vrts.marking.result import Result
from vrts.marking.row import Class, Row

ALL = Seen(NONE)  # nothing is hidden


class Book:
    """What the files said when they were read; nothing in it changes."""

    def __init__(
        self,
        opened: Opened,
        rows: Class,
        decided: Decided,
        likeness: Mapping[str, Likeness],
        attempts: Mapping[str, tuple[Attempt, ...]],
        problems: tuple[str, ...] = (),
        seen: Seen = ALL,
        *,
        old: bool = False,
    ) -> None:
        """Take what was read.

        Args:
            opened: What marking wrote.
            rows: The class with all decisions.
            decided: What graders decided.
            likeness: By id.
            attempts: By id, of those who handed in several times.
            problems: What could not be read, in sentences.
            seen: What of the decisions whoever looks may see; `rows` and `decided` are of that.
            old: Whether files say something else now, which cannot be read.
        """
        self.opened = opened
        self.rows = rows
        self.decided = decided
        self.likeness = likeness
        self.attempts = attempts
        self.problems = problems
        self.seen = seen
        self.old = old

    @cached_property
    def by_id(self) -> Mapping[str, Row]:
        """The rows of the class, by id."""
        return {row.id: row for row in self.rows.rows}

    def attempts_of(self, row: Row) -> tuple[Attempt, ...]:
        """Return what a student handed in, with the computed mark where it was marked."""
        if row.handed_in.attempts:
            told = row.handed_in.attempts
            return tuple(Attempt(one.received, one.mark, one.file) for one in told)
        file = row.handed_in.file
        if not file:
            return ()
        one = (Attempt(row.handed_in.received, None, file),)
        return tuple(
            replace(told, mark=found_out(row).mark) if told.file == file else told
            for told in self.attempts.get(row.id, one)
        )


def found_out(row: Row) -> Result:
    """Return what was found out about a submission, also where the student is excused."""
    held = None if row.decided is None else row.decided.result
    return held or row.result
