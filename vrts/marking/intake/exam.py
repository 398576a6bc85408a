"""Which hand-ins of an exam count: those that came while it was open, and of these the first."""

from collections.abc import Sequence
from dataclasses import replace
from datetime import datetime
from typing import NamedTuple

from vrts.base.diagnostic import Diagnostic, Rule, warning
from vrts.check.task.late_rules import LateRules
from vrts.marking.intake.layouts.canvas import called_by_canvas
from vrts.marking.intake.row import Attempt, Kind, Row
from vrts.marking.intake.tree.file_names import copy_of, same_name

NOT_COUNTED = Rule("V879", "exam-hand-ins")

SHOWN = 20  # students named in a warning
LATEST_IS_NONE = "the latest hand-in is no program, and does not count"
SAME_SECOND = "two came in the same second, and by their names one of them was taken for the first"
UNKNOWN_ORDER = "nothing tells when each came, so which came first is not known"


class Counted(NamedTuple):
    """Rows with the hand-ins that count, and what is told about the others."""

    rows: tuple[Row, ...]
    warnings: tuple[Diagnostic, ...]


class _Sorted(NamedTuple):
    """The hand-ins of a student."""

    inside: tuple[Attempt, ...]  # those that count
    early: int
    late: int
    more: int  # in time, and beyond those that count
    at_once: bool  # the first of these came in the same second as the last one that counts


def counted(found: Sequence[Row], rules: LateRules | None) -> Counted:
    """Return the rows with the attempts that count, and the latest of these as the file.

    A student of whom nothing came in time keeps the hand-in that there is: it gets 0, and says
    why. Where the times of several hand-ins are not known, none is taken as known.

    Args:
        found: Rows of the intake, with all attempts.
        rules: Of the task; all counts where it is no exam.
    """
    if rules is None or rules.opens is None:
        return Counted(tuple(found), ())
    rows: list[Row] = []
    told: list[str] = []
    for row in found:
        one, words = _row(row, rules)
        rows.append(one)
        if words:
            told.append(f"`{row.identifier}`: {words}")
    return Counted(tuple(rows), _warned(told))


def _warned(told: list[str]) -> tuple[Diagnostic, ...]:
    if not told:
        return ()
    whose = "a student" if len(told) == 1 else f"{len(told)} students"
    rest = len(told) - SHOWN
    more = (f"and {rest} more: see the column `why` of the intake's table",) if rest > 0 else ()
    remedies = (
        "nothing is to be done if that is right",
        "to count another file, write it into the column `file` of the intake's table",
        "more time for one student goes into the column `due`",
    )
    headline = f"not every hand-in of {whose} counts in the exam"
    return (warning(NOT_COUNTED, headline, notes=(*told[:SHOWN], *more), help=remedies),)


def _row(row: Row, rules: LateRules) -> tuple[Row, str]:
    """Return a row with what counts of it, and what is to be told; "" where all counts."""
    attempts = _attempts(row)
    excused = row.problem is not None and row.problem.kind is Kind.EXCUSED
    if excused or not attempts:
        return row, ""
    found = _sorted(attempts, rules, row.due)
    dropped = found.early + found.late + found.more
    if not found.inside:
        words = "" if len(attempts) == 1 else _words(found, len(attempts))
        return replace(row, attempts=() if row.problem else attempts[-1:]), words
    if row.problem is not None and _still_matters(row, rules, found):
        return replace(row, attempts=found.inside), ""
    if not dropped and row.problem is None:
        every = f"all {len(found.inside)} hand-ins count"
        why = row.why if len(found.inside) == 1 else every
        return replace(row, attempts=found.inside, why=why), ""
    words = _words(found, len(attempts)) or LATEST_IS_NONE
    last = found.inside[-1]
    others = tuple(a.file for a in row.attempts if a not in found.inside)
    chosen = replace(
        row,
        file=last.file,
        received=last.received,
        why=words,
        attempts=found.inside,
        others=tuple(f for f in dict.fromkeys((*row.others, *others)) if f != last.file),
        problem=None,
    )
    return chosen, words


def _attempts(row: Row) -> tuple[Attempt, ...]:
    """Return the hand-ins; copies that came in one are one, and the latest of them is taken.

    Others that came in the same second stay apart, in the order in which they were found.
    """
    attempts = row.attempts
    if attempts and row.problem is None and row.received is not None:
        attempts = (*attempts[:-1], attempts[-1]._replace(received=row.received))
    if len(attempts) > 1 and any(attempt.received is None for attempt in attempts):
        return tuple(attempt._replace(received=None) for attempt in attempts)
    found: dict[tuple[datetime, str] | int, Attempt] = {}
    for number, attempt in enumerate(attempts):
        name = attempt.file
        original = same_name(copy_of(name, canvas=called_by_canvas(name))[0])
        found[number if attempt.received is None else (attempt.received, original)] = attempt
    return tuple(found.values())


def _sorted(attempts: tuple[Attempt, ...], rules: LateRules, due: datetime | None) -> _Sorted:
    assert rules.opens is not None
    closes = due or rules.due
    early = sum(a.received is not None and a.received < rules.opens for a in attempts)
    late = sum(a.received is not None and a.received > closes for a in attempts)
    inside = tuple(a for a in attempts if a.received is None or rules.opens <= a.received <= closes)
    most = len(inside) if rules.attempts is None else rules.attempts
    last = inside[most - 1 : most + 1]
    at_once = (
        len(last) > 1 and last[0].received is not None and last[0].received == last[1].received
    )
    return _Sorted(inside[:most], early, late, max(0, len(inside) - most), at_once)


def _still_matters(row: Row, rules: LateRules, found: _Sorted) -> bool:
    """Return whether somebody has to look at a latest hand-in of several programs."""
    assert row.problem is not None
    outside = row.received is not None and not (
        rules.opens is not None and rules.opens <= row.received <= (row.due or rules.due)
    )
    full = rules.attempts is not None and len(found.inside) >= rules.attempts
    return row.problem.kind is Kind.AMBIGUOUS and not outside and not full


def _words(found: _Sorted, every: int) -> str:
    """Return what does not count, in words; "" where everything does."""
    parts = [
        f"{number} came {what}"
        for number, what in (
            (found.early, "before the exam opened"),
            (found.late, "after it closed"),
            (
                found.more,
                f"after the first {len(found.inside)}"
                if len(found.inside) > 1
                else "after the first",
            ),
        )
        if number
    ]
    if not parts:
        return ""
    counts = "counts" if len(found.inside) == 1 else "count"
    words = f"{len(found.inside) or 'none'} of {every} hand-ins {counts}: {', '.join(parts)}"
    if any(attempt.received is None for attempt in found.inside):
        return f"{words}; {UNKNOWN_ORDER}"
    return f"{words}; {SAME_SECOND}" if found.at_once else words
