"""Which situation a machine is in between two times in which nothing changes by a rule."""

from collections.abc import Iterator
from itertools import pairwise
from typing import NamedTuple, TypeAlias

from vrts.base.pose import Pose
from vrts.engine.machine.machine import Machine
from vrts.engine.memory.records import INSTANT, Lie, Placement
from vrts.prove.certify.memory import Grips, Span, next_support, place_at
from vrts.prove.certify.situation import DIGITS, Lying, Part, What, parts_of
from vrts.prove.certify.stretches import Stretch
from vrts.scene.model import Mobility, Scene

MOST = 20_000  # situations that are known by the very objects that they are made of

Parts: TypeAlias = tuple[Part, ...]
_Numbered: TypeAlias = tuple[int, Parts, Parts]


class Situation(NamedTuple):
    """What has to be certified while bodies are where they are."""

    number: int
    parts: Parts
    in_hand: Parts  # more, in which only the fingers move
    hopes: bool  # what touches may be excused by what happens later
    falls_from_s: float | None  # when what falls began to, in run time
    keep: tuple[Placement, ...]  # lest their ids come again


class Situations:
    """Finds situations, each once."""

    def __init__(self, scene: Scene) -> None:
        """Know none."""
        self._rests_on = {body.name: body.rests_on for body in scene.bodies}
        self._fixed = frozenset(
            body.name for body in scene.bodies if body.mobility is not Mobility.MOVABLE
        )
        self._fingers = len(scene.robot.gripper.fingers)
        self._known: dict[object, Situation] = {}
        self._numbers: dict[tuple[Parts, Parts], _Numbered] = {}

    def between(
        self, machine: Machine, did: Grips, span: Span
    ) -> Iterator[tuple[Situation, float, float]]:
        """Yield what a machine is in from when to when, between two times [s]."""
        for from_s, to_s in pairwise(_cuts(machine, did, span)):
            yield self._at(machine, did, 0.5 * (from_s + to_s)), from_s, to_s

    def of(self, situation: Situation, stretch: Stretch) -> tuple[int, Parts]:
        """Return a situation's number and parts, with falls in `s` of a stretch."""
        if situation.falls_from_s is None:
            return situation.number, situation.parts
        parts = tuple([_in_s(part, stretch.zero_s) for part in situation.parts])
        return self._number(parts, situation.in_hand)[:2]

    def _at(self, machine: Machine, did: Grips, time_s: float) -> Situation:
        tracks = machine.system.hand.placements
        at = [place_at(track, time_s) for track in tracks.values()]
        lies = tuple([track[k] for track, k in zip(tracks.values(), at, strict=True)])
        closing = any(low <= time_s <= high for low, high in did.closings)
        held = [body for body, (low, high) in did.held if low <= time_s <= high]
        free = [one for one in did.letting_go if one.since_s <= time_s <= one.until_s]
        pressing = tuple([(one.body, one.finger) for one in free])
        key = (tuple(map(id, lies)), closing, tuple(held), pressing, did.stood_on)
        known = self._known.get(key)
        if known is None:
            none = tuple([False for _ in range(self._fingers)])
            pads = {body: tuple([True for _ in none]) for body in held}
            for body, finger in pressing:
                own = pads.get(body, none)
                pads[body] = (*own[:finger], True, *own[finger + 1 :])
            lying = tuple(
                self._lying(track, k, dict(did.stood_on))
                for track, k in zip(tracks.values(), at, strict=True)
            )
            if len(self._known) >= MOST:
                self._known.clear()
            known = self._known[key] = self._made(lies, lying, pads, closing=closing)
        return known

    def _lying(self, track: list[Placement], k: int, stood_on: dict[str, str | None]) -> Lying:
        placement = track[k]
        X = Pose(*(tuple([round(x, DIGITS) + 0.0 for x in part]) for part in placement.X))  # type: ignore[arg-type]
        match placement.lie:
            case Lie.HELD:
                before = track[k - 1].support if k else stood_on[placement.body]
                return Lying(placement.body, Lie.HELD, X, before)
            case Lie.FALLING:
                after, from_s = next_support(track[k + 1 :]), placement.start_s
                return Lying(placement.body, Lie.FALLING, X, None, after, from_s)
            case Lie.RESTING | Lie.TOPPLED:
                return Lying(placement.body, Lie.RESTING, X)

    def _made(
        self,
        lies: tuple[Placement, ...],
        lying: tuple[Lying, ...],
        pads: dict[str, tuple[bool, ...]],
        *,
        closing: bool,
    ) -> Situation:
        parts = parts_of(lying, pads, fixed=self._fixed, fingers=self._fingers, closing=closing)
        falls = [one.falls_from_s for one in lying if one.lie is Lie.FALLING]
        in_hand = tuple([part for part in parts if part.what is What.IN_HAND])
        parts = tuple([part for part in parts if part.what is not What.IN_HAND])
        number, parts, in_hand = self._number(parts, in_hand)
        hopes = any(part.hopes for part in parts)
        return Situation(number, parts, in_hand, hopes, min(falls, default=None), lies)

    def _number(self, parts: Parts, in_hand: Parts) -> _Numbered:
        """Return a number for parts, and these as they were at first: to be kept once."""
        new = (len(self._numbers), parts, in_hand)
        return self._numbers.setdefault((parts, in_hand), new)


def _cuts(machine: Machine, did: Grips, span: Span) -> list[float]:
    """Return the times between which nothing changes by a rule, and no stroke begins or ends."""
    hand = machine.system.hand
    times = [t for stroke in hand.strokes for t in (stroke.start_s, stroke.end_s)]
    times += [placement.start_s for track in hand.placements.values() for placement in track]
    times += [t for _, own in did.held for t in own]
    times += [t for own in did.closings for t in own]
    times += [t for one in did.letting_go for t in (one.since_s, one.until_s)]
    found = [span[0]]
    for time_s in sorted(times):
        if found[-1] + INSTANT < time_s < span[1] - INSTANT:
            found.append(time_s)
    return [*found, span[1]] if span[1] > span[0] + INSTANT else []


def _in_s(part: Part, zero_s: float) -> Part:
    """Return a part with falls that begin in `s` of a stretch."""

    def then(one: Lying | None) -> Lying | None:
        if one is None or one.lie is not Lie.FALLING:
            return one
        return one._replace(falls_from_s=round(one.falls_from_s - zero_s, DIGITS))

    return part._replace(body=then(part.body), other=then(part.other))
