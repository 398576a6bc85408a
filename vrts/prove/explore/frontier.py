"""Futures that wait to be looked at: the fewest decisions first, then the earliest.

One that goes on for very long without a decision would keep all others waiting. So each span of
`LONG` ticks counts as much as a decision.

Once much was looked at, and where that is asked for, those come first that are at steps where the
fewest states were: there a search may still find what it has not seen.
"""

from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass
from heapq import heappop, heappush
from typing import TypeAlias

from vrts.engine.machine.machine import Machine
from vrts.prove.certify.memory import Memory
from vrts.prove.graph.past import Past
from vrts.prove.properties.monitor import Memory as Watched

LONG = 2_500  # ticks
Turn: TypeAlias = tuple[int, int, int]


@dataclass(slots=True)
class Future:
    """A machine that goes on, and how it came to be."""

    leg: int  # of the graph of states: the one that it is on
    machine: Machine
    past: Past | None
    cost: int  # decisions that differ from "nothing happens"
    inputs: Mapping[int, float]  # as they were decided last; analog ones are -1 to -8
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
        self._heap: list[tuple[Turn, int, Future]] = []
        self._pushed = 0
        self._visits: Counter[object] = Counter()  # states, by the steps of both programs
        self._spreads = False

    def __len__(self) -> int:
        """Return how many wait."""
        return len(self._heap)

    def __bool__(self) -> bool:
        """Return whether any waits."""
        return bool(self._heap)

    def push(self, future: Future) -> None:
        """Let a future wait."""
        self._pushed += 1
        heappush(self._heap, (self._turn(future), self._pushed, future))

    def pop(self) -> Future:
        """Return the next future."""
        return heappop(self._heap)[2]

    def is_earlier(self, future: Future) -> bool:
        """Return whether another future has its turn before this one."""
        return bool(self._heap) and self._heap[0][0] < self._turn(future)

    def visits(self, future: Future) -> None:
        """Count a state that a future has come to before any other."""
        self._visits[_steps(future.machine)] += 1

    def spread(self) -> None:
        """From now on, let those go first that are where the fewest states were."""
        if self._spreads:
            return
        self._spreads = True
        waiting = self.waiting()
        self._heap.clear()
        for future in waiting:
            self.push(future)

    def waiting(self) -> list[Future]:
        """Return the futures that wait, in the order of their turns."""
        return [entry[2] for entry in sorted(self._heap, key=_order)]

    def _turn(self, future: Future) -> Turn:
        """Return what tells whose turn it is: the least first."""
        tick = _tick(future)
        states = self._visits[_steps(future.machine)] if self._spreads else 0
        return states, future.cost + tick // LONG, tick


def _tick(future: Future) -> int:
    """Return the tick in which a future goes on."""
    machine = future.machine
    return machine.next_tick if machine.mid is None else machine.last_tick


def _steps(machine: Machine) -> object:
    """Return at which steps both programs are, and what called them."""
    robot, other = machine.robot.frames, machine.process.frames
    at = [(frame.program, frame.index) for frame in robot]
    return tuple(at), tuple([(frame.program, frame.index) for frame in other]) if other else ()


def _order(entry: tuple[Turn, int, Future]) -> tuple[Turn, int]:
    return entry[:2]
