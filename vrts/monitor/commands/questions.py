"""`Are you sure (Y/N)?` before what cannot be undone."""

from collections.abc import Callable
from typing import NamedTuple

from vrts.monitor import words
from vrts.monitor.desk import Desk, Situation, Turn


class Sure(NamedTuple):
    """Waits for a line that begins with Y; any other leaves everything as it is."""

    carry_out: Callable[[Desk, Situation], Turn]

    @property
    def prompt(self) -> str:
        """Return the question."""
        return f"{words.SURE} "

    def enter(self, line: str, desk: Desk, now: Situation) -> Turn:
        """Do it, or not."""
        return self.carry_out(desk, now) if line.strip()[:1].upper() == "Y" else Turn()

    def interrupt(self, desk: Desk, now: Situation) -> Turn:
        """Do not."""
        return Turn()


def sure(desk: Desk, now: Situation, carry_out: Callable[[Desk, Situation], Turn]) -> Turn:
    """Ask first where the monitor asks; otherwise do it."""
    return Turn(mode=Sure(carry_out)) if desk.asks else carry_out(desk, now)
