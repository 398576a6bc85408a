"""Lists, feedback and pages of a class, brought up to date from files; nothing is marked."""

from collections.abc import Collection, Mapping
from contextlib import AbstractContextManager, nullcontext
from typing import NamedTuple

import msgspec

from vrts.base.diagnostic import Diagnostic
from vrts.marking.appeals.written import read_class, read_written
from vrts.marking.by_hand.by_hand import ByHand, all_lapses, rows_by_hand
from vrts.marking.by_hand.decisions.files import locked
from vrts.marking.class_files import write_class
from vrts.marking.exports.earlier_marks import with_times_judged
from vrts.marking.exports.feedback import for_student
from vrts.marking.exports.numbers import decimal
from vrts.marking.exports.write import is_name, write_feedback
from vrts.marking.layout import Layout, write_atomically
from vrts.marking.renewing.section import with_section
from vrts.marking.row import Class, Decided, Row
from vrts.marking.submission.report_files import REPORT
from vrts.pipeline.refused import Refused

LOCK = ".renewing"  # in the folder of decisions; nothing is in it


class Renewed(NamedTuple):
    """A class as it is now."""

    rows: Class
    changed: tuple[str, ...]  # ids of rows that were otherwise before
    by_hand: ByHand
    diagnostics: tuple[Diagnostic, ...]


def renewed(layout: Layout, again: Collection[str] = ()) -> Renewed:
    """Write what follows from the decisions as they are now, and return the class.

    Pages and feedback of rows that changed, then the lists. `results.json` comes last: whatever
    interrupts this, the next call makes up for it.

    Args:
        layout: Of a marking that has ended.
        again: Ids whose files are written in any case: they were marked anew.

    Raises:
        CannotRead: A file cannot be read.
        Refused: There is no such marking, or decisions have errors; nothing is written then.
    """
    with _alone(layout):
        return _renewed(layout, again)


def _alone(layout: Layout) -> AbstractContextManager[None]:
    """Return what holds the folder: several desks may bring it up to date at once."""
    return locked(layout.decisions, LOCK) if layout.decisions.is_dir() else nullcontext()


def _renewed(layout: Layout, again: Collection[str]) -> Renewed:
    written = read_written(layout.root)
    by_hand = written.by_hand()
    judged, said = with_times_judged(written.rows, written.about.place)
    rows = rows_by_hand(judged, by_hand)
    before = {row.id: row for row in written.rows.rows}
    changed = tuple(row.id for row in rows.rows if row.id in again or row != before[row.id])
    if changed:
        only = set(changed)
        some = tuple(row for row in rows.rows if row.id in only)
        write_sections(some, layout)
        write_feedback(msgspec.structs.replace(rows, rows=some), layout)
        write_class(rows, written.about, layout)
    told = (*by_hand.diagnostics, *said, *all_lapses(rows.rows, by_hand))
    return Renewed(rows, changed, by_hand, told)


def decided_before(layout: Layout) -> Mapping[str, Decided]:
    """Return what the list of marks says of decisions, by id; nothing where there is no list."""
    try:
        rows = read_class(layout.results).rows
    except Refused:
        return {}
    return {row.id: row.decided for row in rows if row.decided is not None}


def write_sections(
    rows: Collection[Row], layout: Layout, before: Collection[str] | None = None
) -> None:
    """Put what graders decided into the pages of a class, or take it out.

    Args:
        rows: Of the class.
        layout: Where the pages are.
        before: Ids of rows with pages that may have a section; None: all.
    """
    for row in rows:
        if (row.decided is None and before is not None and row.id not in before) or not is_name(
            row.id
        ):
            continue
        homes = ((layout.grader(row.id), True), (layout.student(row.id), False))
        for home, staff in homes:
            place = home / REPORT
            if place.is_symlink() or not place.is_file():
                continue
            page = place.read_bytes()
            decided = row.decided if staff else for_student(row)
            after = with_section(page, decided, staff=staff, final=_final(row))
            if after != page:
                write_atomically(place, after)


def _final(row: Row) -> str:
    final = row.exact_final
    of_all = decimal(row.result.exact_total)
    return "" if final is None else f"{decimal(final, least=1)} of {of_all}"
