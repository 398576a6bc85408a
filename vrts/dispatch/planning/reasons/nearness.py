"""Does the arm keep its distance? And where it comes near, is it to grasp?

Open fingers come near the object they are about to grasp, as near as the hand is wide: of 80 mm
round a can of 60 mm, 10 mm are left on each side and no program can have more. So the last way to
an object that is grasped has a limit of its own: what the object and the arm's base may be off.
"""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from vrts.base.beside import beside
from vrts.base.diagnostic import Diagnostic, Label, error
from vrts.base.units import mm
from vrts.check.collision.collision import check_collisions
from vrts.check.collision.pairs.grips import Grip, grips
from vrts.check.rounding import exact_mm
from vrts.check.verdict import CollisionReport, NearMiss
from vrts.dispatch.planning.reasons.refusals import TOO_NEAR
from vrts.engine.run import Run
from vrts.scene.model import Scene

SHOWN = 2.0  # places nearer than this times the clearance asked for are on the sheet
_SOON = 0.1  # [s] between the end of an approach and the command to close


class Passage(NamedTuple):
    """A place where something comes near something else."""

    miss: NearMiss
    to_grasp: bool  # the open hand round what it is about to grasp


class Nearness(NamedTuple):
    """How near a run comes to anything; certified for every instant."""

    report: CollisionReport  # with what is asked for as the threshold
    passages: tuple[Passage, ...]  # nearer than what is asked for
    shown: tuple[Passage, ...]  # nearer than `SHOWN` times that

    @property
    def clearance_m(self) -> float | None:
        """The smallest distance; None: there is contact, or nothing to be near."""
        found = self.report.clearance
        return None if found is None else found.distance_m


def nearness(scene: Scene, run: Run, asked: float) -> Nearness:
    """Return how near a run comes to anything, where it is nearer than what is asked for [m]."""
    wide = check_collisions(scene, run, near_miss=SHOWN * asked)
    held = grips(run.events)
    shown = tuple(Passage(miss, _to_grasp(miss, held)) for miss in wide.near_misses)
    ways = [passage.miss for passage in shown if passage.to_grasp]
    report = check_collisions(scene, run, near_miss=asked)
    passages = (
        Passage(miss, any(_within(miss, way) for way in ways)) for miss in report.near_misses
    )
    return Nearness(report, tuple(passages), shown)


def too_near(found: Nearness, asked: float, grasping: float) -> Iterator[Diagnostic]:
    """Yield a refusal for every place that is too near.

    Args:
        found: Of a run, with at least what is asked for as its threshold.
        asked: Distance to keep [m].
        grasping: The same between an open hand and what it is about to grasp [m].
    """
    for miss, to_grasp in found.passages:
        limit = min(asked, grasping) if to_grasp else asked
        if round(mm(miss.distance_m), 2) >= round(mm(limit), 2):
            continue
        label = None if miss.cause is None else Label(miss.cause.span)
        first, second = miss.parts
        near, wanted = beside(exact_mm(miss.distance_m), exact_mm(limit), plain=True)
        yield error(
            TOO_NEAR,
            f"{first} comes within {near} mm of {second} at "
            f"{miss.nearest_s:.1f} s, {wanted} mm are asked for",
            label,
            help=("go higher or farther round; `--clearance` asks for another distance",),
            data={"distance_mm": round(mm(miss.distance_m), 2), "time_s": round(miss.nearest_s, 3)},
        )


def _within(miss: NearMiss, way: NearMiss) -> bool:
    """Return whether a place lies on the way to what the hand grasps."""
    bodies = {miss.first, miss.second} == {way.first, way.second}
    return bodies and way.start_s <= miss.start_s and miss.end_s <= way.end_s


def _to_grasp(miss: NearMiss, held: Sequence[Grip]) -> bool:
    return miss.held is None and any(
        grip.body in (miss.first, miss.second)
        and miss.start_s <= grip.close_s
        and miss.end_s >= grip.close_s - _SOON
        for grip in held
    )
