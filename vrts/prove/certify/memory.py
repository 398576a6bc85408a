"""What the rules of contacts remember of the past, and what a tick adds to it.

Which body pads may press into depends on grasps and releases: from the command that closes the
hand on it until each finger has come free of it, which is looked for every 14 ms from the release.
What a body in the hand stood on is lowered against it.
"""

from collections.abc import Iterable, Sequence
from typing import NamedTuple, TypeAlias

from vrts.check.collision.pairs.grips import FINE
from vrts.engine.machine.machine import Machine
from vrts.engine.machine.states.nearly import DIGITS
from vrts.engine.memory.events import Event, Grasped, HandCommanded, Released
from vrts.engine.memory.records import INSTANT, Lie, Placement
from vrts.ir.instructions import HandAction
from vrts.prove.certify.touching import Hope, Outcome

Span: TypeAlias = tuple[float, float]
StoodOn: TypeAlias = tuple[tuple[str, str | None], ...]
"""What bodies in the hand stood on before, by their names."""
OF_HAND = (HandCommanded, Grasped, Released)


class LettingGo(NamedTuple):
    """A finger that has not yet come free of a body that was let go."""

    body: str
    finger: int
    since_s: float  # run time of the release
    until_s: float = float("inf")  # when it has come free, or the body is grasped again


class Memory(NamedTuple):
    """What is remembered of a future between two ticks. A value: futures may share it."""

    seen_s: float = 0.0  # its motion was noted up to here [s]
    closing: bool = False  # the hand was, then
    held: str | None = None  # what was grasped
    stood_on: StoodOn = ()
    letting_go: tuple[LettingGo, ...] = ()
    coming: tuple[Event, ...] = ()  # a hand may be told before what it does with the next motion
    outcomes: tuple[Outcome, ...] = ()  # since the last tick

    def state(self, machine: Machine) -> tuple[object, ...]:
        """Return what decides about contacts to come and is no part of the machine's state.

        Within a tick that is what the hand did in it so far, too.
        """
        events = machine.system.events
        if not (self.letting_go or self.coming or len(events)):
            return (self.stood_on, (), ())
        now = machine.now
        letting_go = [
            (one.body, one.finger, round((now - one.since_s) % FINE, DIGITS) % FINE)
            for one in self.letting_go
        ]
        new = [one for one in events if isinstance(one, OF_HAND)]
        coming = [_from_now(one, now) for one in (*self.coming, *new)]
        return (self.stood_on, tuple(letting_go), tuple(coming))


def _from_now(event: Event, now: float) -> tuple[object, ...]:
    what = event.action if isinstance(event, HandCommanded) else getattr(event, "body", None)
    return (type(event).__name__, round(event.time_s - now, DIGITS), what)


class Grips(NamedTuple):
    """What the hand did between two times."""

    held: tuple[tuple[str, Span], ...]  # grasped bodies, from when to when
    closings: tuple[Span, ...]
    letting_go: tuple[LettingGo, ...]
    stood_on: StoodOn  # at the beginning
    outcomes: tuple[Outcome, ...]
    closing: bool  # at the end
    holds: str | None
    coming: tuple[Event, ...]


def grips(memory: Memory, machine: Machine, events: Iterable[Event], span: Span) -> Grips:
    """Return what the hand did between two times.

    Args:
        memory: What was so at the beginning.
        machine: The machine.
        events: What has happened that is not remembered.
        span: From when to when [s].
    """
    of_hand = [event for event in events if isinstance(event, OF_HAND)]
    all_ = [*memory.coming, *of_hand]
    coming = tuple([event for event in all_ if event.time_s > span[1] + INSTANT])
    hand = _Hand(machine, memory, span[0])
    for event in all_:
        if event.time_s <= span[1] + INSTANT:
            hand.take(event)
    closing = hand.closes_s is not None and (
        machine.system.hand.closing is not None or bool(coming)
    )
    return hand.until(span[1], closing=closing)._replace(coming=coming)


class _Hand:
    """Follows a hand."""

    def __init__(self, machine: Machine, memory: Memory, from_s: float) -> None:
        self.machine, self.memory = machine, memory
        self.holds, self.since_s = memory.held, from_s
        self.closes_s = from_s if memory.closing else None
        self.held: list[tuple[str, Span]] = []
        self.closings: list[Span] = []
        self.letting_go: list[LettingGo] = list(memory.letting_go)
        self.outcomes: list[Outcome] = []

    def take(self, event: Event) -> None:
        """Go on with an event."""
        match event:
            case HandCommanded(time_s=time_s, action=action):
                self.closed(time_s, None)
                if action == HandAction.CLOSE.value and self.holds is None:
                    self.closes_s = time_s
            case Grasped(time_s=time_s, body=body):
                self.closed(time_s, body)
                self.holds, self.since_s = body, time_s
                self.letting_go = [_taken_again(one, body, time_s) for one in self.letting_go]
            case Released(time_s=time_s, body=body):
                self.held.append((body, (self.since_s, time_s)))
                self.holds = None
                fingers = range(len(self.machine.system.hand.gripper.fingers))
                self.letting_go += [LettingGo(body, finger, time_s) for finger in fingers]
                self.outcomes += _set_down(self.machine, time_s)
            case _:
                pass

    def closed(self, time_s: float, body: str | None) -> None:
        """End a closing under way."""
        if self.closes_s is not None:
            self.closings.append((self.closes_s, time_s))
            self.outcomes.append(Outcome(time_s, Hope.GRASPED, body))
        self.closes_s = None

    def until(self, end_s: float, *, closing: bool) -> Grips:
        """Return what the hand did."""
        if closing and self.closes_s is not None:
            self.closings.append((self.closes_s, end_s))
        else:
            self.closed(end_s, None)
        if self.holds is not None:
            self.held.append((self.holds, (self.since_s, end_s)))
        return Grips(
            *(tuple(self.held), tuple(self.closings), tuple(self.letting_go)),
            *(self.memory.stood_on, tuple(self.outcomes), closing, self.holds, ()),
        )


def _taken_again(one: LettingGo, body: str, time_s: float) -> LettingGo:
    if one.body != body:
        return one
    return one._replace(until_s=min(one.until_s, time_s))


def _set_down(machine: Machine, time_s: float) -> list[Outcome]:
    """Return what bodies that left the hand at a time come to stand on."""
    found: list[Outcome] = []
    for name, track in machine.system.hand.placements.items():
        for k, placement in enumerate(track):
            if placement.lie is Lie.HELD and abs(placement.end_s - time_s) < INSTANT:
                on = next_support(track[k + 1 :])
                found.append(Outcome(time_s, Hope.SET_DOWN, name, on))
    return found


def next_support(later: Sequence[Placement]) -> str | None:
    """Return what a body will stand on next; None: nothing, as far as it is known."""
    return next((one.support for one in later if one.lie is not Lie.FALLING), None)


def stood_on(memory: Memory, machine: Machine, time_s: float) -> StoodOn:
    """Return what bodies that are in the hand at a time stood on before."""
    known = dict(memory.stood_on)
    found: list[tuple[str, str | None]] = []
    for name, track in machine.system.hand.placements.items():
        k = place_at(track, time_s)
        if track[k].lie is Lie.HELD:
            found.append((name, track[k - 1].support if k else known[name]))
    return tuple(found)


def place_at(track: Sequence[Placement], time_s: float) -> int:
    """Return which of the places of a body it has at a time: the last that has begun."""
    k = len(track) - 1
    while k and track[k].start_s > time_s:
        k -= 1
    return k
