"""What people do with parts between two executions: put them back, or take them away."""

from collections.abc import Iterator

from vrts.engine.hand.hand import GONE_M, EventLog, Hand
from vrts.engine.memory.events import Landed, Released
from vrts.engine.memory.records import Lie, Placement
from vrts.scene.model import Body, Mobility


def put_back(hand: Hand, time_s: float, events: EventLog) -> None:
    """Let every part stand where it stood at first; the hand holds nothing."""
    for body, last in _parts(hand):
        if (last.lie, last.X, last.support) == (Lie.RESTING, body.X_WO, body.rests_on):
            continue
        _let_go(hand, body.name, time_s, events)
        hand.place(body.name, time_s, Lie.RESTING, body.X_WO, body.rests_on)
        if body.rests_on is not None:
            events.append(Landed(time_s, body.name, body.rests_on, None))


def take_away(hand: Hand, time_s: float, events: EventLog) -> None:
    """Let every part be gone that does not stand on what it stood on at first."""
    for body, last in _parts(hand):
        stays = last.lie is Lie.RESTING and last.support == body.rests_on
        if stays or last.X.translation[2] <= GONE_M:
            continue
        _let_go(hand, body.name, time_s, events)
        hand.take(body.name, time_s)


def _parts(hand: Hand) -> Iterator[tuple[Body, Placement]]:
    for body in hand.scene.bodies:
        if body.mobility is Mobility.MOVABLE:
            yield body, hand.placements[body.name][-1]


def _let_go(hand: Hand, name: str, time_s: float, events: EventLog) -> None:
    if hand.held == name:
        hand.held = None
        events.append(Released(time_s, name, 0.0, None))
