"""Reads the folder again whenever a file of it has changed, and only then."""

import os
import threading
from collections.abc import Iterator
from pathlib import Path
from typing import Final

from vrts.desk.book.attempts import read_attempts
from vrts.desk.book.book import Book
from vrts.desk.book.deciding import decide
from vrts.desk.book.likeness import LARGEST, read_likeness
from vrts.desk.book.opened import Opened, open_marking
from vrts.desk.told import Likeness
from vrts.marking import about
from vrts.marking.result import Damaged
from vrts.marking.similarity.files import DATA
from vrts.pipeline.files import CannotRead
from vrts.pipeline.refused import Refused
from vrts.report.plain import capital

DECISIONS: Final = "decisions"  # folder in `staff`
MOST_FILES: Final = 400  # looked at in it

Sign = tuple[str, int, int, int]  # name, time [ns], size, number of the file


class Shelf:
    """A folder of a marking, and the last that was read of it. Any thread may ask."""

    def __init__(self, folder: Path, me: str) -> None:
        """Take a folder, and read it as a grader of that id sees it.

        Raises:
            CannotRead: There is no such folder, or a file of it cannot be read.
            Refused: It is no marking, or something in it has errors.
        """
        self.folder = folder
        self._me = me
        self._staff = folder / "staff"
        self._lock = threading.Lock()
        self._likeness: dict[str, Likeness] = {}
        self._said = ""
        self._read = list(self._look())  # of each part, the files that were read last
        self._looked: tuple[tuple[Sign, ...], ...] = tuple(self._read)  # all of it was read
        self._opened = open_marking(folder)
        self._attempts = read_attempts(self._opened.layout)
        self._read_likeness()
        self._book = self._decided()

    def now(self) -> Book:
        """Return what the files say now.

        What cannot be read any more is told in the book, beside what was read before.
        """
        with self._lock:
            signs = self._look()
            if signs == self._looked:
                return self._book
            self._looked = ()  # what cannot be read is tried again, until all of it was read
            try:
                if signs[0] != self._read[0]:
                    self._opened = open_marking(self.folder)
                    self._attempts = read_attempts(self._opened.layout)
                    self._read[0] = signs[0]
                if signs[1] != self._read[1]:
                    self._read_likeness()
                    self._read[1] = signs[1]
                self._book = self._decided()
                self._looked = signs
            except (CannotRead, Refused) as problem:
                self._keep_with(sentence(problem))
            except OSError as problem:
                self._keep_with(f"the folder cannot be read: {problem.strerror or problem}")
            return self._book

    def _keep_with(self, problem: str) -> None:
        """Keep what was read last, and tell why it is not what the files say now."""
        last, told = self._book, (f"what is shown may be old: {problem}",)
        if last.problems != told:
            self._book = Book(
                last.opened,
                last.rows,
                last.decided,
                last.likeness,
                last.attempts,
                told,
                last.seen,
                old=True,
            )

    def seen_by(self, me: str) -> None:
        """Look with the eyes of a grader of another id from now on."""
        with self._lock:
            self._me = me
            self._book = self._decided()

    def _decided(self) -> Book:
        opened: Opened = self._opened
        rows, decided, told, seen = decide(opened, self._me)
        said = (self._said,) if self._said else ()
        problems = (*told, *said)
        return Book(opened, rows, decided, self._likeness, self._attempts, problems, seen)

    def _read_likeness(self) -> None:
        self._said, self._likeness = "", {}
        place = self._staff / DATA
        if not place.is_file():
            return
        try:
            if place.stat().st_size > LARGEST:
                raise Damaged(f"`{DATA}` has more than {LARGEST:,} bytes")
            self._likeness = dict(read_likeness(place.read_bytes()))
        except (OSError, Damaged) as problem:
            self._said = f"likeness is not shown: {problem}"

    def _look(self) -> tuple[tuple[Sign, ...], ...]:
        """Return what tells whether files have changed: of marking, likeness, decisions."""
        marked = (self._staff / name for name in ("results.json", about.NAME, "intake.csv"))
        by_hand = (self._staff / "overrides.toml", *_in(self._staff / DECISIONS))
        return (
            tuple(_signs(marked)),
            tuple(_signs([self._staff / DATA])),
            tuple(_signs(by_hand)),
        )


def _in(folder: Path) -> Iterator[Path]:
    try:
        with os.scandir(folder) as entries:
            names = sorted(entry.name for entry in entries if not entry.name.startswith("."))
    except OSError:
        return
    for name in names[:MOST_FILES]:
        if not name.endswith(".part"):
            yield folder / name


def _signs(paths: "Iterator[Path] | tuple[Path, ...] | list[Path]") -> Iterator[Sign]:
    for path in paths:
        try:
            found = path.stat()
        except OSError:
            continue
        yield path.name, found.st_mtime_ns, found.st_size, found.st_ino


def sentence(problem: CannotRead | Refused) -> str:
    """Return what is wrong, and what to do about it, in one line."""
    if not isinstance(problem, Refused):
        return problem.message
    wrong = [one for one in problem.diagnostics if one.is_error]
    remedies = dict.fromkeys(one.help[0] for one in wrong if one.help)
    return ". ".join(("; ".join(one.headline for one in wrong), *map(capital, remedies)))
