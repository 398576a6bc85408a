"""What was done, as far as a program of it needs to know: motions, hand and outputs."""

from collections.abc import Iterable
from typing import NamedTuple

from vrts.engine.memory.events import Event, HandCommanded, SignalChanged
from vrts.engine.memory.records import Motion
from vrts.engine.programs.signals import OUTPUTS

MOST_STEPS = 5_000  # of a program that is made of a session


class Deeds(NamedTuple):
    """Motions in run time, and events, both in order."""

    motions: tuple[Motion, ...] = ()
    events: tuple[Event, ...] = ()


def moving(motions: Iterable[Motion]) -> list[Motion]:
    """Return those that go anywhere: one may be given up before it has begun."""
    return [
        motion
        for motion in motions
        if any(abs(a - b) > 1e-9 for a, b in zip(motion.start, motion.goal, strict=True))
    ]


def telling(events: Iterable[Event]) -> list[Event]:
    """Return the events that have a place in a program."""
    return [
        event
        for event in events
        if isinstance(event, HandCommanded)
        or (isinstance(event, SignalChanged) and event.signal in OUTPUTS)
    ]
