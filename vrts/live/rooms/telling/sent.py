"""Reliable messages that a room has sent, remembered for those who come back."""

from collections import deque
from typing import Final, NamedTuple

from vrts.live.rooms.member import Member
from vrts.live.rooms.telling.audience import Audience

REMEMBERED: Final = 4000  # messages
REMEMBERED_BYTES: Final = 4 * 1024 * 1024
REMEMBERED_S: Final = 600.0  # longer than the place of who is away is kept


class Told(NamedTuple):
    """A message that was sent."""

    number: int
    to: Audience
    frame: bytes
    at: float  # of a clock that only goes on [s]


class Sent:
    """The last messages of a room, as many as are remembered."""

    def __init__(self) -> None:
        """Begin with none."""
        self._told: deque[Told] = deque()
        self._bytes = 0

    def add(self, number: int, to: Audience, frame: bytes, now: float) -> None:
        """Remember a message, and forget those that are too many or too old."""
        self._told.append(Told(number, to, frame, now))
        self._bytes += len(frame)
        while len(self._told) > REMEMBERED or self._bytes > REMEMBERED_BYTES:
            self._forget_first()
        self.forget_old(now)

    def forget_old(self, now: float) -> None:
        """Forget messages that nobody can have missed whose place is still kept."""
        while self._told and now - self._told[0].at > REMEMBERED_S:
            self._forget_first()

    def forget_all(self) -> None:
        """Forget all of them: who comes back is told everything again."""
        self._told.clear()
        self._bytes = 0

    def covers(self, seen: int, last: int) -> bool:
        """Return whether all that came after a number is still known.

        Args:
            seen: The number that somebody has seen last.
            last: The number of the last message of the room.
        """
        return seen <= last and (
            seen == last or (bool(self._told) and self._told[0].number <= seen + 1)
        )

    def missed(self, member: Member, seen: int) -> list[bytes]:
        """Return the frames for somebody who came back."""
        return [
            told.frame for told in self._told if told.number > seen and told.to.includes(member)
        ]

    def _forget_first(self) -> None:
        self._bytes -= len(self._told.popleft().frame)
