"""Binary signals: outputs, inputs that change as the scenario says, and internal signals."""

from collections.abc import Sequence

from vrts.base.source import Span
from vrts.engine.faults import RuntimeFault
from vrts.ir.ranges import INPUTS, INTERNAL, OUTPUTS
from vrts.ir.runtime_errors import RuntimeErrorKind

__all__ = ["INPUTS", "INTERNAL", "OUTPUTS", "Signals", "known"]


class Signals:
    """Which signals are on, and the inputs still to change."""

    __slots__ = ("_inputs", "_next", "_stuck", "changes", "on")

    def __init__(self, inputs: Sequence[tuple[float, int, bool]]) -> None:
        """Take the inputs in time order."""
        self.on: set[int] = set()
        self.changes = 0  # how often a signal changed
        self._inputs = tuple(inputs)
        self._next = 0
        self._stuck: frozenset[int] = frozenset()  # inputs that do not change any more

    def sample(self, time_s: float) -> list[tuple[int, bool]]:
        """Take over the inputs up to a time; return those that changed."""
        changed: list[tuple[int, bool]] = []
        while self._next < len(self._inputs) and self._inputs[self._next][0] <= time_s:
            _, number, state = self._inputs[self._next]
            self._next += 1
            if self.turn(number, on=state):
                changed.append((number, state))
        return changed

    def stick(self, number: int, *, on: bool) -> bool:
        """Keep an input in a state from now on; return whether that changes it."""
        changes = self.turn(number, on=on)
        self._stuck |= {number}
        return changes

    @property
    def next_input_s(self) -> float | None:
        """When an input changes next [s]; None when none will."""
        if self._next == len(self._inputs):
            return None
        return self._inputs[self._next][0]

    def turn(self, number: int, *, on: bool) -> bool:
        """Turn a signal on or off, unless it is stuck; return whether that changes it."""
        if on is (number in self.on) or number in self._stuck:
            return False
        self.changes += 1
        if on:
            self.on.add(number)
        else:
            self.on.discard(number)
        return True

    def holds(self, number: int, span: Span | None) -> bool:
        """Return whether a signal is in the state its sign asks for; 0 always is.

        Raises:
            RuntimeFault: There is no such signal.
        """
        if number == 0:
            return True
        known(number, span)
        return (abs(number) in self.on) is (number > 0)

    def copy(self) -> "Signals":
        """Return an independent copy."""
        other = Signals.__new__(Signals)
        other.on, other._inputs = self.on.copy(), self._inputs
        other._next, other._stuck, other.changes = self._next, self._stuck, self.changes
        return other


def known(number: int, span: Span | None, *, writable: bool = False) -> None:
    """Check a signal number.

    Raises:
        RuntimeFault: There is no such signal, or it is an input that a program wants to set.
    """
    signal = abs(number)
    if signal in OUTPUTS or signal in INTERNAL:
        return
    if signal in INPUTS and not writable:
        return
    reason = "is an input; a program cannot set it" if signal in INPUTS else "does not exist"
    raise RuntimeFault(
        RuntimeErrorKind.ILLEGAL_SIGNAL,
        f"signal {signal} {reason}",
        span,
        notes=("outputs are 1 to 32, inputs 1001 to 1032, internal signals 2001 to 2256",),
    )
