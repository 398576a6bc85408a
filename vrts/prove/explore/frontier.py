"""Futures that wait to be looked at: the fewest decisions first, then the earliest.

One that goes on for very long without a decision would keep all others waiting. So each span of
`LONG` ticks counts as much as a decision.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from heapq import heappop, heappush

from vrts.engine.machine.machine import Machine
from vrts.prove.certify.memory import Memory
from vrts.prove.graph.past import Past
from vrts.prove.properties.monitor import Memory as Watched

LONG = 2_500  # ticks


@dataclass(slots=True)
class Future:
    """A machine that goes on, and how it came to be."""

    leg: int  # of the graph of states: the one that it is on
    machine: Machine
    past: Past | None
    cost: int  # decisions that differ from "nothing happens"
    inputs: Mapping[int, bool]  # as they were decided last
    outside: object  # state of what the environment says of inputs
    branch: int | None  # in the tree of decisions
    memory: Memory  # what the rules of contacts remember
    again: int = 0  # how often the program was executed before
    stopped: bool = False  # the operator has stopped it
    asked: bool = False  # outside has decided something in the tick under way
    watched: Watched = ()  # what is remembered of properties


class Frontier:
    """A queue of futures; its order depends on nothing but them."""

    def __init__(self) -> None:
        """Hold nothing."""
        self._heap: list[tuple[int, int, int, Future]] = []
        self._pushed = 0

    def __len__(self) -> int:
        """Return how many wait."""
        return len(self._heap)

    def push(self, future: Future) -> None:
        """Let a future wait."""
        self._pushed += 1
        heappush(self._heap, (*_turn(future), self._pushed, future))

    def pop(self) -> Future:
        """Return the next future."""
        return heappop(self._heap)[3]

    def is_earlier(self, future: Future) -> bool:
        """Return whether another future has its turn before this one."""
        return bool(self._heap) and self._heap[0][:2] < _turn(future)

    def waiting(self) -> list[Future]:
        """Return the futures that wait, in the order of their turns."""
        return [entry[3] for entry in sorted(self._heap, key=_order)]


def _turn(future: Future) -> tuple[int, int]:
    """Return what tells whose turn it is: the least first."""
    tick = _tick(future)
    return future.cost + tick // LONG, tick


def _tick(future: Future) -> int:
    """Return the tick in which a future goes on."""
    machine = future.machine
    return machine.next_tick if machine.mid is None else machine.last_tick


def _order(entry: tuple[int, int, int, Future]) -> tuple[int, int, int]:
    return entry[:3]
