"""One grader at one folder: what is shown, from the files as they are, and what is added."""

import threading
from collections.abc import Callable
from datetime import UTC, datetime
from hashlib import sha256
from pathlib import Path
from typing import NamedTuple

import msgspec

from vrts.desk.adding.asked import (
    Body,
    Rests,
    completed,
    records_of,
    require_present,
    require_seen,
    rests_on,
)
from vrts.desk.adding.facts import Facts, Remembered, changed_rows, facts_of
from vrts.desk.book.book import Book
from vrts.desk.book.shelf import Shelf
from vrts.desk.rows.class_view import Listed
from vrts.desk.told import AddedTold, GraderTold, RowTold
from vrts.live.lasting.clock import wall
from vrts.marking.by_hand.decisions.files import add_decisions, locked

LOCK = ".desk.lock"  # in the folder of decisions: one desk adds at a time
_DIGITS = 16  # of a revision


class Shown(NamedTuple):
    """What a grader sees of one state of the folder."""

    book: Book
    listed: Listed
    revision: str  # another one wherever something that is shown differs


class Moved(Exception):  # noqa: N818 -- names the situation
    """What decisions rest on has changed since it was shown; the text says what."""


class Desk:
    """The desk of one grader. Any thread may ask."""

    def __init__(self, folder: Path, me: GraderTold) -> None:
        """Sit down at a folder.

        Raises:
            CannotRead: There is no such folder, or a file of it cannot be read.
            Refused: It is no marking, or something in it has errors.
        """
        self.me = me
        self._shelf = Shelf(folder, me.id)
        self._lock = threading.Lock()
        self._adding = threading.Lock()
        self._remembered = Remembered()
        self._shown = self._show(self._shelf.now())

    def now(self) -> Shown:
        """Return what the files say now."""
        with self._lock:
            book = self._shelf.now()
            if book is not self._shown.book:
                self._shown = self._show(book)
            return self._shown

    def add(self, body: Body, added: Callable[[], None] = lambda: None) -> AddedTold:
        """Write decisions: all of them, or none. They are on the disk when this returns.

        Args:
            body: As the page sent it.
            added: Called as soon as they are written.

        Raises:
            Moved: What they rest on has changed since it was shown.
            Refused: They are no decisions, or cannot be written.
            CannotRead: A file cannot be read.
            OSError: The folder cannot be written.
        """
        asked = records_of(body)
        folder = self.now().book.opened.layout.decisions
        with self._adding, locked(folder, LOCK):  # so that what was looked at still holds
            before = self.now()
            require_present(before.book)
            if body.again and body.expect != before.revision:
                raise Moved("something was decided since, perhaps this: look at the history")
            shown = self._remembered.of(body.expect)
            if shown is None:
                raise Moved("the page is out of date: load it again")
            _require_still(rests_on(asked), shown, facts_of(before.book))
            require_seen(asked, before.book.seen.hidden)
            said = completed(asked, shown)
            now = datetime.fromtimestamp(wall(), UTC).astimezone()
            total = before.book.rows.total
            made = add_decisions(folder, self.me.name, said, now, total)
        if made.grader.id != self.me.id:  # somebody whose name looks alike began meanwhile
            self.me = GraderTold(made.grader.id, made.grader.name)
            self._shelf.seen_by(self.me.id)
        added()
        after = self.now()
        return AddedTold(
            after.revision,
            tuple(one.name for one in made.records),
            tuple(_changed(before.listed.rows, after.listed.rows)),
            after.book.decided.items,
            after.book.decided.conflicts,
        )

    def _show(self, book: Book) -> Shown:
        listed, decided = Listed(book, self.me.id), book.decided
        told = (tuple(listed.rows.values()), *decided[1:], dict(decided.students), book.problems)
        revision = sha256(msgspec.json.encode(told)).hexdigest()[:_DIGITS]
        self._remembered.keep(revision, book)
        return Shown(book, listed, revision)


def _require_still(rests: Rests, shown: Facts, now: Facts) -> None:
    """Check that what was shown still holds.

    Raises:
        Moved: It does not.
    """
    students = changed_rows(shown, now, rests.students)
    if students:
        others = f" and {len(students) - 1} more" if len(students) > 1 else ""
        raise Moved(f"the mark of `{students[0]}`{others} has changed: look again")
    for item in rests.items:
        if shown.items.get(item) != now.items.get(item):
            raise Moved(f"the rubric item `{item}` has changed: look again")
    for record in rests.records:
        if (record in shown.undone) != (record in now.undone):
            raise Moved(f"the decision {record} has been undone or made again: look again")


def _changed(before: "dict[str, RowTold]", after: "dict[str, RowTold]") -> "list[RowTold]":
    """Return the rows of which more has changed than their place in the list."""
    return [
        row
        for name, row in after.items()
        if name not in before
        or msgspec.structs.replace(before[name], order=row.order, why_next=row.why_next) != row
    ]
