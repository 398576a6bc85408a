"""What a program loses first: a candidate that loses it again need not be executed to its end."""

from collections.abc import Sequence
from typing import NamedTuple

from vrts.engine.hand.told import DROP_HEIGHT
from vrts.engine.memory.events import Grasped, Released, Toppled
from vrts.engine.run import Run
from vrts.repair.trying.touched import KnownTouch, still_touching


class Mishap(NamedTuple):
    """Something dropped or toppled."""

    body: str
    deeds: int  # how often the hand had gripped something or let it go
    time_s: float


class Loss(NamedTuple):
    """What is lost first of all that has a time; nothing, where both are None."""

    mishap: Mishap | None
    touch: KnownTouch | None


def mishaps_of(run: Run) -> Sequence[Mishap]:
    """Return what was dropped or toppled, in order: after it no program has the full mark."""
    found: list[Mishap] = []
    deeds = 0
    for event in run.events:
        dropped = isinstance(event, Released) and event.height_m > DROP_HEIGHT
        if isinstance(event, Toppled) or (isinstance(event, Released) and dropped):
            found.append(Mishap(event.body, deeds, event.time_s))
        deeds += isinstance(event, Grasped | Released)
    return found


def first_loss(run: Run, touches: Sequence[KnownTouch]) -> Loss:
    """Return what a run loses first, of its mishaps and contacts."""
    mishap = next(iter(mishaps_of(run)), None)
    touch = min(touches, key=lambda each: each.time_s, default=None)
    if mishap is not None and (touch is None or mishap.time_s <= touch.time_s):
        return Loss(mishap, None)
    return Loss(None, touch)


def lost_again(run: Run, loss: Loss) -> bool:
    """Return whether a run surely loses what another loses first, or drops what that one does not.

    Args:
        run: As far as it is known.
        loss: What the other loses first.
    """
    if loss.touch is not None:
        return still_touching(run, (loss.touch,)) > 0
    first = next(iter(mishaps_of(run)), None)
    if first is None:
        return False
    return loss.mishap is None or first[:2] == loss.mishap[:2]
