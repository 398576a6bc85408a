"""Rubric items as they are now: the latest version of each, from whoever changed it."""

from collections import defaultdict
from collections.abc import Iterable
from fractions import Fraction
from typing import NamedTuple

from vrts.marking.by_hand.decisions.ledger import Filed
from vrts.marking.by_hand.decisions.records import Item
from vrts.marking.by_hand.decisions.settled import Settled, settled


class ItemNow(NamedTuple):
    """A rubric item."""

    id: str
    title: str
    points: Fraction  # added to the mark
    version: str  # name of the record that says so
    who: str
    withdrawn: bool = False
    differing: bool = False  # versions differ: it gives nobody anything
    at: str = ""  # when this version was written, ISO 8601


class Items(NamedTuple):
    """All items, and those on which graders differ."""

    items: dict[str, ItemNow]  # by id
    conflicts: dict[str, tuple[Filed, ...]]  # by id, versions


def items_of(every: Iterable[Filed], counting: Iterable[Filed], decides: Iterable[Filed]) -> Items:
    """Return the items as they are now.

    Args:
        every: Versions of items, also those that are undone: they tell what replaces what.
        counting: Those that count.
        decides: Of all graders.
    """
    said = [one for one in every if isinstance(one.said, Item)]
    before = _before(said)
    heads: dict[str, list[Filed]] = defaultdict(list)
    for one in counting:
        if isinstance(one.said, Item):
            heads[one.said.id].append(one)
    found: dict[str, ItemNow] = {}
    conflicts: dict[str, tuple[Filed, ...]] = {}
    settles = tuple(decides)
    for name in sorted(heads):
        latest = [one for one in heads[name] if not _replaced(one, heads[name], before)]
        one = settled(latest, _content, settles)
        found[name] = _item(name, one)
        if one.sides:
            conflicts[name] = one.sides
    return Items(found, conflicts)


def _before(said: list[Filed]) -> dict[str, set[str]]:
    """Return for every version which ones it takes the place of, directly or not."""
    direct: dict[str, set[str]] = {}
    last: dict[tuple[str, str], str] = {}
    about = {one.name: one.said.id for one in said if isinstance(one.said, Item)}
    for one in said:
        assert isinstance(one.said, Item)
        key = one.grader, one.said.id
        named = {name for name in one.said.after if about.get(name) == one.said.id}
        direct[one.name] = named | ({last[key]} if key in last else set())
        last[key] = one.name
    whole: dict[str, set[str]] = {}
    for name in direct:
        reached: set[str] = set()
        ahead = list(direct[name])
        while ahead:
            other = ahead.pop()
            if other not in reached:
                reached.add(other)
                ahead += whole[other] if other in whole else direct[other]
        whole[name] = reached
    return whole


def _replaced(one: Filed, others: list[Filed], before: dict[str, set[str]]) -> bool:
    """Return whether a version is behind another; those in a circle are beside each other."""
    return any(
        one.name in before[other.name] and other.name not in before[one.name] for other in others
    )


def _content(one: Filed) -> tuple[str, Fraction, bool]:
    assert isinstance(one.said, Item)
    return one.said.title.strip(), Fraction(one.said.points), one.said.withdrawn


def _item(name: str, one: Settled) -> ItemNow:
    record = (one.kept or one.sides)[0]
    said = record.said
    assert isinstance(said, Item)
    points = Fraction(0) if one.sides else Fraction(said.points)
    differing = bool(one.sides)
    return ItemNow(
        name,
        said.title,
        points,
        record.name,
        record.who,
        said.withdrawn and not differing,
        differing,
        said.at,
    )
