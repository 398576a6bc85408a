"""When touching is allowed: pads and the object they hold, an object and what it stands on.

*Pads and grasped object*: from the close command until first separated after opening. *Object and
support*: tested against the support lowered by 1 mm, which is no matter of time; but both kinds of
pairs are near each other on purpose when grasping, lifting and setting down. They enter minimum
clearance and near misses only once they have been farther apart than the near-miss threshold and
come nearer again, and an object that is set down leaves them with the final approach.
"""

import math
from collections.abc import Callable, Generator, Iterator, Sequence
from typing import NamedTuple, TypeAlias, TypeVar

import numpy as np
import numpy.typing as npt

from vrts.engine.memory.events import Event, Grasped, HandCommanded, Released
from vrts.ir.instructions import HandAction

Array: TypeAlias = npt.NDArray[np.float64]
T = TypeVar("T")

NEAR_MISS = 5e-3  # [m] nearer than this is a near miss, unless the task says otherwise [assumed]
SEPARATED = 2e-4  # [m] pads farther than this from the object have let go of it [assumed]
FINE = 14e-3  # [s] between instants at which separation is looked for: half a tick [assumed]
COARSE = 56e-3  # [s] between instants at which the way apart and back is followed [assumed]
BATCH = 16  # instants looked at together, at first
SOON = 3  # the same where pads let go: they do so at once, nearly always
AWAY = 50e-3  # [m] a pair this far apart has parted [assumed]
SHRUNK = 1e-6  # [m] what is nearer by less than at the look before is no nearer
SOONER = 1e-9  # [s] no instant so near to the end is looked at


class Look(NamedTuple):
    """Instants at which a distance is wanted."""

    times: Array  # [s]
    exact: bool  # or whatever is proven at once


class Gap(NamedTuple):
    """What is known of a distance; both are the same where it is exact."""

    lower: float  # [m]
    upper: float  # [m]


# yields looks, is sent what is known at each instant, comes to T
Asking: TypeAlias = Generator[Look, Sequence[Gap], T]
# of what is known at an instant and at the one before; None: that is not enough to tell
Holds: TypeAlias = Callable[[Gap, Gap | None], bool | None]


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
        apart = yield from _apart(grip.open_s, until)
        away = apart
        if near_miss is not None:
            away = max(apart, (yield from _away(grip.open_s, until, near_miss)))
        windows.append(Window(close_s, apart, allowed=True, counts=False))
        windows.append(Window(apart, away, allowed=False, counts=False))
        at = away
    windows.append(Window(at, end_s, allowed=False, counts=True))
    return tuple(window for window in windows if window.end_s > window.start_s)


def counted_from(start_s: float, end_s: float, near_miss: float = NEAR_MISS) -> Asking[float]:
    """Return when a pair that starts together comes nearer after it was apart; `end_s` if never."""
    return (yield from _away(start_s, end_s, near_miss))


def counted_until(start_s: float, end_s: float, near_miss: float = NEAR_MISS) -> Asking[float]:
    """Return when a pair that ends together begins its final approach; `start_s` if at once."""
    away = _away(start_s, end_s, near_miss, mirrored=start_s + end_s)
    return start_s + end_s - (yield from away)


def _apart(start_s: float, end_s: float) -> Asking[float]:
    """Return when a finger is first seen to be apart from what it held; `end_s` if never."""
    for times in _looks(start_s, end_s, FINE, SOON):
        found = yield from _first(times, lambda gap, _: _exceeds(gap, SEPARATED))
        if found is not None:
            return found
    return end_s


def _away(
    start_s: float, end_s: float, near_miss: float, mirrored: float | None = None
) -> Asking[float]:
    """Return when a gap is no longer that of parting; `end_s` if it always is.

    That is so when, beyond `near_miss`, it is seen to be smaller than at the look before, or when
    it exceeds `AWAY`. To look backward in time, times are asked for as `mirrored` minus what they
    are.
    """
    far = max(near_miss, SEPARATED)

    def parted(gap: Gap, before: Gap | None) -> bool | None:
        return _either(_exceeds(gap, AWAY), _comes_nearer(gap, before, far))

    last = np.empty(0)
    for times in _looks(start_s, end_s, COARSE, BATCH):
        looks = np.concatenate((last, times))  # the last one again: what comes before the next
        found = yield from _first(looks, parted, mirrored)
        if found is not None:
            return found
        last = times[-1:]
    return end_s


def _first(times: Array, holds: Holds, mirrored: float | None = None) -> Asking[float | None]:
    """Return the first instant at which something holds; None: it holds at none.

    Distances are asked for exactly only where what is proven of them at once does not tell.
    """
    asked = times if mirrored is None else mirrored - times
    for exact in (False, True):
        gaps = yield Look(asked, exact)
        told = map(holds, gaps, (None, *gaps))
        for t, answer in zip(times.tolist(), told, strict=False):
            if answer is None:
                break
            if answer:
                return t
        else:
            break
    return None


def _exceeds(gap: Gap, limit: float) -> bool | None:
    """Return whether a distance exceeds a limit [m]."""
    return _sure(least=gap.lower > limit, most=gap.upper > limit)


def _comes_nearer(gap: Gap, before: Gap | None, far: float) -> bool | None:
    """Return whether a distance is smaller than at the look before, which exceeded `far` [m]."""
    if before is None:
        return False
    least = before.lower > far and gap.upper < before.lower - SHRUNK
    most = before.upper > far and gap.lower < before.upper - SHRUNK
    return _sure(least=least, most=most)


def _sure(*, least: bool, most: bool) -> bool | None:
    return least if least == most else None


def _either(one: bool | None, other: bool | None) -> bool | None:
    if one or other:
        return True
    return None if one is None or other is None else False


def _looks(start_s: float, end_s: float, step_s: float, batch: int) -> Iterator[Array]:
    """Yield the instants from one time on, a step apart, before another: more and more at once."""
    total = math.ceil(max(end_s - start_s - SOONER, 0.0) / step_s)
    first, count = 0, batch
    while first < total:
        times = np.arange(first, min(first + count, total), dtype=np.float64)
        yield start_s + step_s * times
        first, count = first + count, 2 * count
