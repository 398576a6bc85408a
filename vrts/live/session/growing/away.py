"""What a growing run is at rest, when all that is past is in its file."""

from typing import NamedTuple

from vrts.engine.machine.machine import Machine
from vrts.engine.memory.events import Event


class Heard(NamedTuple):
    """Which events were told; see `Coming`."""

    seen: int
    begun: int
    waiting: tuple[tuple[float, int, Event], ...]


class Away(NamedTuple):
    """All that goes on of a run."""

    time_s: float
    machine: Machine
    handed_on: int  # commands of the machine that are in the file
    done: tuple[int, float]  # motions, and a time [s], before which what was done is in the file
    crowd: bool
    forgotten: int  # statements
    uncrowded: int  # events that are not too many
    heard: Heard
