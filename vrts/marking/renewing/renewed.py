"""Lists, feedback and pages of a class, brought up to date from files; nothing is marked."""

from collections.abc import Collection, Mapping
from typing import Final, NamedTuple

import msgspec

from vrts.base.diagnostic import Diagnostic
from vrts.marking.about import About
from vrts.marking.appeals.written import Written, read_class, read_written
from vrts.marking.by_hand.by_hand import ByHand, all_lapses, load_by_hand, rows_by_hand
from vrts.marking.class_files import lists_alone, write_class, write_overview
from vrts.marking.exports.earlier_marks import with_times_judged
from vrts.marking.exports.feedback import for_student
from vrts.marking.exports.numbers import decimal
from vrts.marking.exports.write import is_name, write_feedback
from vrts.marking.layout import Layout, write_atomically
from vrts.marking.renewing.section import with_section
from vrts.marking.row import Class, Decided, Row
from vrts.marking.submission.report_files import REPORT
from vrts.pipeline.refused import Refused

PENDING: Final = ".renewing"  # in `staff`: ids of rows whose files are being written


class Renewed(NamedTuple):
    """A class as it is now."""

    rows: Class
    changed: tuple[str, ...]  # ids of rows that were otherwise before
    by_hand: ByHand
    diagnostics: tuple[Diagnostic, ...]


def renewed(layout: Layout, again: Collection[str] = ()) -> Renewed:
    """Write what follows from the decisions as they are now, and return the class.

    Pages and feedback of rows that changed, then the lists. Whatever interrupts this, the next call
    makes up for it, also where what was decided is undone before that.

    Args:
        layout: Of a marking that has ended.
        again: Ids whose files are written in any case: they were marked anew.

    Raises:
        CannotRead: A file cannot be read.
        Refused: There is no such marking, or decisions have errors; nothing is written then.
    """
    with lists_alone(layout):
        return _renewed(layout, again)


def brought_up_to_date(written: Written) -> None:
    """Let pages and lists be as decided now, where they are not, before they are given to anybody.

    Raises:
        CannotRead: A file cannot be read.
        Refused: Decisions have errors.
    """
    now = rows_by_hand(written.rows, written.by_hand())
    before = {row.id: row for row in written.rows.rows}
    behind = (_is_behind(row, before[row.id]) for row in now.rows)
    if any(behind) or pending(written.layout):
        renewed(written.layout)


def _is_behind(row: Row, before: Row) -> bool:
    """Return whether the page of a row says something else of decisions than it should."""
    if row.decided != before.decided:
        return True
    return row.decided is not None and row.final != before.final


def decided_now(rows: Class, about: About, layout: Layout) -> Class:
    """Return rows that were marked with what is decided now: some was decided meanwhile.

    Raises:
        CannotRead: A file cannot be read.
        Refused: Decisions have errors.
    """
    late = None if about.late is None else about.late.rules
    by_hand = load_by_hand(layout, [row.id for row in rows.rows], rows.total, late)
    return rows_by_hand(rows, by_hand)


def write_marked(
    rows: Class, about: About, layout: Layout, pages: Collection[str] | None = None
) -> Class:
    """Write what follows from a marking that has ended, with what is decided at this moment.

    Args:
        rows: As they were marked.
        about: With its end.
        layout: Where it goes.
        pages: Ids of rows whose pages are new; None: all may be.

    Returns:
        The rows as they were written.

    Raises:
        CannotRead: A file cannot be read.
        Refused: Decisions have errors.
    """
    with lists_alone(layout):
        rows = decided_now(rows, about, layout)
        before = decided_before(layout)
        names = {row.id for row in rows.rows if row.decided is not None}
        names.update(pages or (), pending(layout))
        names.update(before)
        some = [row for row in rows.rows if row.id in names]
        _begin(layout, some)
        write_sections(some, layout)
        write_feedback(rows, layout)
        write_class(rows, about, layout)
        _end(layout)
    return rows


def link_compared(rows: Class, about: About, layout: Layout) -> None:
    """Write the overview again, after programs were compared: it links to what was found."""
    with lists_alone(layout):
        write_overview(rows, about, layout)


def pending(layout: Layout) -> frozenset[str]:
    """Return ids of rows whose files may be half written: something was interrupted."""
    try:
        return frozenset((layout.staff / PENDING).read_text(encoding="utf-8").splitlines())
    except (OSError, UnicodeDecodeError):  # there is none; it is written whole or not at all
        return frozenset()


def _begin(layout: Layout, rows: Collection[Row]) -> None:
    names = sorted({row.id for row in rows} | pending(layout))
    write_atomically(layout.staff / PENDING, "".join(f"{name}\n" for name in names).encode())


def _end(layout: Layout) -> None:
    (layout.staff / PENDING).unlink(missing_ok=True)


def _renewed(layout: Layout, again: Collection[str]) -> Renewed:
    written = read_written(layout.root)
    by_hand = written.by_hand()
    judged, said = with_times_judged(written.rows, written.about.place)
    rows = rows_by_hand(judged, by_hand)
    before = {row.id: row for row in written.rows.rows}
    again = {*again, *pending(layout)}
    changed = tuple(row.id for row in rows.rows if row.id in again or row != before[row.id])
    if changed:
        only = set(changed)
        some = tuple(row for row in rows.rows if row.id in only)
        _begin(layout, some)
        write_sections(some, layout)
        write_feedback(msgspec.structs.replace(rows, rows=some), layout)
        write_class(rows, written.about, layout)
    if changed or again:
        _end(layout)
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
            after = page_about(page, row, staff=staff)
            if after != page:
                write_atomically(place, after)


def page_about(page: bytes, row: Row, *, staff: bool) -> bytes:
    """Return a page about a row with what is decided about it, and nothing else of graders."""
    decided = row.decided if staff else for_student(row)
    return with_section(page, decided, staff=staff, final=_final(row))


def _final(row: Row) -> str:
    final = row.exact_final
    of_all = decimal(row.result.exact_total)
    return "" if final is None else f"{decimal(final, least=1)} of {of_all}"
