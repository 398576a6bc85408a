"""How much a connection, an account or an address may ask for. Times are arguments [s]."""

from dataclasses import dataclass
from typing import Final

MESSAGES: Final = (60.0, 120.0)  # a second, and at once
CHAT: Final = (1.0, 8.0)
QUESTIONS: Final = (25.0, 40.0)  # reach while the pointer is dragged
LOOKS: Final = (10.0, 60.0)  # blocks of the past, of a minute each
PROGRAMS: Final = (0.5, 4.0)  # uploads, saved programs, exports: they are long
TURNS: Final = (0.5, 30.0)  # requests of an account for the control right
BRANCHES: Final = (1 / 120, 6.0)  # private rooms that an account begins
RECORDS: Final = 20_000  # in the log of a session: of who came, and of who had control
EXCESS: Final = 1000  # messages beyond the limits after which a connection ends
CONNECTIONS: Final = 8  # of one account
ALL_CONNECTIONS: Final = 2000
UNJOINED: Final = 500  # WebSockets that have not said `join` yet
BODIES: Final = 2  # programs that an account sends at the same time
ALL_BODIES: Final = 40
ACCOUNTS: Final = 1000  # whose use is remembered beside their places
PLACES: Final = 1000  # in a room


@dataclass(slots=True)
class Bucket:
    """Lets through so many a second, and some more at once."""

    rate: float
    burst: float
    level: float = 0.0  # used up
    at: float = 0.0

    def take(self, now: float) -> bool:
        """Return whether one more is let through."""
        self.level = max(0.0, self.level - (now - self.at) * self.rate)
        self.at = now
        if self.level + 1.0 > self.burst:
            return False
        self.level += 1.0
        return True


class Buckets:
    """A bucket for each account, whatever places it has; those that asked last are remembered."""

    def __init__(self, rate: float, burst: float) -> None:
        """Let through so many a second, and some more at once, of each account."""
        self._rate = rate
        self._burst = burst
        self._of: dict[int, Bucket] = {}

    def take(self, account: int, now: float) -> bool:
        """Return whether one more of an account is let through."""
        bucket = self._of.pop(account, None) or Bucket(self._rate, self._burst)
        self._of[account] = bucket  # after all others
        if len(self._of) > ACCOUNTS:
            del self._of[next(iter(self._of))]
        return bucket.take(now)
