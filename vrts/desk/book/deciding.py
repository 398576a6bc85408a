"""A class with all decisions of all graders, from the files as they are."""

from typing import NamedTuple

from vrts.desk.book.book import found_out
from vrts.desk.book.decided import Decided, told_of
from vrts.desk.book.opened import Opened
from vrts.desk.told import ConflictTold
from vrts.marking.by_hand.by_hand import ByHand, load_by_hand, rows_by_hand
from vrts.marking.by_hand.decisions.state import state_of
from vrts.marking.by_hand.overrides import program_of
from vrts.marking.row import Class


class Deciding(NamedTuple):
    """A class, what graders decided, and what could not be read of it."""

    rows: Class
    decided: Decided
    problems: tuple[str, ...]


def decide(opened: Opened, me: str) -> Deciding:
    """Return a class with all decisions.

    Args:
        opened: What marking wrote.
        me: Id of whoever looks.

    Raises:
        CannotRead: A file cannot be read.
        Refused: A file has errors.
    """
    rows, by_hand = decided_now(opened)
    programs = {row.id: program_of(found_out(row)) for row in opened.rows.rows}
    state = state_of(by_hand.ledger, programs)
    problems = tuple(one.headline for one in by_hand.diagnostics)
    told = told_of(by_hand.ledger, state, programs, me)
    return Deciding(rows, _with_file(told, rows), problems)


def decided_now(opened: Opened) -> tuple[Class, ByHand]:
    """Return a class with all that people have decided, and what that is.

    Raises:
        CannotRead: A file cannot be read.
        Refused: A file has errors.
    """
    known = [row.id for row in opened.rows.rows]
    late = None if opened.about.late is None else opened.about.late.rules
    by_hand = load_by_hand(opened.layout, known, opened.rows.total, late)
    return rows_by_hand(opened.rows, by_hand), by_hand


def _with_file(decided: Decided, rows: Class) -> Decided:
    """Return decisions with what contradicts `overrides.toml`, which is no grader's file."""
    students = dict(decided.students)
    conflicts = list(decided.conflicts)
    for row in rows.rows:
        sentences = () if row.decided is None else row.decided.conflicts
        mine = decided.of(row.id)
        if not sentences or mine.conflict:
            continue
        students[row.id] = mine._replace(conflict=True)
        conflicts.append(ConflictTold(f"file {row.id}", "file", row.id, sentences[-1], ()))
    return decided._replace(students=students, conflicts=tuple(conflicts))
