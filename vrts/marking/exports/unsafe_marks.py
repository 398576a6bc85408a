"""What is said about the unsafe marks of a class: after marking, and when they are exported."""

import shlex
from collections.abc import Collection, Sequence
from pathlib import Path
from typing import NamedTuple

import msgspec

from vrts.base.diagnostic import Diagnostic, Rule, error, warning
from vrts.marking.row import Class, Row, counted
from vrts.marking.unsafe import ALL, OF_GRADERS, REMEDIES, Reason
from vrts.report.plain import one_line

UNSAFE = Rule("V753", "unsafe-mark")

OUT = Path("OUT")  # stands for the folder of a marking that is not known
SHOWN = 10  # names in a sentence
OF_SESSIONS = {
    Reason.AMBIGUOUS: "look at the log of the room, and decide by hand",
    Reason.LATE: "nothing tells when a session was due: decide by hand",
}  # remedies where those of files do not help


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
        counts = tuple(reason for reason in reasons if reason.value not in despite)
        if counts:
            found.append(Unsafe(row, counts))
    return tuple(found)


def without_lateness(rows: Class) -> Class:
    """Return a class as platforms want it that judge lateness themselves: it makes nothing unsafe.

    Deductions that are known stay.
    """
    kept = tuple(
        msgspec.structs.replace(
            row, unsafe=tuple(doubt for doubt in row.unsafe if doubt.reason is not Reason.LATE)
        )
        for row in rows.rows
    )
    judged = msgspec.structs.replace(rows, rows=kept)
    return judged if rows.unsafe is None else counted(judged)


def after_marking(rows: Class, folder: Path = OUT) -> tuple[Diagnostic, ...]:
    """Return a warning that counts and names the unsafe marks; none where all are safe.

    Args:
        rows: Of the class.
        folder: That the marking wrote.
    """
    found = unsafe_rows(rows)
    if not found:
        return ()
    note = "they come first in every list; an export keeps marks back while there are any"
    headline = f"{_count(found, rows)}: {_names(found)}"
    help_ = (*_remedies(found), *_by_hand(found, folder))
    return (warning(UNSAFE, headline, notes=(note,), help=help_),)


def refusal(
    rows: Class, despite: Collection[str], folder: Path = OUT, kept: Sequence[str] = ()
) -> tuple[Diagnostic, ...]:
    """Return why marks are not exported; nothing where they may be.

    Args:
        rows: Of the class.
        despite: Values of reasons that somebody accepts, or `all`.
        folder: That the marking wrote.
        kept: Formats that are not written, where others are.
    """
    found = unsafe_rows(rows, despite)
    if not found:
        return ()
    names = ", ".join(f"`{name}`" for name in kept)
    what = f"{names} {'is' if len(kept) == 1 else 'are'} not" if kept else "nothing is"
    headline = f"{_count(found, rows)}, so {what} written: {_names(found)}"
    there = {reason for one in found for reason in one.reasons}
    wanted = [reason for reason in Reason if reason in there or reason.value in despite]
    typed = " ".join(f"--despite {reason.value}" for reason in wanted)
    as_they_are = f"or write them as they are: `{typed}`, or `--despite {ALL}`"
    help_ = (*_remedies(found), *_by_hand(found, folder), as_they_are)
    return (error(UNSAFE, headline, help=help_),)


def closing(rows: Class) -> tuple[Diagnostic, ...]:
    """Return what an export says that was written despite unsafe marks; nothing without them."""
    found = unsafe_rows(rows)
    if not found:
        return ()
    headline = f"{_count(found, rows)}, and the export was made despite that: {_names(found)}"
    return (warning(UNSAFE, headline),)


def _count(found: Sequence[Unsafe], rows: Class) -> str:
    return f"{len(found)} of {len(rows.rows)} marks {'is' if len(found) == 1 else 'are'} unsafe"


def _names(found: Sequence[Unsafe]) -> str:
    told = [
        f"`{one_line(one.row.id)}` ({', '.join(reason.value for reason in one.reasons)})"
        for one in found[:SHOWN]
    ]
    rest = len(found) - SHOWN
    return ", ".join(told) + (f" and {rest} more" if rest > 0 else "")


def _remedies(found: Sequence[Unsafe]) -> list[str]:
    """Return for each reason that is there how often it is, and what to do."""
    ways: list[str] = []
    for reason in Reason:
        rows = [one.row for one in found if reason in one.reasons]
        if rows:
            sessions = reason in OF_SESSIONS and all(row.of_session for row in rows)
            remedy = OF_SESSIONS[reason] if sessions else REMEDIES[reason]
            ways.append(f"{reason.value} ({len(rows)}): {remedy}")
    return ways


def _by_hand(found: Sequence[Unsafe], folder: Path) -> list[str]:
    """Return how to decide a mark by hand, as it can be typed; nothing where graders have to."""
    held = [one for one in found if not OF_GRADERS.issuperset(one.reasons)]
    if not held:
        return []
    row = held[0].row
    who, where = shlex.quote(one_line(row.id)), shlex.quote(str(folder))
    typed = f"`vrts grade change {who} --from {where} --mark N --reason WHY --who YOU`"
    if row.result.mark is None:
        return [f"or decide a mark by hand: {typed}"]
    reasons = dict.fromkeys(doubt.reason for doubt in row.unsafe)
    settles = " ".join(f"--settles {one.value}" for one in reasons if one not in OF_GRADERS)
    as_it_is = f"`--delta 0 {settles}` in place of `--mark N`"
    return [f"or decide a mark by hand: {typed}, or with {as_it_is}"]
