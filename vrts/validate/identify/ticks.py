"""Numbers that work through whole ticks: looked for by executing the program again."""

import math
from collections.abc import Callable, Mapping, Sequence
from typing import NamedTuple

import numpy as np

from vrts.validate.identify.again import SHORTEST_S, Again
from vrts.validate.identify.causes import Cause, Kind, possible_ticks

SLOWEST, FASTEST = 0.6, 1.6  # of what is assumed
COARSE, FINE = 25, 7  # values looked at: over the whole range, and about the best
TIMES_FINER = 3
LONGEST_S = 1.2
LIKELY = 3.84  # by which an objective may be larger within 95 %
HALVINGS = 14
PROBE = 0.25
CENTRAL = 0.95  # of what whole ticks allow

Weighs = Callable[[float], float]


class Between(NamedTuple):
    """What a log allows of a number."""

    value: float
    low: float
    high: float
    objective: float


def deciding(again: Again) -> tuple[Cause, ...]:
    """Return the numbers on which the run depends at all."""
    ends = _ends(again, {})
    found: list[Cause] = []
    for cause in possible_ticks():
        by = PROBE
        if cause.kind in (Kind.ACCELERATION, Kind.CORNERS):
            by = 4.0 * again.run.scene.robot.arm.tick
        way = -by if cause.kind in (Kind.SPEEDS, Kind.SPEED, Kind.LINE_SPEED) else by
        if _ends(again, {cause: way}) != ends:
            found.append(cause)
    return tuple(found)


def _ends(again: Again, values: Mapping[Cause, float]) -> list[float]:
    return [time for m in again.with_values(values).motions for time in (m.start_s, m.end_s)]


def grid_of(again: Again, cause: Cause) -> Sequence[float]:
    """Return the values at which a number is looked for first."""
    arm = again.run.scene.robot.arm
    if cause.kind in (Kind.SPEEDS, Kind.SPEED, Kind.LINE_SPEED):
        factors = np.geomspace(SLOWEST, FASTEST, COARSE) - 1.0
        return sorted([0.0, *factors.tolist()])
    now = arm.acceleration_time
    if cause.kind is Kind.CORNERS:
        now = arm.blend_time or 2.0 * arm.acceleration_time
    step = 2.0 * arm.tick
    return [k * step - now for k in range(1, int(LONGEST_S / step)) if k * step > SHORTEST_S]


def in_even_ticks(again: Again, cause: Cause, value: float) -> float:
    """Return the number as the controller carries it out: acceleration and corners."""
    arm = again.run.scene.robot.arm
    step = 2.0 * arm.tick
    if cause.kind is Kind.ACCELERATION:
        ticks = math.ceil((arm.acceleration_time + value) / step - 1e-6)
        return step * max(ticks, 1) - arm.acceleration_time
    now = arm.blend_time or 2.0 * arm.acceleration_time
    return step * round((now + value) / step) - now


def search(grid: Sequence[float], weighs: Weighs) -> tuple[float, float]:
    """Return the value with the least objective, and that objective."""
    known = {value: weighs(value) for value in grid}
    for _ in range(TIMES_FINER):
        order = sorted(known)
        best = min(order, key=lambda value: known[value])
        at = order.index(best)
        low, high = order[max(at - 1, 0)], order[min(at + 1, len(order) - 1)]
        for value in np.linspace(low, high, FINE).tolist():
            if value not in known:
                known[value] = weighs(value)
    best = min(known, key=lambda value: known[value])
    return best, known[best]


def between(best: float, least: float, reach: float, weighs: Weighs) -> Between:
    """Return how far a number may be off, in both directions.

    Args:
        best: The value with the least objective.
        least: That objective.
        reach: So far off it surely is not.
        weighs: The objective of a value.
    """
    ends: list[float] = []
    for way in (-1.0, 1.0):
        inside, outside = 0.0, reach
        for _ in range(HALVINGS):
            middle = 0.5 * (inside + outside)
            if weighs(best + way * middle) <= least + LIKELY:
                inside = middle
            else:
                outside = middle
        ends.append(best + way * inside)
    low, high = ends
    middle, half = 0.5 * (low + high), 0.5 * CENTRAL * (high - low)
    return Between(middle, middle - half, middle + half, least)
