"""What touches in new motion, and where it leaves its limits: pure, so others may answer."""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from vrts.geometry.proposing.proposer import Proposer
from vrts.prove.certify.laying import Entry, Hit, touches
from vrts.prove.certify.limits import beyond
from vrts.prove.certify.situation import Part
from vrts.prove.certify.touching import Beyond, Hope, Unless
from vrts.scene.model import Scene


class New(NamedTuple):
    """Motion that is looked at together."""

    scene: Scene
    entries: Sequence[Entry]
    proposer: Proposer
    pads: float  # how far a pad may press into what it grasps [m]


class Looked(NamedTuple):
    """What was found in it."""

    hits: list[Hit]
    beyond: list[Beyond]  # joints, of their limits


def looked_at(new: New) -> Looked:
    """Return what touches in new motion, and joints beyond their limits."""
    looked = Looked([], [])
    falls = [any(part.falls for part in entry.parts) for entry in new.entries]
    for wanted in (False, True):
        own = [k for k, it in enumerate(falls) if it is wanted]
        if not own:
            continue
        some = [new.entries[k] for k in own]
        hits, motion, order = touches(new.scene, some, new.proposer, new.pads)
        hits += _lowered(new, some, hits)
        looked.hits.extend(hit._replace(entry=own[hit.entry]) for hit in hits)
        looked.beyond.extend(beyond(new.scene.robot.arm, some, motion, order))
    return looked


def _lowered(new: New, entries: Sequence[Entry], hits: Sequence[Hit]) -> Iterator[Hit]:
    """Yield what touches even if what is held will be set down there."""
    asked: dict[int, list[Part]] = {}
    for hit in hits:
        unless = unless_of(hit)
        if hit.part is None or hit.part.body is None or unless is None:
            continue
        if unless.hope is not Hope.SET_DOWN:
            continue
        part = hit.part._replace(body=hit.part.body._replace(after=unless.on))
        own = asked.setdefault(hit.entry, [])
        if part not in own:
            own.append(part)
    if not asked:
        return
    some = [entries[k]._replace(parts=tuple(own)) for k, own in asked.items()]
    again, _, _ = touches(new.scene, some, new.proposer, new.pads)
    numbers = list(asked)
    yield from (hit._replace(entry=numbers[hit.entry]) for hit in again if hit.part is None)


def unless_of(hit: Hit) -> Unless | None:
    """Return what excuses a touch if it comes about; None: nothing does."""
    if hit.part is None:
        return None
    _, second, hope, body, _ = hit.group
    grasped = hope == Hope.GRASPED.value
    return Unless(Hope.GRASPED, body) if grasped else Unless(Hope.SET_DOWN, body, second)
