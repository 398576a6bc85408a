"""Records as the page sends them: read without trust, and completed with what they are about."""

from typing import Annotated, Any, Final, NamedTuple

import msgspec
from msgspec import Meta, Struct
from msgspec.structs import replace

from vrts.base.diagnostic import Diagnostic, Rule, error
from vrts.desk.adding.facts import Facts
from vrts.desk.book.book import Book
from vrts.marking.by_hand.decisions.files import BUSY
from vrts.marking.by_hand.decisions.records import (
    Assign,
    ChangeMark,
    Comment,
    Decide,
    Decision,
    Finish,
    Give,
    Item,
    Undo,
)
from vrts.marking.by_hand.decisions.state import students_of
from vrts.pipeline.refused import Refused

BAD_RECORD = Rule("V853", "no-such-decision")

MOST: Final = 5000  # records at a time: words for each of a large class
_AGAIN: Final = "load the page again: it may be of another vrts"


class Body(Struct, frozen=True, forbid_unknown_fields=True):
    """What `POST /api/records` takes."""

    records: Annotated[list[dict[str, Any]], Meta(min_length=1, max_length=MOST)]
    expect: Annotated[str, Meta(max_length=64)]
    again: bool = False  # it was sent before, and nobody knows whether it was written


class Rests(NamedTuple):
    """What records rest on."""

    students: tuple[str, ...]  # their marks and programs
    items: tuple[str, ...]  # their versions
    records: tuple[str, ...]  # that they are not undone


def records_of(body: Body) -> tuple[Decision, ...]:
    """Return records without numbers and times, which are given when they are written.

    Raises:
        Refused: One of them is none.
    """
    found: list[Decision] = []
    for place, told in enumerate(body.records, 1):
        try:
            found.append(msgspec.convert({**told, "number": 1, "at": ""}, Decision))
        except msgspec.ValidationError as problem:
            why = str(problem)[:200]
            raise _wrong(
                f"decision {place} is none: {why[:1].lower()}{why[1:]}", _AGAIN
            ) from problem
    return tuple(found)


def rests_on(records: tuple[Decision, ...]) -> Rests:
    """Return what records rest on: not words, and not who is to look at what."""
    students: dict[str, None] = {}
    items: dict[str, None] = {}
    named: dict[str, None] = {}
    for one in records:
        if not isinstance(one, Comment | Assign):
            students.update(dict.fromkeys(students_of(one)))
        match one:
            case Item():
                items[one.id] = None
            case Give():
                items[one.item] = None
            case Undo():
                named.update(dict.fromkeys(one.records))
            case Decide():
                named.update(dict.fromkeys((one.keep, *one.over)))
            case _:
                pass
    return Rests(tuple(students), tuple(items), tuple(named))


def require_seen(records: tuple[Decision, ...], hidden: frozenset[str]) -> None:
    """Check that nothing is undone of which the grader sees only a part.

    Args:
        records: As the page sent them.
        hidden: Names of records of which something is left out.

    Raises:
        Refused: One of them would be undone for rows that the grader marks alone, too.
    """
    for one in records:
        found = hidden & set(one.records) if isinstance(one, Undo) else set[str]()
        if found:
            raise _wrong(
                f"{min(found)} is also about a row that is yours to mark alone",
                "undo it when all have finished that row, or let its grader undo it",
            )


def require_present(book: Book) -> None:
    """Check that what is shown is what the files say.

    Raises:
        Refused: They cannot be read: whoever decides now does not see what it would be about.
    """
    if not book.old:
        return
    headline = f"nothing was decided: {book.problems[0]}"
    remedy = "decide again when this is put right: the page keeps what is typed"
    raise Refused((error(BUSY, headline, help=(remedy,)),))


def completed(records: tuple[Decision, ...], shown: Facts) -> tuple[Decision, ...]:
    """Return records that say about which programs, and which version of an item, they are.

    Args:
        records: As the page sent them.
        shown: What was shown when they were decided.

    Raises:
        Refused: They name who or what is not there.
    """
    made = {one.id for one in records if isinstance(one, Item)}
    for one in records:
        for student in students_of(one):
            if student not in shown.rows:
                raise _wrong(f"there is no student `{student[:80]}` in this class", _AGAIN)
        if isinstance(one, Give) and one.item not in shown.items and one.item not in made:
            raise _wrong(f"there is no rubric item `{one.item}`", _AGAIN)
    return tuple(_completed(one, shown) for one in records)


def _completed(one: Decision, shown: Facts) -> Decision:
    match one:
        case Comment() | Finish():
            return replace(one, program=shown.rows[one.student].program)
        case Give() | ChangeMark():
            return replace(one, programs={k: shown.rows[k].program for k in one.students})
        case Item() if not one.after and one.id in shown.items:
            return replace(one, after=(shown.items[one.id],))
        case _:
            return one


def _wrong(headline: str, remedy: str) -> Refused:
    found: tuple[Diagnostic, ...] = (error(BAD_RECORD, headline, help=(remedy,)),)
    return Refused(found)
