"""What to look at next, and why: the order of the work list.

First what makes marks unsafe, conflicts before all else; then what is assigned to whoever asks and
not finished; then groups that are strongly alike; then causes, those that most rows share together;
then other likeness; then the rest. What whoever asks has finished comes last.
"""

from collections.abc import Mapping, Sequence
from typing import NamedTuple

from vrts.desk.book.book import Book, found_out
from vrts.desk.rows.causes import keys_of
from vrts.desk.told import CauseTold
from vrts.marking.row import Row
from vrts.marking.unsafe import REASONS

CONFLICT, UNSAFE, MINE, STRONG, CAUSE, ALIKE, REST, DONE = range(8)
LONGEST = 60  # characters of a cause
_URGENT = {reason: place for place, reason in enumerate(REASONS)}


class Place(NamedTuple):
    """Where a row stands in the work list, and why."""

    order: int  # from 0
    why: str


def places(book: Book, causes: Sequence[CauseTold], me: str) -> Mapping[str, Place]:
    """Return where every row stands.

    Args:
        book: The state.
        causes: Of the class, the commonest first.
        me: Id of whoever asks.
    """
    rank = {cause.key: place for place, cause in enumerate(causes)}
    shared = {cause.key: cause for cause in causes}
    keyed: list[tuple[tuple[int, float, str, str], Row, str]] = []
    for row in book.rows.rows:
        group, within, beside, why = _place(book, row, rank, shared, me)
        keyed.append(((group, within, beside, row.id), row, why))
    keyed.sort(key=lambda one: one[0])
    return {row.id: Place(number, why) for number, (_, row, why) in enumerate(keyed)}


def _place(
    book: Book, row: Row, rank: Mapping[str, int], shared: Mapping[str, CauseTold], me: str
) -> tuple[int, float, str, str]:
    """Return group, place in it, what keeps rows together in it, and why."""
    mine = book.decided.of(row.id)
    if mine.conflict:
        return CONFLICT, 0, "", "graders differ"
    if row.unsafe:
        reason = row.unsafe[0].reason.value
        return UNSAFE, _URGENT.get(reason, 0), "", f"unsafe: {reason}"
    if mine.otherwise:
        return UNSAFE, len(_URGENT), "", "graders agree on another mark"
    if any(one.who == me and not one.stale for one in mine.finished):
        return DONE, 0, "", "finished"
    if me in mine.assigned:
        return MINE, 0, "", "assigned to you"
    if mine.finished or (mine.assigned and me not in mine.assigned):
        return REST, 1, "", "another grader's"
    alike = book.likeness.get(row.id)
    if alike is not None and alike.strength == "strong":
        others = _others(len(alike.with_))
        return STRONG, -alike.score, alike.group, f"strongly like {others}"
    keys = keys_of(found_out(row))
    if keys:
        cause = shared[keys[0]]
        also = "" if cause.count == 1 else f", as {_others(cause.count - 1)}"
        return CAUSE, rank[cause.key], "", f"{_short(cause.sentence)}{also}"
    if alike is not None:
        return ALIKE, -alike.score, alike.group, f"like {_others(len(alike.with_))}"
    return REST, 0, "", "no points lost"


def _others(count: int) -> str:
    return "1 other" if count == 1 else f"{count} others"


def _short(sentence: str) -> str:
    """Return the begin of a sentence, without the signs that set names apart."""
    plain = sentence.replace("`", "")
    return plain if len(plain) <= LONGEST else f"{plain[: LONGEST - 1].rstrip()}…"
