"""A class with all decisions of all graders, from the files as they are."""

from collections.abc import Iterator, Mapping
from typing import NamedTuple

from vrts.desk.book.alone import Seen, seen_by, shared_rows
from vrts.desk.book.book import found_out
from vrts.desk.book.decided import Decided, Mine, told_of
from vrts.desk.book.double import agreed_otherwise, looked_again, marks_alone
from vrts.desk.book.opened import Opened
from vrts.desk.told import ConflictTold
from vrts.marking.by_hand.by_hand import ByHand, load_by_hand, rows_by_hand
from vrts.marking.by_hand.decisions.state import State, prepared, state_of
from vrts.marking.by_hand.overrides import program_of
from vrts.marking.row import Class


class Deciding(NamedTuple):
    """A class, what graders decided, and what could not be read of it."""

    rows: Class
    decided: Decided
    problems: tuple[str, ...]
    seen: Seen  # what of it whoever looks may see: the rest is of it, too


def decide(opened: Opened, me: str) -> Deciding:
    """Return a class with all decisions that a grader may see.

    Args:
        opened: What marking wrote.
        me: Id of whoever looks.

    Raises:
        CannotRead: A file cannot be read.
        Refused: A file has errors.
    """
    known = [row.id for row in opened.rows.rows]
    late = None if opened.about.late is None else opened.about.late.rules
    by_hand = load_by_hand(opened.layout, known, opened.rows.total, late)
    programs = {row.id: program_of(found_out(row)) for row in opened.rows.rows}
    seen = seen_by(by_hand.ledger, me, programs)
    mine = by_hand
    if seen.alone:
        mine = by_hand._replace(ledger=seen.ledger, graders=prepared(seen.ledger))
    rows = rows_by_hand(opened.rows, mine)
    state = state_of(seen.ledger, programs)
    headlines = (one.headline for one in by_hand.diagnostics)
    problems = tuple(text for text in headlines if text.split(" ", 1)[0] not in seen.hidden)
    told = _with_file(told_of(seen.ledger, state, programs, me), rows)
    told = _with_marks(told, rows, state, by_hand, programs, me)
    return Deciding(rows, told, problems, seen)


def _with_marks(
    told: Decided,
    rows: Class,
    state: State,
    by_hand: ByHand,
    programs: Mapping[str, str],
    me: str,
) -> Decided:
    """Return decisions that tell who would give another mark now than they finished with."""
    shared = shared_rows(by_hand.ledger, programs)
    by_id = {row.id: row for row in rows.rows}
    alone = marks_alone(by_id, by_hand, shared, me)
    names = by_hand.ledger.names

    def made() -> Iterator[tuple[str, Mine]]:
        for student, mine in told.students.items():
            if not mine.finished or state.of(student).preferred is not None:
                yield student, mine
                continue
            final = by_id[student].final
            now = looked_again(mine, final, alone.get(student, {}))
            if student in shared:
                sentence = agreed_otherwise(mine, final, shared[student], names)
                now = now._replace(otherwise=sentence)
            yield student, now

    marks = {student: found[me] for student, found in alone.items() if me in found}
    return told._replace(students=dict(made()), alone=marks)


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
