"""Signals: outputs, inputs that change as the scenario says, internal signals, analog inputs."""

from collections.abc import Sequence

from vrts.base.source import Span
from vrts.engine.faults import RuntimeFault
from vrts.engine.programs.outside import FreeSignals
from vrts.ir.ranges import INPUTS, INTERNAL, OUTPUTS
from vrts.ir.runtime_errors import RuntimeErrorKind

__all__ = ["INPUTS", "INTERNAL", "OUTPUTS", "Signals", "known"]


class Signals:
    """Which signals are on, what analog inputs read, and what of both is still to change."""

    __slots__ = ("_analog", "_inputs", "_next", "_next_count", "_stuck", "changes", "counts", "on")

    def __init__(
        self,
        inputs: Sequence[tuple[float, int, bool]],
        analog: Sequence[tuple[float, int, int]] = (),
    ) -> None:
        """Take the changes of inputs, and those of analog inputs, in time order."""
        self.on: set[int] = set()
        self.changes = 0  # how often a signal changed
        self.counts: dict[int, int] = {}  # of analog inputs that were told; others read 0
        self._inputs, self._analog = tuple(inputs), tuple(analog)
        self._next = self._next_count = 0
        self._stuck: frozenset[int] = frozenset()  # inputs that do not change any more

    def sample(self, time_s: float) -> list[tuple[int, bool]]:
        """Take over the inputs up to a time; return those that changed."""
        changed: list[tuple[int, bool]] = []
        while self._next < len(self._inputs) and self._inputs[self._next][0] <= time_s:
            _, number, state = self._inputs[self._next]
            self._next += 1
            if self.turn(number, on=state):
                changed.append((number, state))
        while self._next_count < len(self._analog) and self._analog[self._next_count][0] <= time_s:
            _, channel, counts = self._analog[self._next_count]
            self._next_count += 1
            if self.counts.get(channel, 0) != counts:
                self.changes += 1
            self.counts[channel] = counts
        return changed

    def stick(self, number: int, *, on: bool) -> bool:
        """Keep an input in a state from now on; return whether that changes it."""
        changes = self.turn(number, on=on)
        self._stuck |= {number}
        return changes

    @property
    def next_input_s(self) -> float | None:
        """When an input changes next [s], binary or analog; None when none will."""
        times = [entry[0] for entry in self._inputs[self._next : self._next + 1]]
        times += [entry[0] for entry in self._analog[self._next_count : self._next_count + 1]]
        return min(times, default=None)

    def count(self, channel: int) -> float:
        """Return what an analog input reads [counts].

        Raises:
            Undecided: It is free, and not decided in this tick.
        """
        if isinstance(self.on, FreeSignals) and -channel in self.on.free:
            return self.on.count(channel)
        return self.counts.get(channel, 0)

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
        other.counts = self.counts.copy() if self.counts else {}
        other._analog, other._next_count = self._analog, self._next_count
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
