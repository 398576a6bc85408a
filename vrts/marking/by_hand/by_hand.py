"""All that people decide about a class: `overrides.toml` and graders' files, and what it makes."""

from collections.abc import Collection, Iterator, Sequence
from datetime import datetime
from fractions import Fraction
from itertools import islice
from typing import NamedTuple

import msgspec

from vrts.base.diagnostic import Diagnostic, Rule, warning
from vrts.check.rules.scheme import TOTAL
from vrts.check.task.late_rules import LateRules
from vrts.marking.by_hand.decisions.files import UNSOUND, read_decisions
from vrts.marking.by_hand.decisions.ledger import NONE as NO_LEDGER
from vrts.marking.by_hand.decisions.ledger import Ledger
from vrts.marking.by_hand.decisions.records import Extend
from vrts.marking.by_hand.decisions.sound import beyond
from vrts.marking.by_hand.decisions.state import NOTHING, Prepared, prepared
from vrts.marking.by_hand.graded import graded, undecided
from vrts.marking.by_hand.override_text import load_overrides
from vrts.marking.by_hand.overrides import (
    LAPSED,
    NONE,
    UNKNOWN_STUDENT,
    Overrides,
    change_of,
    lapses,
    program_of,
)
from vrts.marking.layout import Layout
from vrts.marking.result import Damaged
from vrts.marking.row import Class, CountedFile, Row, decisions_counted, final_mark, row_of
from vrts.pipeline.files import read_bytes
from vrts.pipeline.refused import Refused

UNKNOWN = Rule("V846", "decision-about-unknown")
MOST = 20  # warnings of one kind
FILES_MISSING = "a file of `staff/decisions` may not have been copied to here yet"


class ByHand(NamedTuple):
    """What people have decided about a class."""

    overrides: Overrides = NONE
    ledger: Ledger = NO_LEDGER
    graders: Prepared = Prepared()
    late: LateRules | None = None  # what lateness costs, for later deadlines
    diagnostics: tuple[Diagnostic, ...] = ()


NOBODY = ByHand()


def load_by_hand(
    layout: Layout,
    known: Collection[str],
    total: Fraction = TOTAL,
    late: LateRules | None = None,
) -> ByHand:
    """Return what is decided by hand; nothing where there are no files.

    Args:
        layout: Where the files are.
        known: Identifiers of the class.
        total: Marks are out of so many points.
        late: What lateness costs; None: nothing.

    Raises:
        Refused: A file has errors.
        CannotRead: It cannot be read.
    """
    overrides = load_overrides(layout.overrides, known, total)
    ledger = read_decisions(layout.decisions, _counted_before(layout))
    if ledger.wrong:
        raise Refused(ledger.diagnostics)
    ready = prepared(ledger)
    told = (
        *overrides.diagnostics,
        *ledger.diagnostics,
        *_unknown(ready, set(known)),
        *_beyond(ready, total),
    )
    return ByHand(overrides, ledger, ready, late, told)


def _counted_before(layout: Layout) -> tuple[CountedFile, ...]:
    """Return on what of graders' files the lists of marks rest; nothing where there are none.

    Raises:
        CannotRead: The list cannot be read.
    """
    if not layout.results.is_file():
        return ()
    try:
        return decisions_counted(read_bytes(layout.results))
    except Damaged:
        return ()  # whoever needs the list says so


def later_deadlines(layout: Layout) -> dict[str, datetime]:
    """Return the later deadlines that graders have given, by id; those in conflict are left out.

    Raises:
        Refused: A file has errors.
        CannotRead: It cannot be read.
    """
    ledger = read_decisions(layout.decisions, _counted_before(layout))
    if ledger.wrong:
        raise Refused(ledger.diagnostics)
    ready = prepared(ledger)
    found: dict[str, datetime] = {}
    for student in ready.about:
        for one in ready.of(student).extension:
            if isinstance(one.said, Extend):
                found[student] = datetime.fromisoformat(one.said.due)
    return found


def with_by_hand(row: Row, by_hand: ByHand) -> Row:
    """Return a row with what is decided about it now, and nothing of what was before."""
    plain = undecided(row)
    made = by_hand.overrides.changes.get(row.id, ())
    mine = by_hand.graders.of(row.id, program_of(plain.result))
    if mine != NOTHING:
        return graded(plain, mine, made, by_hand.graders, by_hand.late)
    before = final_mark(plain.result.exact_mark, plain.late, None, plain.result.exact_total)
    change = change_of(before, made, plain.result)
    return row_of(plain.result, plain.student, plain.handed_in, plain.late, change)


def rows_by_hand(rows: Class, by_hand: ByHand) -> Class:
    """Return the rows of a class with what is decided now."""
    decided = tuple(with_by_hand(row, by_hand) for row in rows.rows)
    return msgspec.structs.replace(rows, rows=decided, decisions=by_hand.ledger.counts)


def all_lapses(rows: Sequence[Row], by_hand: ByHand) -> tuple[Diagnostic, ...]:
    """Return warnings of decisions about other programs than those that are marked now.

    Args:
        rows: With these decisions.
        by_hand: Of the class.
    """
    return (*lapses(rows, by_hand.overrides), *_lapsed(rows, by_hand))


def _lapsed(rows: Sequence[Row], by_hand: ByHand) -> Iterator[Diagnostic]:
    for row in rows:
        for one in by_hand.graders.of(row.id, program_of(undecided(row).result)).lapsed:
            yield warning(
                LAPSED,
                f"`{row.id}`: {one.name} of {one.who} was decided about another program",
                notes=("it does not count",),
                help=(f"look again, decide again, and undo `{one.name}`",),
            )


def _unknown(ready: Prepared, known: Collection[str]) -> Iterator[Diagnostic]:
    for one, student in ready.unknown(known)[:MOST]:
        yield warning(
            UNKNOWN_STUDENT,
            f"there is no student `{student}` in this class",
            notes=(f"{one.name} of {one.who} has no effect there",),
        )
    for one in ready.without_item[:MOST]:
        headline = f"{one.name} of {one.who} gives an item that is not there"
        yield warning(UNKNOWN, headline, notes=("it has no effect",), help=(FILES_MISSING,))
    for name, other in ready.dangling[:MOST]:
        headline = f"{name} is about `{other}`, and there is no such decision"
        yield warning(UNKNOWN, headline, notes=("it has no effect",), help=(FILES_MISSING,))
    for name in ready.circular[:MOST]:
        headline = f"{name} is undone by what it undoes: it has no effect"
        yield warning(UNKNOWN, headline, help=("undo one of them once more",))


def _beyond(ready: Prepared, total: Fraction) -> Iterator[Diagnostic]:
    """Yield warnings of counting marks and points that are above the total."""
    found = ((one, flaw) for one in ready.counting if (flaw := beyond(one.said, total)))
    for one, flaw in islice(found, MOST):
        yield warning(
            UNSOUND,
            f"{one.name} of {one.who} cannot be meant: {flaw}",
            notes=("it does not count, and the marks that it is about are unsafe",),
            help=(f"decide what is meant, and undo `{one.name}`",),
        )


def programs_of(rows: Sequence[Row]) -> dict[str, str]:
    """Return by id the sha256 of the program that is marked, or `none`."""
    return {row.id: program_of(undecided(row).result) for row in rows}
