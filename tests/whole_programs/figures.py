"""What trials have found together, and what they have not come to."""

from collections import Counter
from collections.abc import Callable, Iterable
from typing import NamedTuple, get_args

from tests.whole_programs.trial import Outcome
from vrts.engine.code.steps.extent import simulates
from vrts.ir.instructions import Instruction


class Figures(NamedTuple):
    """Sums of outcomes."""

    programs: int
    faults: tuple[tuple[int, str], ...]  # with the number of the program
    executed: Counter[type[Instruction]]
    endings: Counter[str]
    hopeless: int
    unfinished: int

    @property
    def missing(self) -> list[str]:
        """Names of the kinds of instructions that are carried out and never were."""
        return sorted(kind.__name__ for kind in carried_out() if not self.executed[kind])

    def lines(self) -> list[str]:
        """Return the figures as text."""
        many = sum(self.executed.values())
        rare = self.executed.most_common()[:-9:-1]
        endings = ", ".join(f"{name} {count}" for name, count in self.endings.most_common(16))
        return [
            f"{self.programs:,} programs, {many:,} statements, {len(self.faults)} internal faults",
            f"{len(self.executed)} of {len(carried_out())} kinds of instructions executed",
            "rarest: " + ", ".join(f"{kind.__name__} {count}" for kind, count in rare),
            f"ended early as hopeless {self.hopeless}, at a limit of the run {self.unfinished}",
            f"endings: {endings}",
            *(f"program {number}: {fault}" for number, fault in self.faults[:20]),
        ]


def carried_out() -> list[type[Instruction]]:
    """Return the kinds of instructions that the engine carries out."""
    kinds: tuple[type[Instruction], ...] = get_args(Instruction)
    return [kind for kind in kinds if simulates(_blank(kind))]


def _blank(kind: type[Instruction]) -> Instruction:
    make: Callable[[Iterable[object]], Instruction] = kind._make
    return make([None] * len(kind._fields))


def summed(outcomes: Iterable[Outcome]) -> Figures:
    """Return the figures of some outcomes."""
    found = list(outcomes)
    executed: Counter[type[Instruction]] = Counter()
    for outcome in found:
        executed += outcome.executed
    return Figures(
        len(found),
        tuple((outcome.number, fault) for outcome in found for fault in outcome.faults),
        executed,
        Counter(ending for outcome in found for ending in set(outcome.endings)),
        sum(outcome.hopeless for outcome in found),
        sum(outcome.unfinished for outcome in found),
    )
