"""A second search, for events that are known: when may each be deepest?

The pairs of an event are looked at again, grown by what its deepest touch is short of. What is
left are the intervals in which it may be deepest to 0.1 mm.
"""

from collections.abc import Sequence
from functools import reduce
from typing import NamedTuple, TypeAlias

import numpy as np
import numpy.typing as npt

from vrts.check.collision.pairs.arm_state import Prober
from vrts.check.collision.pairs.findings import (
    BAND,
    REPORTED,
    SLACK,
    Leaves,
    Touch,
    leaves,
)
from vrts.check.collision.pairs.pair_rows import joined, narrowed
from vrts.check.collision.pairs.pairs import Plan
from vrts.check.collision.pairs.table import Pairs
from vrts.check.collision.search.search import search
from vrts.check.collision.telling.sought import Sought

Array: TypeAlias = npt.NDArray[np.float64]
Indices: TypeAlias = npt.NDArray[np.int64]


class Within(NamedTuple):
    """What is looked at."""

    todo: Plan
    pairs: Pairs  # those of the plan, the rigid ones last
    prober: Prober
    interval: tuple[float, float]  # [s]


def closer_look(look: Within, known: Sequence[Sought]) -> list[Sought]:
    """Return known events with the intervals in which they may be deepest.

    Args:
        look: The run and its pairs.
        known: Contacts, grazes and what may be either.
    """
    moving = look.todo.pairs
    parts = [
        narrowed(moving, *_reach(one, len(moving.first)), group=number)
        for number, one in enumerate(known)
        if np.isfinite(one.best)
    ]
    if not parts:
        return [rested(look, one) for one in known]
    pairs = reduce(joined, [own for own, _ in parts])
    origin = np.concatenate([own for _, own in parts])
    found = search(
        look.prober.arm,
        look.prober.curves,
        look.todo.solids,
        pairs,
        look.interval,
        look.prober.prover.proposer,
        clearance=False,
        band=-SLACK - BAND,
        nearest=True,
    )
    touches: list[list[Touch]] = [[] for _ in known]
    for touch in found.contacts:
        own = touch._replace(pair=int(origin[touch.pair]))
        touches[int(pairs.group[touch.pair])].append(own)
    kept = leaves(found.leaves)
    of, kept = pairs.group[kept.pair], kept._replace(pair=origin[kept.pair])
    return [
        rested(look, one.within(touches[number], kept.at(np.flatnonzero(of == number))))
        for number, one in enumerate(known)
    ]


def _reach(one: Sought, moving: int) -> tuple[Indices, tuple[float, float], Array]:
    """Return which pairs may be deepest in an event, when, and how deep they must be for that."""
    count = int(np.searchsorted(one.rows, moving))
    _, start_s, end_s, _ = one.episode
    above = one.above[:count]
    return one.rows[:count], (start_s - REPORTED, end_s + REPORTED), above - one.best - 2.0 * SLACK


def rested(look: Within, one: Sought) -> Sought:
    """Return an event with pairs that do not move one against the other as leaves too."""
    rows = one.rows[np.searchsorted(one.rows, len(look.todo.pairs.first)) :]
    starts, ends = look.pairs.start_s[rows], look.pairs.end_s[rows]
    at = np.flatnonzero((starts <= one.episode.end_s) & (one.episode.start_s <= ends))
    least = np.full(len(at), -np.inf)
    return one.within((), Leaves(rows[at], starts[at], starts[at], least))
