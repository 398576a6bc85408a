"""What a run did, small: where the tool stopped or turned, beside which thing, how, holding what.

It stands beside the grader's result and is what programs are compared by for likeness. Places are
told in the world and from the nearest thing of the run's own scene, so that runs in different
variants of a task can be compared.
"""

from typing import Annotated, Literal

import msgspec
from msgspec import Meta, Struct

from vrts.base.pose import Pose, distance
from vrts.engine.memory.events import HandCommanded
from vrts.engine.memory.records import Interpolation, Lie
from vrts.engine.run import Run
from vrts.marking.result import Damaged, Record, decoded
from vrts.scene.model import Scene

SKETCH = "motion.json"
SCHEMA = "vrts.motion/1"
MOST_STOPS = 600  # of a run; what follows is not compared
LARGEST = 400_000  # bytes of a sketch
NAMED_M = 0.001  # this near to a location that the scene names the tool is at it [m]
NAMED_AXIS = 0.999  # cosine between the two directions of approach

Length = Annotated[int, Meta(ge=-1_000_000, le=1_000_000)]  # tenths of a millimetre
Name = Annotated[str, Meta(max_length=80)]


class Stop(Struct, frozen=True, forbid_unknown_fields=True, array_like=True):
    """Where one motion led."""

    line: Annotated[int, Meta(ge=0, le=1_000_000)]  # of the program
    straight: bool
    speed: Annotated[int, Meta(ge=0, le=10_000)]  # of the program [%]
    at: tuple[Length, Length, Length]  # of the tool, in the world
    axis: Annotated[tuple[int, int, int], Meta(description="of approach, hundredths")]
    thing: Name  # the nearest body of the scene, where it is before the run
    beside: tuple[Length, Length, Length]  # of the tool, from the origin of the thing
    held: Name  # what is in the hand then; "": nothing
    hand: Name  # what the hand is told between this motion and the next; "": nothing
    named: bool  # the scene names this place: no evidence


class Sketch(Record, frozen=True):
    """The motions of one run, in order."""

    schema: Literal["vrts.motion/1"]
    stops: Annotated[tuple[Stop, ...], Meta(max_length=MOST_STOPS)]


def sketch(run: Run, scene: Scene) -> Sketch:
    """Return what a run did in a scene."""
    stops: list[Stop] = []
    motions = list(run.motions)[:MOST_STOPS]
    hand = [event for event in run.events if isinstance(event, HandCommanded)]
    held = [p for track in run.placements.values() for p in track if p.lie is Lie.HELD]
    number = 0
    for k, motion in enumerate(motions):
        until = motions[k + 1].start_s if k + 1 < len(motions) else run.horizon_s
        told = ""
        while number < len(hand) and hand[number].time_s <= until + 1e-9:
            if hand[number].time_s >= motion.start_s:
                told = hand[number].action
            number += 1
        thing, beside = _nearest(motion.X_WT, scene)
        holds = next((h.body for h in held if h.start_s <= motion.start_s < h.end_s), "")
        stops.append(
            Stop(
                max(0, motion.cause.span.line),
                motion.interpolation is Interpolation.LINEAR,
                max(0, min(10_000, round(motion.speed_fraction * 100))),
                _tenths(motion.X_WT.translation),
                _hundredths(motion.X_WT.approach),
                thing[:80],
                _tenths(beside),
                holds[:80],
                told,
                _is_named(motion.X_WT, scene),
            )
        )
    return Sketch("vrts.motion/1", tuple(stops))


def to_bytes(found: Sketch) -> bytes:
    """Return a sketch as JSON."""
    return msgspec.json.encode(found) + b"\n"


def from_bytes(data: bytes) -> Sketch:
    """Return the sketch that JSON from anywhere stands for.

    Raises:
        Damaged: It is none.
    """
    if len(data) > LARGEST:
        raise Damaged(f"a sketch of {len(data):,} bytes")
    return decoded(data, Sketch)


def _nearest(X_WT: Pose, scene: Scene) -> tuple[str, tuple[float, float, float]]:
    """Return the thing whose origin is nearest to the tool, and where the tool is from it [m]."""
    if not scene.bodies:
        return "", X_WT.translation
    body = min(
        scene.bodies, key=lambda one: (distance(one.X_WO.translation, X_WT.translation), one.name)
    )
    return body.name, body.X_WO.inverse().apply(X_WT.translation)


def _is_named(X_WT: Pose, scene: Scene) -> bool:
    return any(
        distance(X_WT.translation, named.translation) <= NAMED_M
        and sum(a * b for a, b in zip(X_WT.approach, named.approach, strict=True)) >= NAMED_AXIS
        for named in scene.locations.values()
    )


def _tenths(place: tuple[float, float, float]) -> tuple[int, int, int]:
    x, y, z = (max(-1_000_000, min(1_000_000, round(v * 10_000))) for v in place)
    return x, y, z


def _hundredths(axis: tuple[float, float, float]) -> tuple[int, int, int]:
    x, y, z = (round(v * 100) for v in axis)
    return x, y, z
