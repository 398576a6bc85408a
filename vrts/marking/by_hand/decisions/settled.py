"""Which of several decisions about one thing counts; where graders differ, none does."""

from collections.abc import Callable, Hashable, Iterable, Sequence
from typing import NamedTuple

from vrts.marking.by_hand.decisions.ledger import Filed
from vrts.marking.by_hand.decisions.records import Decide

Side = tuple[Filed, ...]  # records of one grader about one thing


class Settled(NamedTuple):
    """What counts about one thing."""

    kept: tuple[Filed, ...]  # that say the same; empty: nothing counts
    decided: Filed | None = None  # the `decide` that it rests on
    sides: tuple[Filed, ...] = ()  # of a conflict


class SettledSides(NamedTuple):
    """What counts about one thing, of which a grader may have said more than once."""

    kept: tuple[Side, ...]  # that come to the same; empty: nothing counts
    decided: Filed | None = None  # the `decide` that it rests on
    sides: tuple[Side, ...] = ()  # of a conflict


def settled(
    records: Sequence[Filed],
    content: Callable[[Filed], Hashable],
    decides: Iterable[Filed],
    student: str = "",
) -> Settled:
    """Return which records about one thing count.

    Args:
        records: About it, one of each grader.
        content: What a record comes to; those with the same are no conflict.
        decides: Of all graders, in the order of their files.
        student: Whom it is about; "": all of them, as an item is.
    """
    sides = tuple((one,) for one in records)
    found = settled_sides(sides, lambda side: content(side[0]), decides, student)
    kept, still = (tuple(side[0] for side in some) for some in (found.kept, found.sides))
    return Settled(kept, found.decided, still)


def settled_sides(
    sides: Sequence[Side],
    content: Callable[[Side], Hashable],
    decides: Iterable[Filed],
    student: str = "",
) -> SettledSides:
    """Return which sides count: a `decide` keeps all of a side by any record of it.

    A side is out of the way only where a `decide` names all of its records: what its grader has
    added since was not known then.
    """
    if len({content(side) for side in sides}) < 2:
        return SettledSides(tuple(sides))
    holder = {one.name: k for k, side in enumerate(sides) for one in side}
    last: dict[str, Filed] = {}
    for one in decides:
        said = one.said
        assert isinstance(said, Decide)
        if said.students and student not in said.students:
            continue
        if said.keep in holder and any(holder.get(name) is not None for name in said.over):
            last[one.grader] = one
    found = [one.said for one in last.values() if isinstance(one.said, Decide)]
    keeps = {holder[said.keep] for said in found}
    if len(keeps) != 1:
        return SettledSides((), None, tuple(sides))
    over = {name for said in found for name in said.over}
    left = tuple(
        side
        for k, side in enumerate(sides)
        if k in keeps or not all(one.name in over for one in side)
    )
    if len({content(side) for side in left}) > 1:
        return SettledSides((), None, left)
    return SettledSides(left, min(last.values()))
