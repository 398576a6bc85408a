"""When a session beats: 50 times a second or as told, once sooner when a command is to show.

Where nothing is under way it beats less often if it may: what shows of it is the clock, which
pages let go on between two frames; a command is heard at once all the same.
"""

import math

from vrts.live.actions import Keep
from vrts.live.session.channel.messages import BEAT, Act, Halt, ToSession

AT_REST = 0.8  # [s] between beats while nothing is under way; pages begin again after one second
AFTER_TICK = 0.004  # [s] after a tick the first motion of an arm that stood still can be seen


class Beats:
    """Knows when the next beat is due, by the clock that the session is given."""

    def __init__(self, now_s: float) -> None:
        """Have the first one due now [s]."""
        self.period_s = BEAT
        self.seldom = False  # fewer will do while nothing is under way
        self._regular_s = now_s
        self._early_s = math.inf

    @property
    def due_s(self) -> float:
        """When the next beat is due [s]."""
        return min(self._regular_s, self._early_s)

    def bring_forward(self, at_s: float) -> None:
        """Have a beat at a time [s], however soon that is; the later ones follow from there."""
        self._early_s = min(self._early_s, at_s)

    def kept(self, now_s: float, *, at_rest: bool = False) -> None:
        """Take note that the beat that was due is over at a time [s].

        Args:
            now_s: When.
            at_rest: Whether nothing is under way, and nobody waits for the next beat.
        """
        due_s = self.due_s
        if due_s >= self._early_s:
            self._early_s = math.inf
        period_s = max(self.period_s, AT_REST) if at_rest and self.seldom else self.period_s
        self._regular_s = max(due_s + period_s, now_s)


def shows(order: ToSession) -> bool:
    """Return whether an order may change what is seen at the next tick."""
    return isinstance(order, Halt) or (
        isinstance(order, Act) and not isinstance(order.action, Keep)
    )
