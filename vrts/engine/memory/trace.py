"""Which statements a program executed, so that any of them can be looked back at.

Statements of both programs share one numbering; `finished` counts them. A trace keeps the
instruction of every statement of one program, and where its slices begin in that numbering.
"""

from array import array
from bisect import bisect_right
from typing import NamedTuple, Union

from vrts.engine.memory.cells import Bound


class Activation(NamedTuple):
    """A program that is being executed, and what called it."""

    program: int  # number of the executable program
    slots: list[Bound]
    called_from: int | None  # instruction; None for the first program
    caller: Union["Activation", None]


class Trace:
    """Statements and calls of one program. Copies share them until `cut` parts them."""

    __slots__ = (
        "activations",
        "begun",
        "changed",
        "counts",
        "instructions",
        "rested",
        "resting",
    )

    def __init__(self) -> None:
        """Start empty."""
        self.instructions = array("I")  # one for every statement, in order
        self.begun = array("I")  # statements finished when a slice began
        self.counts = array("I")  # of them, those of this program
        self.rested = array("I")  # statements finished when the program rested: waited, had used
        # its share of a tick, or was given a command
        self.resting = array("I")  # beside `rested`: the instruction that came next
        self.changed = array("I")  # statements finished when the innermost program changed
        self.activations: list[Activation | None] = []  # beside `changed`

    def begin_slice(self, finished: int) -> None:
        """Note that this program goes on after a number of finished statements."""
        self.begun.append(finished)
        self.counts.append(len(self.instructions))

    def rest(self, finished: int, instruction: int) -> None:
        """Note which instruction comes next, where this program waits or the tick is over."""
        if self.rested and self.rested[-1] == finished and self.resting[-1] == instruction:
            return
        self.rested.append(finished)
        self.resting.append(instruction)

    def activate(self, finished: int, activation: Activation | None) -> None:
        """Note the innermost program from a number of finished statements on."""
        self.changed.append(finished)
        self.activations.append(activation)

    def executed(self, finished: int) -> int:
        """Return how many statements of this program are among the first so many."""
        k = bisect_right(self.begun, finished) - 1
        if k < 0:
            return 0
        count = self.counts[k] + finished - self.begun[k]
        following = self.counts[k + 1] if k + 1 < len(self.counts) else len(self.instructions)
        return min(count, following)

    def following(self, finished: int, known: int) -> int | None:
        """Return the instruction that comes next after so many statements, if it was reached.

        Args:
            finished: Number of finished statements.
            known: How many there are; what comes later belongs to another future.
        """
        k = bisect_right(self.rested, finished) - 1
        count = self.executed(finished)
        if k >= 0 and self.executed(self.rested[k]) == count:  # it has rested since
            return self.resting[k]
        return self.instructions[count] if count < self.executed(known) else None

    def activation(self, finished: int) -> Activation | None:
        """Return the innermost program after so many statements."""
        k = bisect_right(self.changed, finished) - 1
        return self.activations[k] if k >= 0 else None

    def copy(self) -> "Trace":
        """Return a trace that shares the past."""
        other = Trace.__new__(Trace)
        other.instructions = self.instructions
        other.begun, other.counts = self.begun, self.counts
        other.rested, other.resting = self.rested, self.resting
        other.changed, other.activations = self.changed, self.activations
        return other

    def cut(self, finished: int) -> None:
        """Keep a past of its own, up to a number of finished statements."""
        self.instructions = self.instructions[: self.executed(finished)]
        kept = bisect_right(self.begun, finished)
        self.begun, self.counts = self.begun[:kept], self.counts[:kept]
        kept = bisect_right(self.rested, finished)
        self.rested, self.resting = self.rested[:kept], self.resting[:kept]
        kept = bisect_right(self.changed, finished)
        self.changed, self.activations = self.changed[:kept], self.activations[:kept]
