"""Rubric items with every version of them, so that a change for all can be undone later, too."""

from collections import defaultdict
from collections.abc import Mapping
from fractions import Fraction

from vrts.desk.told import ItemTold, VersionTold
from vrts.marking.by_hand.decisions.items import ItemNow
from vrts.marking.by_hand.decisions.ledger import Filed, Ledger
from vrts.marking.by_hand.decisions.records import Give, Item
from vrts.marking.by_hand.decisions.state import State
from vrts.marking.exports.numbers import number


def items_told(ledger: Ledger, state: State, undone: Mapping[str, str]) -> tuple[ItemTold, ...]:
    """Return the items: those that are in use or withdrawn, then those of which all is undone.

    Args:
        ledger: The records that whoever looks may see.
        state: What they come to.
        undone: By name of a record, that of the undo.
    """
    versions: dict[str, list[Filed]] = defaultdict(list)
    for one in ledger.records:
        if isinstance(one.said, Item):
            versions[one.said.id].append(one)
    told = {
        name: tuple(_version(one, undone.get(one.name)) for one in sorted(made, key=_when))
        for name, made in versions.items()
    }
    given = _students(state)
    gone = sorted(told.keys() - state.items.keys())
    return (
        *(_item(one, tuple(given[name]), told[name]) for name, one in state.items.items()),
        *(_gone(name, told[name]) for name in gone),
    )


def _students(state: State) -> Mapping[str, Mapping[str, None]]:
    given: dict[str, dict[str, None]] = defaultdict(dict)
    for student, found in state.students.items():
        for one in found.given:
            if isinstance(one.said, Give):
                given[one.said.item][student] = None
    return given


def _when(one: Filed) -> tuple[str, str, int]:
    return one.said.at, one.grader, one.said.number


def _version(one: Filed, undone_by: str | None) -> VersionTold:
    said = one.said
    assert isinstance(said, Item)
    points = _points(Fraction(said.points))
    what = said.title, points, said.withdrawn
    return VersionTold(one.name, one.grader, one.who, said.at, *what, undone_by)


def _item(one: ItemNow, students: tuple[str, ...], versions: tuple[VersionTold, ...]) -> ItemTold:
    points = _points(one.points)
    return ItemTold(one.id, one.title, points, one.version, students, one.withdrawn, versions)


def _gone(name: str, versions: tuple[VersionTold, ...]) -> ItemTold:
    """Return an item of which every version is undone: it has none that could be given."""
    last = versions[-1]
    return ItemTold(name, last.title, last.points, "", (), withdrawn=True, versions=versions)


def _points(value: Fraction) -> float:
    return float(number(value))
