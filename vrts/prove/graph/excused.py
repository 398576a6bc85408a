"""Touches that something later may excuse: on which ways nothing does."""

from collections import deque
from typing import NamedTuple

from vrts.engine.memory.records import INSTANT
from vrts.prove.certify.touching import Outcome, Touching, Unless
from vrts.prove.graph.graph import AWAY, Graph, Leg
from vrts.prove.graph.past import Past
from vrts.prove.proof import Decided


class _Way(NamedTuple):
    """A way on which nothing has decided yet."""

    leg: Leg
    past: Past | None  # of this future
    late: int  # ticks by which this future is behind the one that came along the leg first


class Contact(NamedTuple):
    """A way on which nothing excuses a touch, by its decisions."""

    past: Past | None


def not_excused(graph: Graph, touch: Touching, tick_s: float) -> Contact | None:
    """Return the shortest way on which nothing excuses a touch; None: it is excused on all.

    Args:
        graph: The states of all futures, and what was decided between them.
        touch: What may be excused later.
        tick_s: How often the controller looks [s].
    """
    assert touch.unless is not None
    first = graph.legs[touch.future]
    after = [one for one in first.outcomes if one.time_s >= touch.time_s - INSTANT]
    settled = _settled(after, touch.unless)
    if settled is not None:
        return None if settled else Contact(first.past)
    ways = deque([_Way(first, first.past, 0)])
    seen: set[int] = set()
    while ways:
        leg, past, late = ways.popleft()
        if leg.to == AWAY:
            return Contact(past)
        if leg.to in seen:
            continue
        seen.add(leg.to)
        late += leg.tick - graph.visits[leg.to].tick
        for following in graph.legs_from(leg.to):
            own = past
            if following.decided is not None:
                own = Past(past, _later(following.decided, late * tick_s))
            settled = _settled(following.outcomes, touch.unless)
            if settled is False:
                return Contact(own)
            if settled is None:
                ways.append(_Way(following, own, late))
    return None


def _settled(outcomes: tuple[Outcome, ...] | list[Outcome], unless: Unless) -> bool | None:
    """Return what the first outcome that decides says."""
    found = (outcome.settles(unless) for outcome in outcomes)
    return next((settles for settles in found if settles is not None), None)


def _later(decided: Decided, by_s: float) -> Decided:
    return decided._replace(time_s=decided.time_s + by_s) if by_s else decided
