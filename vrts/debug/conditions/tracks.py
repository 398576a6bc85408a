"""Signals and switches of a run, each with all its changes: looked up, not replayed."""

from bisect import bisect_left, bisect_right

import numpy as np

from vrts.debug.conditions.columns import Bools, Reals, Wholes
from vrts.debug.conditions.hearing import Hear
from vrts.engine.memory.events import SignalChanged, SwitchChanged
from vrts.engine.memory.records import INSTANT
from vrts.engine.run import Run

OFTEN = 4096  # events after which somebody is heard again
Track = tuple[list[float], list[int], list[bool]]  # times [s], statements finished, on


class Tracks:
    """Signals and switches of a run, each with all its changes: looked up, not replayed."""

    def __init__(self, run: Run, hear: Hear) -> None:
        """Take a run; it is gone through once, and somebody is heard meanwhile."""
        self._known: dict[int | str, Track] = {}
        for k, (event, number) in enumerate(zip(run.events, run.event_numbers, strict=True)):
            if k % OFTEN == 0:
                hear()
            match event:
                case SignalChanged(signal=changed, on=on) | SwitchChanged(switch=changed, on=on):
                    times, numbers, states = self._known.setdefault(changed, ([], [], []))
                    times.append(event.time_s)
                    numbers.append(number)
                    states.append(on)
                case _:
                    pass

    def at(self, name: int | str, time_s: float, finished: int) -> bool | None:
        """Return the state of a signal or switch; None where it never changed before."""
        track = self._known.get(name)
        if track is None:
            return None
        times, numbers, states = track
        k = bisect_right(times, time_s) - 1
        earlier = bisect_left(times, time_s - INSTANT)
        while k >= earlier and numbers[k] > finished:
            k -= 1
        return states[k] if k >= 0 else None

    def columns(self, name: int | str) -> "TrackColumns | None":
        """Return the track of a signal or switch as arrays; None where it never changed."""
        track = self._known.get(name)
        return None if track is None else TrackColumns(track)


class TrackColumns:
    """All changes of a signal or switch, looked up for many instants at once."""

    def __init__(self, track: Track) -> None:
        """Take the changes."""
        self._times, self._numbers, self._states = (np.array(column) for column in track)

    def states(self, times: Reals, finished: Wholes) -> Bools:
        """Return what `Tracks.at` does at each instant; off where it never changed before."""
        last = np.searchsorted(self._times, times, side="right") - 1
        earlier = np.searchsorted(self._times, times - INSTANT, side="left")
        done = np.searchsorted(self._numbers, finished, side="right") - 1
        k = np.maximum(np.minimum(last, done), earlier - 1)
        return (k >= 0) & self._states[k]
