"""Hold to move: a key of the pendant that is held, and what follows from its heartbeat."""

from dataclasses import dataclass

from vrts.engine.faults import RuntimeFault
from vrts.ir.commands import Panic
from vrts.live.actions import Jog
from vrts.live.session.channel.messages import SILENCE
from vrts.live.session.operator.conversation import Conversation
from vrts.live.session.operator.motions import farthest

SILENT = "the key counts as released: nothing was heard of it for 200 ms"
AT_LIMIT = "the joint is at its limit"


@dataclass(slots=True)
class _Held:
    """A key that is held."""

    action: Jog
    heard_s: float  # the last heartbeat
    moves: bool = False  # the motion has been given; before, the arm comes to rest


class HeldKey:
    """Lets session time pass, with what a held key brings about at its very moment.

    It depends on session time only, so a replay with the same stamps does the same.
    """

    def __init__(self, conversation: Conversation) -> None:
        """Begin with no key held."""
        self._conversation = conversation
        self._growing = conversation.growing
        self._held: _Held | None = None
        self.said: list[str] = []  # what users should know about it

    @property
    def active(self) -> bool:
        """Whether a key is held."""
        return self._held is not None

    def press(self, action: Jog) -> RuntimeFault | None:
        """Begin to move; what moves comes to rest first. Return why it cannot move."""
        self._held = _Held(action, self._growing.time_s)
        if self._growing.moving or self._growing.executing or self._growing.waits:
            self._conversation.issue(Panic())
            return None
        return self._begin()

    def keep(self) -> bool:
        """Take a heartbeat; return whether a key is held."""
        if self._held is None:
            return False
        self._held.heard_s = self._growing.time_s
        return True

    def release(self) -> bool:
        """Let the arm slow down; return whether a key was held."""
        if self._held is None:
            return False
        self._held = None
        self._conversation.issue(Panic())
        return True

    def drop(self) -> None:
        """Forget the key: the arm is stopped by other means."""
        self._held = None

    def advance(self, until_s: float) -> None:
        """Go on to a time [s]."""
        growing = self._growing
        while self._held is not None and growing.time_s < until_s:
            deadline = self._held.heard_s + SILENCE
            following = until_s
            if not self._held.moves:
                following = growing.next_tick_s
            growing.advance(max(min(deadline, following, until_s), growing.time_s))
            if growing.time_s >= deadline:
                self.release()
                self.said.append(SILENT)
            elif not self._held.moves and self._at_rest:
                fault = self._begin()
                if fault is not None:
                    self.said.append(fault.headline)
        growing.advance(until_s)

    @property
    def _at_rest(self) -> bool:
        growing = self._growing
        return not (growing.waits or growing.moving or growing.braking or growing.executing)

    def _begin(self) -> RuntimeFault | None:
        """Give the motion, from rest."""
        assert self._held is not None
        jog = self._held.action
        stance = self._growing.machine.system.planner.stance
        try:
            found = farthest(stance, jog.frame, jog.axis, jog.way, jog.speed)
        except RuntimeFault as fault:
            self._held = None
            return fault
        if found is None:
            self._held = None
            self.said.append(AT_LIMIT)
            return None
        self._held.moves = True
        self._conversation.issue(found.command)
        return None
