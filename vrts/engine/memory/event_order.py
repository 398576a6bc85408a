"""The events of a log in time order, kept while the log grows: a look costs what is new since."""

from bisect import bisect_left, insort
from collections.abc import Hashable, Iterator, Sequence
from typing import NamedTuple

from vrts.engine.memory.events import (
    Answered,
    Event,
    MotionEnded,
    MotionStarted,
    ProgramEnded,
    ProgramProgressed,
    ProgramStarted,
    Prompted,
)

AFTER_MOTIONS = 2**62  # rank of an event that is of no motion
QUESTION = "question"  # track of what tells whether a PROMPT waits for a line


class Dated(NamedTuple):
    """An event with what orders it."""

    time_ns: int
    rank: int  # of one instant: motions as they follow one another, then what programs did
    number: int  # in the log
    event: Event


class EventOrder:
    """Events in time order.

    Ends of the robot program that another program came before are left out: a single instruction
    ends when the arm will have arrived; where another one replaces it on the way, that time never
    comes for it.
    """

    __slots__ = ("_tracks", "count", "dated")

    def __init__(self) -> None:
        """Start empty."""
        self.count = 0  # events of the log that were taken
        self.dated: list[Dated] = []
        self._tracks: dict[Hashable, list[Dated]] | None = None  # None: nobody has asked yet

    def take(self, events: Sequence[Event]) -> None:
        """Take the events that follow in the log."""
        fresh = [_dated(event, self.count + k) for k, event in enumerate(events)]
        self.count += len(fresh)
        if len(fresh) > len(self.dated):  # once, in general
            both = sorted([*self.dated, *fresh], key=_number)
            self.dated = sorted(_not_given_up(both), key=_order)
            self._tracks = None
            return
        for one in fresh:
            if begins(one.event):
                self._give_up(one)
            _put(self.dated, one)
            if self._tracks is not None:
                for track in tracks_of(one.event):
                    _put(self._tracks.setdefault(track, []), one)

    def until(self, time_s: float) -> list[Dated]:
        """Return what happened up to a time [s]."""
        return _until(self.dated, time_s)

    def track(self, track: Hashable, time_s: float) -> list[Event]:
        """Return the events of a track up to a time [s]: a type of event, or another one."""
        return [one.event for one in _until(self._on(track), time_s)]

    def last(self, track: Hashable, time_s: float) -> Event | None:
        """Return the last of them."""
        dated = self._on(track)
        k = bisect_left(dated, round(time_s * 1e9) + 1, key=_time) - 1
        while k >= 0 and dated[k].event.time_s > time_s:
            k -= 1
        return dated[k].event if k >= 0 else None

    def _on(self, track: Hashable) -> list[Dated]:
        if self._tracks is None:
            self._tracks = {}
            for one in self.dated:
                for found in tracks_of(one.event):
                    self._tracks.setdefault(found, []).append(one)
        return self._tracks.get(track, [])

    def _give_up(self, begun: Dated) -> None:
        """Leave out what a program that begins comes before."""
        k = bisect_left(self.dated, begun.time_ns, key=_time)
        gone = [
            one
            for one in self.dated[k:]
            if is_of_robot(one.event) and one.event.time_s > begun.event.time_s
        ]
        for one in gone:
            del self.dated[bisect_left(self.dated, _order(one), key=_order)]
            for track in tracks_of(one.event) if self._tracks is not None else ():
                dated = self._on(track)
                del dated[bisect_left(dated, _order(one), key=_order)]


def spells(*, is_robot: bool) -> Hashable:
    """Return the track of how the robot program or the other begins, goes on and ends."""
    return ("spell", is_robot)


def progress(*, is_robot: bool) -> Hashable:
    """Return the track of the cycles and priority of the robot program or the other."""
    return ("progress", is_robot)


def tracks_of(event: Event) -> Iterator[Hashable]:
    """Yield the tracks on which an event is."""
    yield type(event)
    if isinstance(event, ProgramStarted | ProgramProgressed | ProgramEnded):
        yield spells(is_robot=not event.process)
    if isinstance(event, ProgramProgressed):
        yield progress(is_robot=not event.process)
    if isinstance(event, Prompted | Answered | ProgramEnded):
        yield QUESTION


def _not_given_up(dated: Sequence[Dated]) -> list[Dated]:
    """Return events, in the order of the log, without those that another program came before."""
    begun_s = float("inf")  # of the program that came next
    kept: list[Dated] = []
    for one in reversed(dated):
        if is_of_robot(one.event) and one.event.time_s > begun_s:
            continue
        if begins(one.event):
            begun_s = one.event.time_s
        kept.append(one)
    kept.reverse()
    return kept


def begins(event: Event) -> bool:
    """Return whether a robot program begins."""
    return isinstance(event, ProgramStarted) and not event.process


def is_of_robot(event: Event) -> bool:
    """Return whether an event tells how the robot program goes on."""
    program = isinstance(event, ProgramStarted | ProgramProgressed | ProgramEnded)
    return program and not event.process


def _dated(event: Event, number: int) -> Dated:
    return Dated(round(event.time_s * 1e9), _rank(event), number, event)


def _rank(event: Event) -> int:
    """Return the rank: a motion begins, it ends, the next one begins; some take no time at all."""
    if isinstance(event, MotionStarted):
        return 2 * event.motion
    return 2 * event.motion + 1 if isinstance(event, MotionEnded) else AFTER_MOTIONS


def _put(dated: list[Dated], one: Dated) -> None:
    """Put an event in its place, which is nearly always the end."""
    if not dated or _order(dated[-1]) < _order(one):
        dated.append(one)
    else:
        insort(dated, one, key=_order)


def _until(dated: list[Dated], time_s: float) -> list[Dated]:
    time_ns = round(time_s * 1e9)
    sure = bisect_left(dated, time_ns, key=_time)
    unsure = bisect_left(dated, time_ns + 1, sure, key=_time)
    return [*dated[:sure], *(one for one in dated[sure:unsure] if one.event.time_s <= time_s)]


def _time(one: Dated) -> int:
    return one.time_ns


def _number(one: Dated) -> int:
    return one.number


def _order(one: Dated) -> tuple[int, int, int]:
    return one[:3]
