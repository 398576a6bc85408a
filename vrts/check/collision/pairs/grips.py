"""When touching is allowed: pads and the object they hold, an object and what it stands on.

*Pads and grasped object*: from the close command until first separated after opening. *Object and
support*: tested against the support lowered by 1 mm, which is no matter of time; but both kinds of
pairs are near each other on purpose when grasping, lifting and setting down. They enter minimum
clearance and near misses only once they have been farther apart than the near-miss threshold and
come nearer again, and an object that is set down leaves them with the final approach.
"""

from collections.abc import Generator, Sequence
from typing import NamedTuple, TypeAlias, TypeVar

import numpy as np
import numpy.typing as npt

from vrts.engine.memory.events import Event, Grasped, HandCommanded, Released
from vrts.ir.instructions import HandAction

Array: TypeAlias = npt.NDArray[np.float64]
T = TypeVar("T")
Distances: TypeAlias = Sequence[float]
# yields times, is sent distances [m], comes to T
Asking: TypeAlias = Generator[Array, Distances, T]

NEAR_MISS = 5e-3  # [m] nearer than this is a near miss, unless the task says otherwise [assumed]
SEPARATED = 2e-4  # [m] pads farther than this from the object have let go of it [assumed]
FINE = 14e-3  # [s] between instants at which separation is looked for: half a tick [assumed]
COARSE = 56e-3  # [s] between instants at which the way apart and back is followed [assumed]
BATCH = 16  # instants looked at together, at first
AWAY = 50e-3  # [m] a pair this far apart has parted [assumed]


class Window(NamedTuple):
    """An interval of time with one rule."""

    start_s: float
    end_s: float
    allowed: bool  # touching is allowed
    counts: bool  # enters minimum clearance


class Grip(NamedTuple):
    """The hand closes on an object, holds it and lets go."""

    body: str
    close_s: float  # close command
    open_s: float  # the object leaves the hand; inf if it never does


def grips(events: Sequence[Event]) -> tuple[Grip, ...]:
    """Return every grip of a run."""
    found: list[Grip] = []
    close_s = 0.0
    under_way: dict[str, float] = {}
    for event in events:
        match event:
            case HandCommanded(time_s=time_s, action=action) if action == HandAction.CLOSE.value:
                close_s = time_s
            case Grasped(time_s=time_s, body=body):
                under_way[body] = min(close_s, time_s)
            case Released(time_s=time_s, body=body) if body in under_way:
                found.append(Grip(body, under_way.pop(body), time_s))
            case _:
                pass
    found += [Grip(body, close_s, np.inf) for body, close_s in under_way.items()]
    return tuple(found)


def finger_windows(
    held: Sequence[Grip], start_s: float, end_s: float, near_miss: float | None = NEAR_MISS
) -> Asking[tuple[Window, ...]]:
    """Return the rules between one finger and one object over a run, asking for distances.

    Args:
        held: The grips of that object, in time order.
        start_s: Start of the run.
        end_s: End of the run.
        near_miss: Nearer than this is a near miss [m]; None: what counts is not wanted.
    """
    windows: list[Window] = []
    at = start_s
    for number, grip in enumerate(held):
        close_s = max(grip.close_s, at)
        until = held[number + 1].close_s if number + 1 < len(held) else end_s
        windows.append(Window(at, close_s, allowed=False, counts=True))
        apart, away = until, until
        if grip.open_s < until:
            apart, away = yield from _parting(grip.open_s, until, SEPARATED, near_miss)
        windows.append(Window(close_s, apart, allowed=True, counts=False))
        windows.append(Window(apart, away, allowed=False, counts=False))
        at = away
    windows.append(Window(at, end_s, allowed=False, counts=True))
    return tuple(window for window in windows if window.end_s > window.start_s)


def counted_from(start_s: float, end_s: float, near_miss: float = NEAR_MISS) -> Asking[float]:
    """Return when a pair that starts together comes nearer after it was apart; `end_s` if never."""
    return (yield from _parting(start_s, end_s, near_miss, near_miss))[1]


def counted_until(start_s: float, end_s: float, near_miss: float = NEAR_MISS) -> Asking[float]:
    """Return when a pair that ends together begins its final approach; `start_s` if at once."""
    parting = _parting(start_s, end_s, near_miss, near_miss, mirrored=start_s + end_s)
    return start_s + end_s - (yield from parting)[1]


def _parting(
    start_s: float,
    end_s: float,
    apart: float,
    near_miss: float | None,
    mirrored: float | None = None,
) -> Asking[tuple[float, float]]:
    """Return when a gap first exceeds `apart`, and when it is no longer that of parting.

    Parting is over when, beyond `near_miss`, the gap first shrinks, or when it exceeds `AWAY`; with
    None, as soon as the gap exceeds `apart`.
    To look backward in time, times are asked for as `mirrored` minus what they are.
    """
    separated: float | None = None
    before = -np.inf
    first = start_s
    count = BATCH
    while first < end_s:
        step_s = FINE if separated is None else COARSE
        times = np.minimum(first + step_s * np.arange(count), end_s)
        gaps = yield times if mirrored is None else mirrored - times
        for t, distance in zip(times.tolist(), gaps, strict=True):
            if separated is None and distance > apart:
                separated = t
                if near_miss is None:
                    return t, t
            shrinks = near_miss is not None and before > near_miss and distance < before - 1e-6
            if shrinks or distance > AWAY:
                return (t if separated is None else separated), t
            before = distance
        first = float(times[-1]) + step_s
        count *= 1 if separated is None else 2
    return (end_s if separated is None else separated), end_s
