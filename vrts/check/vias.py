"""Whether the tool passed the via points, decided on the polynomials.

The distance of tool and point changes by no more than the tool can move, so an interval in which it
cannot come within the radius is closed at once; others are halved [Schwarzer2005]_. All intervals
are handled together, level by level.
"""

import math
from collections.abc import Sequence
from typing import NamedTuple, TypeAlias

import numpy as np
import numpy.typing as npt

from vrts.base.diagnostic import Diagnostic, Rule, Severity
from vrts.base.pose import distance
from vrts.base.units import mm
from vrts.check.curves import Curves, curves, lasting_of
from vrts.check.task import Task, ViaPoint
from vrts.check.verdict import Answer, Verdict
from vrts.engine.run import Run
from vrts.robots.batch import flange_frames
from vrts.robots.levers import levers

Array: TypeAlias = npt.NDArray[np.float64]

VIA_MISSED = Rule("V662", "via-point-missed")
VIA_ORDER = Rule("V663", "via-point-order")

SHORTEST = 1e-4  # [s] intervals are not halved below this
CLOSE = 5e-4  # [m] of a point that is missed the smallest distance is known to this


class Visits(NamedTuple):
    """When the tool was within reach of a via point."""

    via: ViaPoint
    intervals: tuple[tuple[float, float], ...]  # [s], in time order
    nearest_m: float  # smallest distance seen; where it is missed, within 0.5 mm of the smallest


class Passed(NamedTuple):
    """Which via points count as met."""

    visits: tuple[Visits, ...]
    met: tuple[bool, ...]  # beside visits

    @property
    def number(self) -> int:
        """How many are met."""
        return sum(self.met)


def passed(run: Run, task: Task) -> Passed:
    """Return which via points the tool passed, in order if the task wants that."""
    visits = visits_of(run, task.vias)
    met = [bool(visit.intervals) for visit in visits]
    if task.ordered:
        met = in_order([visit.intervals for visit in visits])
    return Passed(visits, tuple(met))


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


def visits_of(run: Run, vias: Sequence[ViaPoint]) -> tuple[Visits, ...]:
    """Return when the tool of the scene is within the radius of points, to 0.1 ms."""
    if not lasting_of(run.timeline.segments):
        return tuple(_standing(run, via) for via in vias)
    motion = curves(run.timeline.segments)
    return tuple(_passing(run, motion, via) for via in vias)


def _standing(run: Run, via: ViaPoint) -> Visits:
    """Return the visits of a run in which no time passes."""
    X_WT = run.at(0.0).X_WF @ run.scene.X_FT
    gap = distance(X_WT.translation, via.point)
    return Visits(via, ((0.0, 0.0),) if gap <= via.radius else (), gap)


def _passing(run: Run, motion: Curves, via: ViaPoint) -> Visits:
    """Halve the pieces of the motion until every part is decided."""
    start, end = motion.starts, motion.ends
    found: list[tuple[float, float]] = []
    nearest = math.inf
    while len(start):
        middle = 0.5 * (start + end)
        gap, travel = _gap_and_travel(run, motion, via, start, middle, end)
        nearest = min(nearest, float(gap.min()))
        short = end - start <= SHORTEST
        inside = (gap + travel <= via.radius) | (short & (gap <= via.radius))
        found += zip(start[inside].tolist(), end[inside].tolist(), strict=True)
        unsure = (gap - travel <= max(via.radius, nearest - CLOSE)) & ~inside & ~short
        start, middle, end = start[unsure], middle[unsure], end[unsure]
        start, end = np.concatenate([start, middle]), np.concatenate([middle, end])
    merged: list[tuple[float, float]] = []
    for begin, finish in sorted(found):
        if merged and begin <= merged[-1][1] + 2 * SHORTEST:
            merged[-1] = (merged[-1][0], max(merged[-1][1], finish))
        else:
            merged.append((begin, finish))
    return Visits(via, tuple(merged), nearest)


def _gap_and_travel(
    run: Run, motion: Curves, via: ViaPoint, start: Array, middle: Array, end: Array
) -> tuple[Array, Array]:
    """Return distances to a point at middles, and how far the tool can be from there, all (m,)."""
    arm, X_FT = run.scene.robot.arm, run.scene.X_FT  # whatever TOOL the program sets
    values = motion.values(middle)
    rotations, origins = flange_frames(arm, values[:, :6])
    tips = origins + rotations @ np.array(X_FT.translation)
    gap: Array = np.linalg.norm(tips - np.array(via.point), axis=1)
    spread = motion.spread(start, end)
    turn = np.maximum(spread.upper - values, values - spread.lower)[:, :6]
    return gap, turn @ np.array(levers(arm, X_FT.translation))


def verdicts(result: Passed) -> tuple[Verdict, ...]:
    """Return a verdict for every via point."""
    found: list[Verdict] = []
    for visits, met in zip(result.visits, result.met, strict=True):
        name = visits.via.name
        if met:
            found.append(Verdict(f"via {name}", Answer.HOLDS, f"`{name}` is passed"))
            continue
        late = bool(visits.intervals)
        summary = (
            f"`{name}` is passed, but not in the order of the task"
            if late
            else f"the tool never comes nearer than {mm(visits.nearest_m):.0f} mm to `{name}`;"
            f" {mm(visits.via.radius):.0f} mm is wanted"
        )
        finding = Diagnostic(VIA_ORDER if late else VIA_MISSED, Severity.ERROR, summary)
        found.append(Verdict(f"via {name}", Answer.VIOLATED, summary, (finding,)))
    return tuple(found)
