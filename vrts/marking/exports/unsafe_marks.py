"""What is said about the unsafe marks of a class: after marking, and when they are exported."""

from collections.abc import Collection, Sequence
from typing import NamedTuple

from vrts.base.diagnostic import Diagnostic, Rule, Severity, error, warning
from vrts.marking.row import Class, Row
from vrts.marking.unsafe import ALL, REMEDIES, Reason
from vrts.report.plain import one_line

UNSAFE = Rule("V753", "unsafe-mark")
TIMES_UNTOLD = Rule("V754", "lateness-untold")

SHOWN = 10  # names in a sentence


class Unsafe(NamedTuple):
    """An unsafe mark, and the reasons that count."""

    row: Row
    reasons: tuple[Reason, ...]


def unsafe_rows(rows: Class, despite: Collection[str] = ()) -> tuple[Unsafe, ...]:
    """Return the rows whose marks are unsafe for other reasons than some.

    Args:
        rows: Of the class.
        despite: Values of reasons that do not count, or `all`.
    """
    if ALL in despite:
        return ()
    found: list[Unsafe] = []
    for row in rows.rows:
        reasons = dict.fromkeys(doubt.reason for doubt in row.unsafe)
        counted = tuple(reason for reason in reasons if reason.value not in despite)
        if counted:
            found.append(Unsafe(row, counted))
    return tuple(found)


def after_marking(rows: Class) -> tuple[Diagnostic, ...]:
    """Return a warning that counts and names the unsafe marks; none where all are safe."""
    found = unsafe_rows(rows)
    if not found:
        return ()
    note = "they come first in every list; an export keeps marks back while there are any"
    headline = f"{_count(found, rows)}: {_names(found)}"
    return (warning(UNSAFE, headline, notes=(note,), help=_remedies(found, Severity.WARNING)),)


def refusal(rows: Class, despite: Collection[str]) -> tuple[Diagnostic, ...]:
    """Return why marks are not exported; nothing where they may be.

    Args:
        rows: Of the class.
        despite: Values of reasons that somebody accepts, or `all`.
    """
    found = unsafe_rows(rows, despite)
    if not found:
        return ()
    headline = f"{_count(found, rows)}, so nothing is written: {_names(found)}"
    return (error(UNSAFE, headline, help=_remedies(found, Severity.ERROR)),)


def closing(rows: Class) -> tuple[Diagnostic, ...]:
    """Return what an export says that was written despite unsafe marks; nothing without them."""
    found = unsafe_rows(rows)
    if not found:
        return ()
    headline = f"{_count(found, rows)}, and the export was made despite that: {_names(found)}"
    return (warning(UNSAFE, headline),)


def untold(rows: Class) -> tuple[Diagnostic, ...]:
    """Return a warning where an earlier vrts marked hand-ins without times: it did not tell."""
    without = [row for row in rows.rows if row.handed_in.received is None and row.final]
    if rows.unsafe is not None or not without:
        return ()
    what = "hand-in has" if len(without) == 1 else "hand-ins have"
    headline = f"{len(without)} {what} no time, and the vrts that marked them did not judge that"
    remedy = "mark the class again: what is there already is not made twice"
    return (warning(TIMES_UNTOLD, headline, help=(remedy,)),)


def _count(found: Sequence[Unsafe], rows: Class) -> str:
    return f"{len(found)} of {len(rows.rows)} marks {'is' if len(found) == 1 else 'are'} unsafe"


def _names(found: Sequence[Unsafe]) -> str:
    told = [
        f"`{one_line(one.row.id)}` ({', '.join(reason.value for reason in one.reasons)})"
        for one in found[:SHOWN]
    ]
    rest = len(found) - SHOWN
    return ", ".join(told) + (f" and {rest} more" if rest > 0 else "")


def _remedies(found: Sequence[Unsafe], severity: Severity) -> tuple[str, ...]:
    there = {reason for one in found for reason in one.reasons}
    counts = {reason: sum(reason in one.reasons for one in found) for reason in Reason}
    ways = [
        f"{reason.value} ({counts[reason]}): {REMEDIES[reason]}"
        for reason in Reason
        if reason in there
    ]
    one, *_ = found
    reason = one.reasons[0].value
    by_hand = f"`vrts grade change {one_line(one.row.id)} --mark N`"
    if one.row.final is not None:
        by_hand += f" or `--delta 0 --settles {reason}`"
    ways.append(f"or decide a mark by hand: {by_hand}")
    if severity is Severity.ERROR:
        ways.append(f"or write them as they are: `--despite {reason}`, or `--despite {ALL}`")
    return tuple(ways)
