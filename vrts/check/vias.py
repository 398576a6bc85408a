"""Whether the tool passed the via points, decided on the polynomials.

The distance of tool and point changes at most as fast as the tool can move, so an interval in which
it cannot come within the radius is closed at once; others are halved [Schwarzer2005]_.
"""

import math
from collections.abc import Sequence
from typing import NamedTuple

from vrts.base.diagnostic import Diagnostic, Rule, Severity
from vrts.base.pose import Pose, distance
from vrts.base.units import mm
from vrts.check.task import Task, ViaPoint
from vrts.check.verdict import Answer, Verdict
from vrts.engine.records import Segment
from vrts.engine.run import Run
from vrts.engine.timeline import value
from vrts.robots.kinematics import forward
from vrts.robots.levers import levers
from vrts.robots.model import Arm

VIA_MISSED = Rule("V662", "via-point-missed")
VIA_ORDER = Rule("V663", "via-point-order")

SHORTEST = 1e-4  # [s] intervals are not halved below this


class Visits(NamedTuple):
    """When the tool was within reach of a via point."""

    via: ViaPoint
    intervals: tuple[tuple[float, float], ...]  # [s], in time order
    nearest_m: float  # smallest distance seen


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
    visits = tuple(visits_of(run, via) for via in task.vias)
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


def visits_of(run: Run, via: ViaPoint) -> Visits:
    """Return the intervals in which the tool is within the radius of a point, to 0.1 ms."""
    arm = run.scene.robot.arm
    found: list[tuple[float, float]] = []
    nearest = math.inf
    for segment in run.timeline.segments:
        search = _Search(arm, segment, run.scene.X_FT, via)  # whatever TOOL the program sets
        search.run()
        nearest = min(nearest, search.nearest)
        found += search.intervals
    merged: list[tuple[float, float]] = []
    for start, end in sorted(found):
        if merged and start <= merged[-1][1] + 2 * SHORTEST:
            merged[-1] = (merged[-1][0], max(merged[-1][1], end))
        else:
            merged.append((start, end))
    return Visits(via, tuple(merged), nearest)


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


class _Search:
    """Halves one segment until every part is decided."""

    def __init__(self, arm: Arm, segment: Segment, X_FT: Pose, via: ViaPoint) -> None:
        self.arm, self.segment, self.X_FT, self.via = arm, segment, X_FT, via
        self.intervals: list[tuple[float, float]] = []
        self.nearest = math.inf
        self.levers = levers(arm, X_FT.translation)

    def run(self) -> None:
        """Decide the whole segment."""
        pending = [(self.segment.start_s, self.segment.end_s)]
        while pending:
            start, end = pending.pop()
            middle = 0.5 * (start + end)
            gap = self._distance(middle)
            self.nearest = min(self.nearest, gap)
            travel = self._travel(start, end)
            if gap - travel > self.via.radius:
                continue
            if gap + travel <= self.via.radius:
                self.intervals.append((start, end))
            elif end - start > SHORTEST:
                pending += [(start, middle), (middle, end)]
            elif gap <= self.via.radius:
                self.intervals.append((start, end))

    def _distance(self, time_s: float) -> float:
        t = time_s - self.segment.start_s
        q = tuple(value(row, t) for row in self.segment.coefficients[:6])
        tool = forward(self.arm, q) @ self.X_FT  # type: ignore[arg-type]
        return distance(tool.translation, self.via.point)

    def _travel(self, start: float, end: float) -> float:
        """Return a bound on how far the tool moves from the middle to either end [m]."""
        half = 0.5 * (end - start)
        a, b = start - self.segment.start_s, end - self.segment.start_s
        return half * sum(
            lever * _fastest(row, a, b)
            for lever, row in zip(self.levers, self.segment.coefficients[:6], strict=True)
        )


def _fastest(row: tuple[float, ...], a: float, b: float) -> float:
    """Return a bound on the speed of a polynomial of degree at most 3 on an interval."""
    c = (*row, 0.0, 0.0, 0.0)[1:4]
    at = [abs(c[0] + t * (2.0 * c[1] + 3.0 * t * c[2])) for t in (a, b)]
    if c[2]:
        turn = -c[1] / (3.0 * c[2])
        if a < turn < b:
            at.append(abs(c[0] + turn * (2.0 * c[1] + 3.0 * turn * c[2])))
    return max(at)
