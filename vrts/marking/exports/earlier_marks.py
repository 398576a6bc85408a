"""Marks of an earlier vrts, which did not tell who may be late: judged by the task of then."""

from typing import NamedTuple

import msgspec

from vrts.base.diagnostic import Diagnostic, Rule, warning
from vrts.marking.intake.layouts.canvas import called_by_canvas
from vrts.marking.intake.row import Platform
from vrts.marking.lateness import UNTIMED
from vrts.marking.row import Class, Lateness, Row, row_of
from vrts.marking.submission.setting import Place, load
from vrts.pipeline.files import CannotRead
from vrts.pipeline.refused import Refused

TIMES_UNTOLD = Rule("V754", "lateness-untold")

LATE = Lateness(0, "0", UNTIMED, review=True, untimed=True)


class Judged(NamedTuple):
    """A class, and what there is to say about its times."""

    rows: Class
    diagnostics: tuple[Diagnostic, ...] = ()


def with_times_judged(rows: Class, place: Place) -> Judged:
    """Return a class in which hand-ins without a time are unsafe, where that may cost points.

    Args:
        rows: Of the class, as read; what this vrts marked stays as it is.
        place: Where the task is that they were marked by.
    """
    untold = {row.id for row in rows.rows if _is_untold(row)}
    if rows.unsafe is not None or not untold:
        return Judged(rows)
    try:
        setting = load(place, staff=False)
    except (CannotRead, Refused):
        why = "the task cannot be read any more, so nobody knows what being late costs"
    else:
        if setting.task is None or setting.task.late is None:
            return Judged(rows)
        why = "the task takes points off for being late"
    judged = tuple(_late(row) if row.id in untold else row for row in rows.rows)
    what = "hand-in has" if len(untold) == 1 else "hand-ins have"
    headline = f"{len(untold)} {what} no time, and the vrts that marked them did not judge that"
    remedy = "mark the class again: what is there already is not made twice"
    said = warning(TIMES_UNTOLD, headline, notes=(why,), help=(remedy,))
    return Judged(msgspec.structs.replace(rows, rows=judged), (said,))


def _is_untold(row: Row) -> bool:
    """Return whether a mark may lack a deduction; what Canvas does not call late is on time."""
    flags = Platform.CANVAS.value in row.student.ids and called_by_canvas(row.handed_in.file)
    known = row.handed_in.received is not None or row.late is not None or flags
    return bool(row.result.mark) and not known


def _late(row: Row) -> Row:
    return row_of(row.result, row.student, row.handed_in, LATE, row.change)
