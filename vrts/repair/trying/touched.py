"""Contacts that a candidate surely still has: the same piece of a motion, among the same things."""

from collections.abc import Mapping
from typing import NamedTuple, TypeAlias

from vrts.base.pose import Pose
from vrts.check.verdict import CollisionReport
from vrts.engine.run import Run, pose_of

Row: TypeAlias = tuple[float, ...]
Around: TypeAlias = Mapping[str, tuple[float, ...]]
FINE = 9  # digits of [m] and of rotations: what differs by less is the same place


class KnownTouch(NamedTuple):
    """A contact of a run, as it can be found again in others."""

    rows: tuple[Row, ...]  # of the piece of a motion
    into_s: float  # when, from the start of the piece [s]
    around: Around  # where everything is then
    time_s: float  # when, in the run that it is known of


def known_touches(run: Run, report: CollisionReport | None) -> tuple[KnownTouch, ...]:
    """Return the contacts of a run at their deepest moments."""
    found: list[KnownTouch] = []
    for event in () if report is None else report.contacts:
        for segment in run.timeline.segments:
            if segment.start_s <= event.deepest_s < segment.end_s and segment.motion is not None:
                into_s = event.deepest_s - segment.start_s
                around = _around(run, event.deepest_s)
                found.append(KnownTouch(segment.coefficients, into_s, around, event.deepest_s))
    return tuple(found)


def still_touching(run: Run, known: tuple[KnownTouch, ...]) -> int:
    """Return how many of the contacts of another run are surely in this one, too."""
    if not known:
        return 0
    wanted = {touch.rows: touch for touch in known}
    found: set[tuple[Row, ...]] = set()
    for segment in run.timeline.segments:
        touch = wanted.get(segment.coefficients)
        if touch is None or segment.coefficients in found:
            continue
        time_s = segment.start_s + touch.into_s
        if time_s < segment.end_s and _around(run, time_s) == touch.around:
            found.add(segment.coefficients)
    return len(found)


def _around(run: Run, time_s: float) -> Around:
    state = run.at(min(time_s, run.horizon_s))
    poses = {name: pose_of(p, time_s, state.X_WF) for name, p in state.placements.items()}
    return {name: _rounded(pose) for name, pose in poses.items()}


def _rounded(pose: Pose) -> tuple[float, ...]:
    return tuple(round(x, FINE) + 0.0 for x in (*pose.rotation, *pose.translation))
