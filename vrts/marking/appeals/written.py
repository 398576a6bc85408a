"""What an earlier marking has written: rows, how it was marked, and what is decided by hand."""

import os
from difflib import get_close_matches
from pathlib import Path
from typing import NamedTuple

from vrts.base.diagnostic import Rule, error
from vrts.check.task.late_rules import LateRules
from vrts.marking import about
from vrts.marking.about import About
from vrts.marking.by_hand.by_hand import ByHand, load_by_hand
from vrts.marking.layout import FORGETTING, Layout
from vrts.marking.privacy.pseudonyms import read_names, with_names
from vrts.marking.result import Damaged
from vrts.marking.row import LARGEST, Class, Row, class_from_bytes
from vrts.pipeline.files import CannotRead, read_bytes
from vrts.pipeline.refused import Refused

NO_MARKING = Rule("V760", "no-marking")
NOBODY = Rule("V761", "nobody-of-that-name")

LARGEST_ABOUT = 4_000_000  # bytes


class Written(NamedTuple):
    """The output of a marking."""

    layout: Layout
    rows: Class
    about: About

    @property
    def known(self) -> tuple[str, ...]:
        """The identifiers of the class."""
        return tuple(row.id for row in self.rows.rows)

    def by_hand(self) -> ByHand:
        """Return what is decided by hand as it is now.

        Raises:
            Refused: A file has errors.
        """
        late = None if self.about.late is None else self.about.late.rules
        return load_by_hand(self.layout, self.known, self.rows.total, late)

    def row(self, wanted: str) -> Row:
        """Return the row of a student, by id, or by anything else that only one of them has.

        Raises:
            Refused: There is none, or more than one.
        """
        found = self.rows_called(wanted)
        if len(found) == 1:
            return found[0]
        if found:
            remedy = f"write the id: {', '.join(f'`{row.id}`' for row in found[:5])}"
            headline = f"{len(found)} students of this class are called `{wanted}`"
        else:
            close = get_close_matches(wanted, self.known, 1, 0.6)
            part = wanted.casefold()
            inside = [name for name in self.known if part and part in name.casefold()]
            meant = ", ".join(f"`{name}`" for name in (close or inside[:5]))
            remedy = f"did you mean {meant}?" if meant else "write the id, as in `intake.csv`"
            headline = f"there is no student `{wanted}` in this class"
        raise Refused((error(NOBODY, headline, help=(remedy,)),))

    def rows_called(self, wanted: str) -> list[Row]:
        """Return the row of that id, else those of everybody with that name or address."""
        rows = self.rows.rows
        found = [row for row in rows if row.id == wanted]
        if not found:  # who has a pseudonym may be asked for by name
            named = with_names(self.rows, self.layout).rows
            called = {row.id for row in named if wanted.casefold() in _names(row)}
            known = read_names(self.layout)
            called |= {name for name, line in known.items() if line.get("id") == wanted}
            found = [row for row in rows if row.id in called]
        return found


def read_written(folder: Path) -> Written:
    """Return what a marking wrote into a folder.

    Raises:
        Refused: No marking has been written there, or not by this vrts.
    """
    layout = Layout(folder)
    if os.path.lexists(layout.staff / FORGETTING):
        why = "forgetting a student was interrupted: the same call of `vrts purge` ends it"
        raise no_marking(folder, why)
    try:
        how = about.from_bytes(_read(layout.staff / about.NAME, folder, LARGEST_ABOUT))
    except Damaged as problem:
        raise no_marking(folder, f"`{about.NAME}` is not as vrts writes it") from problem
    if how.finished is None:
        raise no_marking(folder, "it goes on, or was interrupted: the same call goes on")
    return Written(layout, read_class(layout.results, folder), how)


def late_rules(layout: Layout) -> LateRules | None:
    """Return what lateness cost in a marking; None: nothing, or it does not tell."""
    try:
        told = about.from_bytes(read_bytes(layout.staff / about.NAME)).late
    except (CannotRead, Damaged):
        return None
    return None if told is None else told.rules


def read_class(path: Path, shown: Path | None = None) -> Class:
    """Return the rows in a file; `shown` is what the marking is called.

    Raises:
        Refused: It is not there, or not as this vrts writes it.
    """
    try:
        return class_from_bytes(_read(path, shown or path, LARGEST))
    except Damaged as problem:
        headline = f"`{path.name}` is not as this vrts writes it: {problem}"
        raise no_marking(shown or path, headline) from problem


def _read(path: Path, shown: Path, most: int) -> bytes:
    try:
        if path.stat().st_size > most:
            raise no_marking(shown, f"`{path.name}` has more than {most:,} bytes")
        return read_bytes(path)
    except (OSError, CannotRead) as problem:
        raise no_marking(shown, f"`{path.name}` cannot be read") from problem


def no_marking(shown: Path, why: str) -> Refused:
    """Return that a folder cannot be used as the output of a marking."""
    headline = f"`{shown}` holds no complete marking of a class"
    remedy = (
        "name the folder that was given to `vrts grade` with `-o`; mark again if it ended early"
    )
    return Refused((error(NO_MARKING, headline, notes=(why,), help=(remedy,)),))


def _names(row: Row) -> set[str]:
    student = row.student
    named = {student.name, student.email, student.login, *student.ids.values()}
    return {name.casefold() for name in named if name}
