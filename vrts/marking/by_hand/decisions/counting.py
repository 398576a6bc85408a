"""Which records count: all that nobody has undone, where what was undone may be undone in turn."""

from collections import defaultdict
from collections.abc import Iterable
from typing import NamedTuple

from vrts.marking.by_hand.decisions.ledger import Filed
from vrts.marking.by_hand.decisions.records import Undo


class Counted(NamedTuple):
    """Records that count, and what has undone the others."""

    counting: tuple[Filed, ...]  # in the order of the records, without undos
    undone: dict[str, str]  # by name of a record, that of the undo
    circular: tuple[str, ...]  # undos that undo each other in a circle: they have no effect
    unknown: tuple[tuple[str, str], ...]  # undos, and names of records that are not there


def counted(records: Iterable[Filed]) -> Counted:
    """Return which records count.

    A record counts where no undo of it does. Undos in a circle, of which only hostile files have
    any, have no effect.
    """
    every = {one.name: one for one in records}
    undos = {name: one.said.records for name, one in every.items() if isinstance(one.said, Undo)}
    by: dict[str, list[str]] = defaultdict(list)  # by record, its undos
    for name in sorted(undos):
        for target in undos[name]:
            if target in every:
                by[target].append(name)
    holds = _holding(undos, by)
    undone: dict[str, str] = {}
    for target, names in by.items():
        found = [name for name in names if holds.get(name)]
        if found:
            undone[target] = found[0]
    return Counted(
        tuple(one for one in every.values() if one.name not in undone and one.name not in undos),
        undone,
        tuple(name for name in undos if name not in holds),
        tuple((name, to) for name, names in undos.items() for to in names if to not in every),
    )


def _holding(undos: Iterable[str], by: dict[str, list[str]]) -> dict[str, bool]:
    """Return of every undo whether it counts; those in circles are left out.

    The grounded labelling: what is undone by nothing counts, what such a one undoes does not.
    """
    names = set(undos)
    waiting = {name: len(by.get(name, ())) for name in names}  # undos of it not known to be undone
    targets: dict[str, list[str]] = defaultdict(list)
    for target, sources in by.items():
        for source in sources:
            if target in names:
                targets[source].append(target)
    holds: dict[str, bool] = {}
    ready = sorted((name for name in names if not waiting[name]), reverse=True)
    while ready:
        name = ready.pop()
        if name in holds:
            continue
        holds[name] = True
        for target in targets[name]:
            if target in holds:
                continue
            holds[target] = False
            for further in targets[target]:
                waiting[further] -= 1
                if not waiting[further] and further not in holds:
                    ready.append(further)
    return holds
