"""One grader at one folder: what is shown, from the files as they are."""

import threading
from hashlib import sha256
from pathlib import Path
from typing import NamedTuple

import msgspec

from vrts.desk.book.book import Book
from vrts.desk.book.shelf import Shelf
from vrts.desk.rows.class_view import Listed
from vrts.desk.told import GraderTold, MarkingTold

_DIGITS = 16  # of a revision


class Shown(NamedTuple):
    """What a grader sees of one state of the folder."""

    book: Book
    listed: Listed
    revision: str  # another one wherever something that is shown differs


class Desk:
    """The desk of one grader. Any thread may ask."""

    def __init__(self, folder: Path, me: GraderTold) -> None:
        """Sit down at a folder.

        Raises:
            CannotRead: There is no such folder, or a file of it cannot be read.
            Refused: It is no marking, or something in it has errors.
        """
        self.me = me
        self._shelf = Shelf(folder)
        self._lock = threading.Lock()
        self._shown = self._show(self._shelf.now())

    def now(self) -> Shown:
        """Return what the files say now."""
        with self._lock:
            book = self._shelf.now()
            if book is not self._shown.book:
                self._shown = self._show(book)
            return self._shown

    def marking(self) -> MarkingTold:
        """Return how far marking again is."""
        return MarkingTold()

    def _show(self, book: Book) -> Shown:
        listed, decided = Listed(book, self.me.id), book.decided
        told = (tuple(listed.rows.values()), *decided[1:], dict(decided.students), book.problems)
        revision = sha256(msgspec.json.encode(told)).hexdigest()[:_DIGITS]
        return Shown(book, listed, revision)
