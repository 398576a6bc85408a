"""What graders have decided about one student, for an appeal: nobody else is in it."""

from collections.abc import Iterator

import msgspec

from vrts.marking.by_hand.decisions.ledger import Filed, Ledger
from vrts.marking.by_hand.decisions.records import (
    Assign,
    ChangeMark,
    Comment,
    Decide,
    Decision,
    Excuse,
    Extend,
    Finish,
    Give,
    Item,
    Undo,
)


def about_student(ledger: Ledger, student: str) -> bytes:
    """Return the records about a student, one a line, with name and grader; b"" where none are.

    Also what was undone, the items, and what decided or undid them. Comments that are for those who
    mark only are left out: no mark rests on them.
    """
    mine = {one.name: said for one in ledger.records if (said := _mine(one.said, student))}
    items = {said.item for said in mine.values() if isinstance(said, Give)}
    versions = {
        one.name: one.said
        for one in ledger.records
        if isinstance(one.said, Item) and one.said.id in items
    }
    kept: dict[str, Decision] = {**mine, **versions}
    for one in ledger.records:  # in any order: an undo may undo another one
        if isinstance(one.said, Undo):
            kept[one.name] = one.said
        elif isinstance(one.said, Decide) and student in (one.said.students or (student,)):
            only = (student,) if one.said.students else ()
            kept[one.name] = msgspec.structs.replace(one.said, students=only)
    names = _reached(kept)
    lines = [
        msgspec.json.encode(_line(one, kept[one.name], names))
        for one in ledger.records
        if one.name in names
    ]
    return b"".join(line + b"\n" for line in lines)


def _mine(said: Decision, student: str) -> Decision | None:
    """Return a record without other students; None where it is not about this one."""
    match said:
        case Comment():
            return said if said.student == student and not said.private else None
        case Finish():
            return said if said.student == student else None
        case Give() | ChangeMark():
            programs = {key: value for key, value in said.programs.items() if key == student}
            return _only(msgspec.structs.replace(said, programs=programs), student)
        case Extend() | Excuse() | Assign():
            return _only(said, student)
        case _:
            return None


def _only(said: Give | ChangeMark | Extend | Excuse | Assign, student: str) -> Decision | None:
    if student not in said.students:
        return None
    return msgspec.structs.replace(said, students=(student,))


def _reached(kept: dict[str, Decision]) -> set[str]:
    """Return the names of records that are about the student, or about such records."""
    names = {name for name, said in kept.items() if not isinstance(said, Undo | Decide)}
    more = True
    while more:
        found = {name for name, said in kept.items() if names.intersection(_named(said))} - names
        names |= found
        more = bool(found)
    return names


def _named(said: Decision) -> tuple[str, ...]:
    match said:
        case Undo():
            return said.records
        case Decide():
            return (said.keep, *said.over)
        case _:
            return ()


def _line(one: Filed, said: Decision, names: set[str]) -> dict[str, object]:
    """Return a line; records about others are not named in it."""
    if isinstance(said, Undo):
        said = msgspec.structs.replace(said, records=tuple(_kept(said.records, names)))
    return {"record": one.name, "grader": one.who, **msgspec.to_builtins(said)}


def _kept(found: tuple[str, ...], names: set[str]) -> Iterator[str]:
    return (name for name in found if name in names)
