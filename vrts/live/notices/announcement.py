"""An announcement: it stands on top of every page until it is closed there, or taken down."""

from dataclasses import dataclass, field

from vrts.live.protocol.from_server import Announced


@dataclass(slots=True)
class Announcement:
    """What a supervisor has told everybody, and which accounts have seen it."""

    id: int
    at: float  # Unix time [s]
    name: str
    text: str
    account: int = 0  # whose words it are
    changed: bool = False  # supervisors have not been told how many
    _on_screen: set[int] = field(default_factory=set[int])
    _closed: set[int] = field(default_factory=set[int])

    def noticed(self, account: int, *, closed: bool) -> None:
        """Take note that it is on somebody's screen, or that they have closed it."""
        before = (len(self._on_screen), len(self._closed))
        self._on_screen.add(account)
        if closed:
            self._closed.add(account)
        self.changed = self.changed or before != (len(self._on_screen), len(self._closed))

    def message(self, here: set[int] | None) -> Announced:
        """Return what is told of it; `here` are the accounts present, for supervisors only."""
        if here is None:
            return Announced(self.id, self.at, self.name, self.text)
        seen, closed = (len(found & here) for found in (self._on_screen, self._closed))
        return Announced(self.id, self.at, self.name, self.text, seen, closed, len(here))


def next_announcement(
    before: Announcement | None, now: float, name: str, text: str
) -> Announcement:
    """Return an announcement whose number nobody has seen before, whatever the clock says."""
    number = int(now * 1000.0)
    return Announcement(max(number, before.id + 1) if before else number, now, name, text)
