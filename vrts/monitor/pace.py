"""Simulated time that follows a clock."""

from collections.abc import Callable

from vrts.monitor.dialogue import Dialogue

BEAT = 0.1  # [s] of real time between looks at the clock

Clock = Callable[[], float]
"""Returns real time [s]."""


class Pace:
    """Lets a dialogue go on as fast as real time does."""

    def __init__(self, dialogue: Dialogue, clock: Clock) -> None:
        """Begin now."""
        self._dialogue = dialogue
        self._clock = clock
        self._ahead = dialogue.time_s - clock()

    def catch_up(self) -> str:
        """Let as much time pass as the clock says; return what the terminal shows meanwhile."""
        now = self._clock() + self._ahead
        return self._dialogue.advance(now) if now > self._dialogue.time_s else ""
