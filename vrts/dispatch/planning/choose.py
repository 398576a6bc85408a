"""Which programs of a class are worth an hour of the real robot: ready ones, by clearance and mark.

A line names a student where the marking does; where it was made with pseudonyms, it has only these.
"""

from collections.abc import Iterable
from typing import NamedTuple

from vrts.marking.result import SHOWN
from vrts.marking.row import Class, Row

SAME_MM = 1.0  # clearances are compared in whole steps of this; then the mark counts


class Choice(NamedTuple):
    """A program that is ready for the real robot."""

    identifier: str
    name: str  # of the student; "" where there is none to tell
    clearance_mm: float | None  # None: nothing is near
    mark: float | None  # final mark
    duration_s: float | None
    ready_in: str = SHOWN  # or every future


def choices(rows: Class) -> tuple[Choice, ...]:
    """Return the ready programs of a class, the one with the largest clearance first."""
    ready = (_choice(row) for row in rows.rows if row.result.ready and not row.result.stamps)
    return tuple(sorted(ready, key=_order))


def choices_text(found: Iterable[Choice], total: int) -> str:
    """Return the list for a terminal.

    Args:
        found: What to list.
        total: Programs that were marked.
    """
    listed = list(found)
    rows = [("", "clearance", "mark", "takes", "program", "")]
    for number, choice in enumerate(listed, 1):
        clearance = choice.clearance_mm
        rows.append(
            (
                str(number),
                "-" if clearance is None else f"{clearance:.1f} mm",
                "-" if choice.mark is None else f"{choice.mark:g}",
                "-" if choice.duration_s is None else f"{choice.duration_s:.1f} s",
                choice.identifier,
                choice.name,
            )
        )
    widths = [max(len(row[k]) for row in rows) for k in range(5)]
    lines = [_line(row, widths) for row in rows] if listed else []
    where = dict.fromkeys(choice.ready_in for choice in listed) or {SHOWN: None}
    each = " or ".join(f"in {one}" for one in where)
    lines.append(f"{len(listed)} of {total} programs are ready for the real robot, each {each}")
    return "\n".join(lines)


def _line(row: tuple[str, ...], widths: list[int]) -> str:
    numbers = "  ".join(f"{row[k]:>{widths[k]}}" for k in range(4))
    return f"{numbers}  {row[4]:<{widths[4]}}  {row[5]}".rstrip()


def _choice(row: Row) -> Choice:
    metrics = row.result.metrics
    return Choice(
        row.id,
        row.student.name,
        metrics.clearance_mm,
        row.final,
        metrics.duration_s,
        row.result.ready_in,
    )


def _order(choice: Choice) -> tuple[float, float, str]:
    clearance = float("inf") if choice.clearance_mm is None else choice.clearance_mm // SAME_MM
    return -clearance, -(choice.mark or 0.0), choice.identifier
