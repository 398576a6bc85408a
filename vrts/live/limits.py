"""How much a connection, an account or an address may ask for. Times are arguments [s]."""

from collections import OrderedDict
from dataclasses import dataclass
from typing import Final

MESSAGES: Final = (60.0, 120.0)  # a second, and at once
CHAT: Final = (1.0, 8.0)
QUESTIONS: Final = (25.0, 40.0)  # reach while the pointer is dragged
LOOKS: Final = (10.0, 60.0)  # blocks of the past, of a minute each
PROGRAMS: Final = (0.5, 4.0)  # uploads, saved programs, exports: they are long
EXCESS: Final = 1000  # messages beyond the limits after which a connection ends
CONNECTIONS: Final = 8  # of one account
ALL_CONNECTIONS: Final = 2000
FAILURES: Final = 10  # failed log-ins of an address in `WINDOW`
ALL_FAILURES: Final = 2000  # of all addresses together: guessing from many
WINDOW: Final = 300.0  # [s]
ADDRESSES: Final = 4096  # whose failures are remembered


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


class FailedLogIns:
    """Counts failures by address; those who succeed are never counted, however many they are."""

    def __init__(self) -> None:
        """Begin without any."""
        self._of: OrderedDict[str, tuple[float, int]] = OrderedDict()
        self._all = (0.0, 0)

    def blocked(self, address: str, now: float) -> bool:
        """Return whether an address must wait."""
        since, count = self._of.get(address, (now, 0))
        if now - since < WINDOW and count >= FAILURES:
            return True
        since, count = self._all
        return now - since < WINDOW and count >= ALL_FAILURES

    def failed(self, address: str, now: float) -> None:
        """Count a failure."""
        self._of[address] = _one_more(self._of.get(address), now)
        self._of.move_to_end(address)
        self._all = _one_more(self._all, now)
        while len(self._of) > ADDRESSES:
            self._of.popitem(last=False)


def _one_more(counted: tuple[float, int] | None, now: float) -> tuple[float, int]:
    if counted is None or now - counted[0] >= WINDOW:
        return now, 1
    return counted[0], counted[1] + 1
