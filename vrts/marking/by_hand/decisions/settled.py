"""Which of several decisions about one thing counts; where graders differ, none does."""

from collections.abc import Callable, Hashable, Iterable, Sequence
from typing import NamedTuple

from vrts.marking.by_hand.decisions.ledger import Filed
from vrts.marking.by_hand.decisions.records import Decide


class Settled(NamedTuple):
    """What counts about one thing."""

    kept: tuple[Filed, ...]  # that say the same; empty: nothing counts
    decided: Filed | None = None  # the `decide` that it rests on
    sides: tuple[Filed, ...] = ()  # of a conflict


def settled(
    records: Sequence[Filed], content: Callable[[Filed], Hashable], decides: Iterable[Filed]
) -> Settled:
    """Return which records about one thing count.

    Args:
        records: About it, one of each grader.
        content: What a record comes to; those with the same are no conflict.
        decides: Of all graders, in the order of their files.
    """
    if len({content(one) for one in records}) < 2:
        return Settled(tuple(records))
    names = {one.name for one in records}
    last: dict[str, Filed] = {}
    for one in decides:
        said = one.said
        assert isinstance(said, Decide)
        if said.keep in names and names.intersection(said.over):
            last[one.grader] = one
    keeps = {one.said.keep for one in last.values() if isinstance(one.said, Decide)}
    if len(keeps) != 1:
        return Settled((), None, tuple(records))
    over = {n for one in last.values() if isinstance(one.said, Decide) for n in one.said.over}
    left = tuple(one for one in records if one.name in keeps or one.name not in over)
    if len({content(one) for one in left}) > 1:
        return Settled((), None, left)
    return Settled(left, min(last.values()))
