"""Which statements a program executed, so that any of them can be looked back at.

Statements of both programs share one numbering; `finished` counts them. A trace keeps the
instruction of every statement of one program, and where its slices begin in that numbering.
"""

from array import array
from bisect import bisect_right
from typing import TYPE_CHECKING, NamedTuple, Union

if TYPE_CHECKING:
    from vrts.engine.cells import Bound


class Activation(NamedTuple):
    """A program that is being executed, and what called it."""

    program: int  # number of the executable program
    slots: "list[Bound]"
    called_from: int | None  # instruction; None for the first program
    caller: Union["Activation", None]


class Trace:
    """Statements and calls of one program. Copies share them until `cut` parts them."""

    __slots__ = ("_activations", "_begun", "_changed", "_counts", "instructions")

    def __init__(self) -> None:
        """Start empty."""
        self.instructions = array("I")  # one for every statement, in order
        self._begun = array("I")  # statements finished when a slice began
        self._counts = array("I")  # of them, those of this program
        self._changed = array("I")  # statements finished when the innermost program changed
        self._activations: list[Activation | None] = []  # beside `_changed`

    def begin_slice(self, finished: int) -> None:
        """Note that this program goes on after a number of finished statements."""
        self._begun.append(finished)
        self._counts.append(len(self.instructions))

    def activate(self, finished: int, activation: Activation | None) -> None:
        """Note the innermost program from a number of finished statements on."""
        self._changed.append(finished)
        self._activations.append(activation)

    def executed(self, finished: int) -> int:
        """Return how many statements of this program are among the first so many."""
        k = bisect_right(self._begun, finished) - 1
        if k < 0:
            return 0
        count = self._counts[k] + finished - self._begun[k]
        following = self._counts[k + 1] if k + 1 < len(self._counts) else len(self.instructions)
        return min(count, following)

    def following(self, finished: int) -> int | None:
        """Return the instruction that comes next after so many statements, if it was reached."""
        count = self.executed(finished)
        return self.instructions[count] if count < len(self.instructions) else None

    def activation(self, finished: int) -> Activation | None:
        """Return the innermost program after so many statements."""
        k = bisect_right(self._changed, finished) - 1
        return self._activations[k] if k >= 0 else None

    def copy(self) -> "Trace":
        """Return a trace that shares the past."""
        other = Trace.__new__(Trace)
        other.instructions = self.instructions
        other._begun, other._counts = self._begun, self._counts
        other._changed, other._activations = self._changed, self._activations
        return other

    def cut(self, finished: int) -> None:
        """Keep a past of its own, up to a number of finished statements."""
        self.instructions = self.instructions[: self.executed(finished)]
        kept = bisect_right(self._begun, finished)
        self._begun, self._counts = self._begun[:kept], self._counts[:kept]
        kept = bisect_right(self._changed, finished)
        self._changed, self._activations = self._changed[:kept], self._activations[:kept]
