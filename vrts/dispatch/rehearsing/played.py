"""The inputs of a scenario as LinuxCNC is given them: by the motion that is under way."""

from bisect import bisect_right
from typing import NamedTuple

from vrts.engine.memory.events import SignalChanged
from vrts.engine.run import Run

INSTANT = 1e-6  # [s]


class Change(NamedTuple):
    """An input changes."""

    motion: int  # that has begun last, from 1; 0: none yet
    after_s: float  # the start of that motion, or of the program
    signal: int
    on: bool


def changes(run: Run) -> tuple[Change, ...]:
    """Return what changes when.

    What a sensor of the scenario sees is such a change too. LinuxCNC's pauses between motions are
    its own, so times are counted from the start of the motion that is under way, or was the last.
    """
    starts = [motion.start_s for motion in run.motions]
    found: list[Change] = []
    seen = (e for e in run.events if isinstance(e, SignalChanged) and e.cause is None)
    for time_s, signal, on, _ in seen:
        number = bisect_right(starts, time_s + INSTANT)
        since = starts[number - 1] if number else run.started_s
        found.append(Change(number, max(time_s - since, 0.0), signal, on))
    return tuple(found)
