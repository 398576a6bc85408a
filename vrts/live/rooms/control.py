"""The control right of a room: one holder, a lease, and a queue. Times are arguments [s].

First come, first served; the right is released when the holder leaves, hands it back, is idle too
long, or has had a turn while others wait. Then the queue's first has it. A supervisor may pass it
to anybody. Each grant has a new lease; a command must name it, with a number above the last one, so
neither an old nor a repeated command counts.
"""

from dataclasses import dataclass, field
from typing import Final

from vrts.live.tokens import new_token

IDLE_S: Final = 120.0  # unless the supervisor chooses otherwise
AWAY_S: Final = 15.0  # how long a dropped connection keeps the right


@dataclass(slots=True)
class ControlRight:
    """Who may command. Persons are ids."""

    turn_s: float = 0.0  # longest turn while others wait; 0: no limit
    idle_s: float = IDLE_S  # 0: no limit
    locked: bool = False
    holder: str = ""
    lease: str = ""
    queue: list[str] = field(default_factory=list[str])
    _last: int = -1  # number of the last command
    _since: float = 0.0  # when the turn began
    _active: float = 0.0  # last command
    _away: float | None = None  # since when the holder is not connected

    def request(self, person: str, now: float) -> bool:
        """Give the right if it is free, else queue; return whether anything changed."""
        if person == self.holder or person in self.queue:
            return False
        if self.holder or self.locked:
            self.queue.append(person)
        else:
            self._grant(person, now)
        return True

    def hand_back(self, person: str, now: float) -> bool:
        """Take somebody out of queue or right; return whether anything changed."""
        if person in self.queue:
            self.queue.remove(person)
            return True
        if person != self.holder:
            return False
        self._next(now)
        return True

    def hand_over(self, person: str, now: float) -> None:
        """Give the right to somebody, whoever holds it and waits."""
        if person in self.queue:
            self.queue.remove(person)
        self._grant(person, now)

    def release(self, now: float) -> None:
        """Take the right from whoever holds it; the queue's first is next."""
        self._next(now)

    def away(self, person: str, now: float) -> None:
        """Take note that a connection dropped."""
        if person == self.holder:
            self._away = now

    def back(self, person: str) -> None:
        """Take note that it is there again."""
        if person == self.holder:
            self._away = None

    def unlock(self, now: float) -> None:
        """End a lock; a free right goes to the queue's first."""
        self.locked = False
        if not self.holder:
            self._next(now)

    def accept(self, person: str, lease: str, number: int, now: float) -> str:
        """Return why a command does not count: "role", "lease", "replayed"; empty: it does."""
        if person != self.holder:
            return "role"
        if lease != self.lease:
            return "lease"
        if number <= self._last:
            return "replayed"
        self._last = number
        self._active = now
        return ""

    def pass_time(self, now: float) -> bool:
        """Release the right where its time is over; return whether it was."""
        if not self.holder:
            return False
        idle = self.idle_s > 0.0 and now - self._active >= self.idle_s
        gone = self._away is not None and now - self._away >= AWAY_S
        if not (idle or gone or (0.0 < self.ends() <= now)):
            return False
        self._next(now)
        return True

    def ends(self) -> float:
        """Return when the turn ends; 0: it is open."""
        if not self.holder or not self.queue or self.turn_s <= 0.0:
            return 0.0
        return self._since + self.turn_s

    def _next(self, now: float) -> None:
        self.holder = self.lease = ""
        if self.queue and not self.locked:
            self._grant(self.queue.pop(0), now)

    def _grant(self, person: str, now: float) -> None:
        self.holder = person
        self.lease = new_token()
        self._last = -1
        self._since = self._active = now
        self._away = None
