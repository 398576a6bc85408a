"""One execution, at any time: what everybody asks who looks at a run."""

from vrts.engine.memory.records import pose_of
from vrts.engine.record import Record
from vrts.engine.state import State

__all__ = ["OutOfHorizon", "Run", "State", "pose_of"]


class OutOfHorizon(ValueError):  # noqa: N818 -- names the situation, as the glossary does
    """A time or a statement was asked for at which the run is not known."""

    def __init__(self, time_s: float, horizon_s: float) -> None:
        """Say which time, and how far the run reaches."""
        super().__init__(f"time {time_s} s is outside 0 to {horizon_s} s")
        self.time_s = time_s
        self.horizon_s = horizon_s


class Run(Record):
    """One execution up to its horizon. Immutable; `controller.advance` makes longer ones."""

    def at(self, time_s: float) -> State:
        """Return the state at a time, after all that happened in its tick; in any order of asking.

        Raises:
            OutOfHorizon: The run does not reach so far.
        """
        if not 0.0 <= time_s <= self.horizon_s:
            raise OutOfHorizon(time_s, self.horizon_s)
        return State(self, time_s, None)

    def at_moment(self, time_s: float, finished: int) -> State:
        """Return the state at a time when a number of statements is finished: within its tick.

        Raises:
            OutOfHorizon: The run does not reach so far.
        """
        known = self.at(time_s), self.at_statement(finished)
        return State(self, known[0].time_s, known[1].finished)

    def at_statement(self, finished: int) -> State:
        """Return the state after a number of statements, in any order of asking.

        Raises:
            OutOfHorizon: So many were not executed.
        """
        if not 0 <= finished <= self.statements:
            raise OutOfHorizon(finished, self.statements)
        return State(self, self.history.time_of(finished), finished)
