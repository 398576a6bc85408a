"""Rows that several graders mark: what each of them alone would give, and what that says.

Whoever has finished a row is not finished with it any more where they would give another mark now.
"""

from collections import defaultdict
from collections.abc import Mapping

from msgspec.structs import replace

from vrts.desk.book.alone import Shared, by_one
from vrts.desk.book.decided import Mine
from vrts.desk.told import Looked
from vrts.marking.by_hand.by_hand import ByHand, with_by_hand
from vrts.marking.by_hand.decisions.state import prepared
from vrts.marking.row import Row

_SAME = 0.05 + 1e-9  # marks are tenths; what was finished with may be none

Marks = Mapping[str, float | None]  # by id of a grader


def marks_alone(
    rows: Mapping[str, Row], by_hand: ByHand, shared: Mapping[str, Shared], me: str
) -> dict[str, dict[str, float | None]]:
    """Return by student and grader the final mark that each grader alone would give.

    Args:
        rows: Of the class, by id, as whoever asks may see them.
        by_hand: All that is decided.
        shared: The rows that several graders mark. Of those that somebody has still to finish only
            the mark of whoever asks is looked at: it is the one that is shown.
        me: Id of whoever asks.
    """
    asked: dict[str, list[str]] = defaultdict(list)
    found: dict[str, dict[str, float | None]] = defaultdict(dict)
    for student, row in shared.items():
        if not row.is_open:
            for who in row.assigned:
                asked[who].append(student)
        elif me in row.assigned:
            found[student][me] = rows[student].final
    for who, students in asked.items():
        seen = by_one(by_hand.ledger, who, students).ledger
        alone = by_hand._replace(ledger=seen, graders=prepared(seen))
        for student in students:
            found[student][who] = with_by_hand(rows[student], alone).final
    return dict(found)


def looked_again(mine: Mine, final: float | None, alone: Marks) -> Mine:
    """Return what is told of a row, where those who would give another mark now are not finished.

    Args:
        mine: What was decided; the mark of none of its graders was decided to count.
        final: The mark that is shown.
        alone: What graders alone would give; whoever is not in it would give the mark shown.
    """
    return mine._replace(
        finished=tuple(
            one
            if one.stale or _is(one, final) or _is(one, alone.get(one.who, final))
            else replace(one, stale=True)
            for one in mine.finished
        )
    )


def agreed_otherwise(
    mine: Mine, final: float | None, shared: Shared, names: Mapping[str, str]
) -> str:
    """Return that all have finished with one mark which is not the final one; "": it is not so.

    Args:
        mine: What was decided.
        final: The final mark.
        shared: Who marks it.
        names: Of graders, by id.
    """
    found = [one for one in mine.finished if one.who in shared.finished]
    marks = [one.mark for one in found if one.mark is not None]
    if shared.is_open or len(marks) < len(shared.assigned) or max(marks) - min(marks) > _SAME:
        return ""
    if final is not None and abs(marks[0] - final) < _SAME:
        return ""
    *first, last = (names.get(one.who, one.who) for one in found)
    who = f"{', '.join(first)} and {last} {'both' if len(found) == 2 else 'all'}"
    mark = "there is none" if final is None else f"it is {final:g}"
    return (
        f"{who} finished with {marks[0]:g}, and {mark}: what they changed adds up."
        " Undo what is there twice, or set the mark by hand."
    )


def _is(one: Looked, mark: float | None) -> bool:
    if one.mark is None or mark is None:
        return one.mark is mark
    return abs(one.mark - mark) < _SAME
