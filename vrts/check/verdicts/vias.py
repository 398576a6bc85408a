"""Whether the tool passed the via points: near enough, turned and as fast as the task asks.

Decided on the polynomials, for every instant; all that is asked for must be true at the same one.
"""

import math
from collections.abc import Sequence
from enum import Enum
from typing import NamedTuple

import numpy as np

from vrts.base.units import DEG, MM
from vrts.check.collision.of_run import motion_of
from vrts.check.curves.timeline_arrays import Curves, curves, lasting_of
from vrts.check.curves.tool_motion import Bounded, tool_angle, tool_distance, tool_speed
from vrts.check.goals.reached import judged_at
from vrts.check.task.task import Task, ViaPoint
from vrts.check.verdicts.via_search import Array, Interval, Wanted, search
from vrts.engine.memory.records import Segment
from vrts.engine.run import Run

LENGTH = 5e-6  # [m], [m/s] half of what a measurement is rounded to
ANGLE = math.radians(0.005)
CLOSE = 0.5 * MM  # of a point that is missed the smallest distance is known to this
CLOSE_ANGLE = 0.1 * DEG
CLOSE_SPEED = 0.5 * MM  # [m/s]


class Lack(Enum):
    """What is missing from a passage."""

    PLACE = "near enough"
    DIRECTION = "in the direction asked for"
    TOO_FAST = "slowly enough"
    TOO_SLOW = "fast enough"
    ORDER = "in the order asked for"


class Visits(NamedTuple):
    """When the tool was within reach of a via point, and all that is asked for was true."""

    via: ViaPoint
    intervals: tuple[Interval, ...]  # [s], in time order
    nearest_m: float  # smallest distance seen; where it is missed, within 0.5 mm of the smallest
    doubtful: tuple[Interval, ...] = ()  # it cannot be told
    lack: Lack | None = None  # what is never true, while all before it is
    best: float = 0.0  # nearest to it [m], [rad] or [m/s]
    best_s: float = 0.0  # when [s]


class Passed(NamedTuple):
    """Which via points count as met."""

    visits: tuple[Visits, ...]
    met: tuple[bool, ...]  # beside visits; what cannot be told counts
    certain: tuple[bool, ...]  # beside visits; what cannot be told does not count

    @property
    def number(self) -> int:
        """How many are met."""
        return sum(self.met)

    @property
    def lacks(self) -> tuple[Lack | None, ...]:
        """Why points are not met, beside visits; None where they are."""
        return tuple(
            None if met else visits.lack or Lack.ORDER
            for visits, met in zip(self.visits, self.met, strict=True)
        )


def passed(run: Run, task: Task) -> Passed:
    """Return which via points were passed before goals are judged, in order if that is asked."""
    visits = visits_of(run, task.vias, judged_at(run, task))
    sure = [visit.intervals for visit in visits]
    either = [tuple(sorted((*visit.intervals, *visit.doubtful))) for visit in visits]
    match = in_order if task.ordered else _anyhow
    return Passed(visits, tuple(match(either)), tuple(match(sure)))


def _anyhow(visits: Sequence[Sequence[Interval]]) -> list[bool]:
    return [bool(intervals) for intervals in visits]


def in_order(visits: Sequence[Sequence[tuple[float, float]]]) -> list[bool]:
    """Return the largest set of via points that can be matched to increasing visit times.

    Dynamic programme over the points: for every count the earliest possible time of the last visit.
    One missed point therefore never voids the next.
    """
    best: list[tuple[float, tuple[int, ...]]] = [(-math.inf, ())]
    for point, intervals in enumerate(visits):
        for count in range(len(best) - 1, -1, -1):
            last, members = best[count]
            times = [max(last, start) for start, end in intervals if end >= last]
            if not times:
                continue
            candidate = (min(times), (*members, point))
            if count + 1 == len(best):
                best.append(candidate)
            elif candidate[0] < best[count + 1][0]:
                best[count + 1] = candidate
    members = set(best[-1][1])
    return [point in members for point in range(len(visits))]


def visits_of(run: Run, vias: Sequence[ViaPoint], until_s: float = math.inf) -> tuple[Visits, ...]:
    """Return when the tool of the scene passes points as they ask for, to 0.1 ms.

    Args:
        run: The run.
        vias: The points.
        until_s: Passages that begin later do not count.
    """
    if not vias:
        return ()
    if lasting_of(run.timeline.segments):
        motion = motion_of(run)
    else:  # no time passes
        state = run.at(0.0)
        rows = tuple((value,) for value in (*state.configuration, state.hand_opening))
        motion = curves((Segment(0.0, 1.0, rows, None),))
    return tuple(_visits(run, motion, via, until_s) for via in vias)


def _visits(run: Run, motion: Curves, via: ViaPoint, until_s: float) -> Visits:
    """Ask for one thing more at a time, so that it is known which of them is missing."""
    wanted: list[Wanted] = []
    found = Visits(via, (), math.inf)
    in_time = (motion.starts < until_s) | (motion.starts <= 0.0)
    start, end = motion.starts[in_time], np.minimum(motion.ends[in_time], max(until_s, 0.0))
    for lack, one in _wishes(run, motion, via):
        wanted.append(one)
        seen = search(wanted, start, end)
        if lack is Lack.PLACE:
            found = found._replace(nearest_m=seen.least)
        if math.isfinite(seen.least):
            found = found._replace(lack=lack, best=abs(seen.least), best_s=seen.least_s)
        found = found._replace(intervals=seen.sure, doubtful=seen.open)
        if not seen.sure and not seen.open:
            return found
    return found._replace(lack=None)


def _wishes(run: Run, motion: Curves, via: ViaPoint) -> list[tuple[Lack, Wanted]]:
    """Return what has to be true at one instant."""
    gap = tool_distance(run.scene, motion, via.point)
    found = [(Lack.PLACE, Wanted(gap, via.radius + LENGTH, CLOSE))]
    if via.approach is not None:
        angle = tool_angle(run.scene, motion, via.approach)
        found.append((Lack.DIRECTION, Wanted(angle, via.cone + ANGLE, CLOSE_ANGLE)))
    speed = tool_speed(run.scene, motion)
    if math.isfinite(via.fastest):
        found.append((Lack.TOO_FAST, Wanted(speed, via.fastest + LENGTH, CLOSE_SPEED)))
    if via.slowest:
        slowness = _negative(speed)
        found.append((Lack.TOO_SLOW, Wanted(slowness, LENGTH - via.slowest, CLOSE_SPEED)))
    return found


def _negative(quantity: Bounded) -> Bounded:
    def negative(start: Array, middle: Array, end: Array) -> tuple[Array, Array]:
        value, change = quantity(start, middle, end)
        return -value, change

    return negative
