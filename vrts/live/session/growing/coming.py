"""Events of a machine, told once each and when their time comes."""

from bisect import insort
from collections.abc import Sequence

from vrts.engine.memory.events import Event, ProgramEnded, ProgramStarted
from vrts.live.session.growing.away import Heard


class Coming:
    """Which events were seen, and those of them whose time has not come."""

    def __init__(self) -> None:
        """Begin with none."""
        self._seen = 0  # events of the machine that were looked at
        self._begun = -1  # the number of the event with which the robot program began
        self._waiting: list[tuple[float, int, Event]] = []  # times, numbers, events

    def ripe(self, events: Sequence[Event], now_s: float) -> list[Event]:
        """Return the events whose time has come since this was asked last, in time order.

        Args:
            events: All that the machine knows of, new ones at the end.
            now_s: Session time [s].
        """
        for number in range(self._seen, len(events)):
            event = events[number]
            if isinstance(event, ProgramStarted) and not event.process:
                self._begun = number
            insort(self._waiting, (event.time_s, number, event), key=_when)
        self._seen = len(events)
        ripe = 0
        while ripe < len(self._waiting) and self._waiting[ripe][0] <= now_s:
            ripe += 1
        found = [
            event for _, number, event in self._waiting[:ripe] if not self._stale(number, event)
        ]
        del self._waiting[:ripe]
        return found

    @property
    def heard(self) -> Heard:
        """All that is known, for a session that goes on in another process."""
        return Heard(self._seen, self._begun, tuple(self._waiting))

    def go_on(self, heard: Heard) -> None:
        """Know what another one has known."""
        self._seen, self._begun = heard.seen, heard.begun
        self._waiting = list(heard.waiting)

    def forget(self, count: int) -> None:
        """Take note that the machine has forgotten its first events."""
        self._seen -= count
        self._begun -= count
        self._waiting = [(at_s, number - count, event) for at_s, number, event in self._waiting]

    def _stale(self, number: int, event: Event) -> bool:
        """Return whether an event is the end of an instruction that another program followed.

        A single instruction ends when the arm will have arrived; when it is replaced on the way,
        its end is none of the program that has begun meanwhile.
        """
        return isinstance(event, ProgramEnded) and not event.process and number < self._begun


def _when(entry: tuple[float, int, Event]) -> float:
    return entry[0]
