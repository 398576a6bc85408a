"""Records in plain words: for lists, for conflicts, and for the history of a mark."""

from datetime import datetime
from fractions import Fraction
from typing import assert_never

from vrts.marking.by_hand.decisions.ledger import Filed
from vrts.marking.by_hand.decisions.records import (
    Assign,
    ChangeMark,
    Comment,
    Decide,
    Excuse,
    Extend,
    Finish,
    Give,
    Item,
    Undo,
)
from vrts.report.plain import one_line
from vrts.report.quantities import MINUS


def sentence_of(one: Filed) -> str:
    """Return what a record says, without who says it."""
    said = one.said
    match said:
        case Comment():
            words = (
                f"{'private comment' if said.private else 'comment'}{_at(said.line, said.time_s)}"
            )
            return f"{words}: {one_line(said.text)}"
        case Item():
            ends = ", withdrawn" if said.withdrawn else ""
            points = signed(Fraction(said.points))
            return f"item `{said.id}`: {one_line(said.title)} ({points}{ends})"
        case Give():
            return f"item `{said.item}` given{_at(said.line, said.time_s)}"
        case ChangeMark():
            return f"{change_words(said)}: {one_line(said.reason)}"
        case Extend():
            return f"due {due_words(said.due)}: {one_line(said.reason)}"
        case Excuse():
            return f"excused: {one_line(said.reason)}"
        case Assign():
            return (
                f"assigned to {', '.join(said.graders)}" if said.graders else "assigned to nobody"
            )
        case Finish():
            given = "without a mark" if said.mark is None else f"with {number(Fraction(said.mark))}"
            return f"finished {given}"
        case Decide():
            whom = f" for {', '.join(map(one_line, said.students))}" if said.students else ""
            over = ", ".join(said.over)
            return f"{said.keep} counts{whom}, {over} not: {one_line(said.reason)}"
        case Undo():
            reason = f": {one_line(said.reason)}" if said.reason else ""
            return f"undone: {', '.join(said.records)}{reason}"
        case _:
            assert_never(said)


def change_words(said: ChangeMark) -> str:
    """Return what a change comes to."""
    if said.delta is not None:
        return f"{signed(Fraction(said.delta))} points"
    return f"the mark {number(Fraction(said.mark or '0'))}"


def due_words(due: str) -> str:
    """Return a time as people read it."""
    return f"{datetime.fromisoformat(due):%Y-%m-%d %H:%M %Z}".strip()


def number(value: Fraction) -> str:
    """Return points without trailing zeros."""
    return f"{float(value):g}"


def signed(value: Fraction) -> str:
    """Return points with their sign."""
    return (MINUS if value < 0 else "+") + number(abs(value))


def _at(line: int | None, time_s: float | None) -> str:
    line_words = "" if line is None else f" on line {line}"
    return line_words + ("" if time_s is None else f" at {time_s:.2f} s")
