"""What seems to go wrong in a future: told as wrong only once a full replay shows it."""

from typing import NamedTuple

from vrts.engine.memory.events import Cause
from vrts.prove.graph.past import Past
from vrts.prove.proof import Wrong


class Suspect(NamedTuple):
    """Something that seems to go wrong."""

    wrong: Wrong
    what: tuple[str, ...]  # with `wrong` and the step it tells causes apart: bodies, a code
    headline: str
    time_s: float
    cause: Cause | None
    past: Past | None
    cost: int
    steps: frozenset[tuple[str, int]] = frozenset()  # programs and steps of a loop
    where: object = None  # where the robot program is, if the step is not known
    certain: bool = True  # not: it may turn out to be within what is allowed

    @property
    def order(self) -> tuple[int, float, str, tuple[str, ...]]:
        """The fewest decisions first, then the earliest."""
        return (self.cost, round(self.time_s, 6), self.wrong.value, self.what)

    @property
    def why(self) -> tuple[object, ...]:
        """What is the same of two that have the same cause."""
        where = self.where if self.cause is None else (self.cause.program, self.cause.step)
        return (self.wrong, self.what, where)


class End(NamedTuple):
    """How futures end, by the one that came to it first."""

    past: Past | None
    cost: int
    time_s: float


class Suspects:
    """The shortest of each cause."""

    def __init__(self) -> None:
        """Suspect nothing."""
        self._shortest: dict[tuple[object, ...], Suspect] = {}

    def __len__(self) -> int:
        """Return how many causes there are."""
        return len(self._shortest)

    def add(self, suspect: Suspect) -> None:
        """Keep a suspect if none of the same cause is shorter."""
        known = self._shortest.get(suspect.why)
        if known is None or suspect.order < known.order:
            self._shortest[suspect.why] = suspect

    def in_order(self) -> list[Suspect]:
        """Return the shortest of each cause, the shortest first."""
        return sorted(self._shortest.values(), key=_order)


def _order(suspect: Suspect) -> tuple[int, float, str, tuple[str, ...]]:
    return suspect.order
