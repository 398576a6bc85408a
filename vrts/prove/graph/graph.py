"""Which state follows which, and from which states no future ever ends."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import NamedTuple, TypeAlias

from vrts.prove.certify.touching import Outcome
from vrts.prove.graph.past import Past
from vrts.prove.proof import Decided

AWAY = -1  # stands for the end of a future, and for what was not looked at


Place: TypeAlias = tuple[tuple[int, int], ...]  # program and instruction of each frame


class Visit(NamedTuple):
    """How a state was come to first."""

    past: Past | None
    tick: int
    cost: int
    place: Place  # where the robot program is
    waits: bool  # it can go on only when something changes
    asks: bool  # outside decides here
    leg: int = 0  # that came to it first


@dataclass(slots=True)
class Leg:
    """The way of a future from one state to the next."""

    start: int | None  # a state; None: the beginning
    past: Past | None
    cost: int
    decided: Decided | None  # with which it began
    to: int = AWAY  # a state, where it has come to one
    tick: int = 0  # in which it came there
    outcomes: tuple[Outcome, ...] = ()  # what decides about touches before, in time order


class Graph:
    """States and the legs between them, by number, in the order in which they were come to."""

    def __init__(self) -> None:
        """Know no state."""
        self.visits: list[Visit] = []
        self.legs: list[Leg] = []
        self._from: list[list[int]] = []  # numbers of legs

    def add(self, visit: Visit) -> int:
        """Add a state; return its number."""
        self.visits.append(visit)
        self._from.append([])
        return len(self.visits) - 1

    def begin(
        self, start: int | None, past: Past | None, cost: int, decided: Decided | None = None
    ) -> int:
        """Add a leg that comes to no state yet; return its number."""
        self.legs.append(Leg(start, past, cost, decided))
        if start is not None:
            self._from[start].append(len(self.legs) - 1)
        return len(self.legs) - 1

    def arrives(self, leg: int, to: int, tick: int) -> None:
        """Note to which state a leg has come."""
        self.legs[leg].to, self.legs[leg].tick = to, tick

    def legs_from(self, state: int) -> list[Leg]:
        """Return the legs that begin in a state."""
        return [self.legs[number] for number in self._from[state]]

    def closed(self) -> Iterator[list[int]]:
        """Yield sets of states that futures come round to for ever, the first found first."""
        ways = self._following()
        component = _components(ways)
        members: dict[int, list[int]] = {}
        leaves: set[int] = set()
        for state, following in enumerate(ways):
            own = component[state]
            members.setdefault(own, []).append(state)
            if not following or any(to == AWAY or component[to] != own for to in following):
                leaves.add(own)
        yield from (states for own, states in members.items() if own not in leaves)

    def staying(self) -> Iterator[int]:
        """Yield states in which the robot program waits and never comes away, the first first."""
        ways = self._following()
        away = [
            any(to == AWAY or self.visits[to].place != visit.place for to in following)
            or not visit.waits
            or not following
            for visit, following in zip(self.visits, ways, strict=True)
        ]
        before: list[list[int]] = [[] for _ in self.visits]
        for state, following in enumerate(ways):
            for to in following:
                if to != AWAY:
                    before[to].append(state)
        left = [state for state, goes in enumerate(away) if goes]
        while left:
            for state in before[left.pop()]:
                if not away[state]:
                    away[state] = True
                    left.append(state)
        yield from (state for state, goes in enumerate(away) if not goes)

    def _following(self) -> list[list[int]]:
        """Return for each state those that follow; AWAY for an end and for what is open."""
        return [[self.legs[number].to for number in numbers] for numbers in self._from]


def _components(following: Sequence[Sequence[int]]) -> list[int]:
    """Return for each state the number of its strongly connected component (Tarjan)."""
    index = [-1] * len(following)
    low = [0] * len(following)
    component = [-1] * len(following)
    stack: list[int] = []
    count = 0
    for root in range(len(following)):
        if index[root] >= 0:
            continue
        work = [(root, 0)]
        while work:
            state, k = work.pop()
            if k == 0:
                index[state] = low[state] = count
                count += 1
                stack.append(state)
            ways = following[state]
            while k < len(ways):
                to = ways[k]
                k += 1
                if to == AWAY:
                    continue
                if index[to] < 0:
                    work.append((state, k))
                    work.append((to, 0))
                    break
                if component[to] < 0:
                    low[state] = min(low[state], index[to])
            else:
                if low[state] == index[state]:
                    while True:
                        member = stack.pop()
                        component[member] = state
                        if member == state:
                            break
                if work:
                    above = work[-1][0]
                    low[above] = min(low[above], low[state])
    return component
