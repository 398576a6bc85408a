"""Whether the events of a saved run are ones that its execution could have told of."""

from collections.abc import Iterable
from itertools import pairwise

from vrts.engine.history import History
from vrts.engine.memory.event_log import EventLog
from vrts.engine.memory.event_order import spells, tracks_of
from vrts.engine.memory.events import (
    Event,
    HandCommanded,
    MotionEnded,
    MotionStarted,
    ProgramEnded,
    ProgramProgressed,
    ProgramStarted,
)
from vrts.engine.memory.records import Ending
from vrts.engine.storage.damage import require
from vrts.ir.instructions import HandAction

LONGEST_S = 1e6  # any time in a run


def check_events(history: History) -> None:
    """Check what events point at, and that programs begin before they go on and end.

    Raises:
        Damaged: It is not there, or they do not.
    """
    bodies = {body.name for body in history.scene.bodies}
    endings, actions = {e.value for e in Ending}, {a.value for a in HandAction}
    for event in history.events:
        require(0.0 <= event.time_s <= LONGEST_S, "an event has no time")
        match event:
            case MotionStarted(motion=motion) | MotionEnded(motion=motion):
                inside = 0 <= motion < len(history.arm.motions)
                require(inside, "an event is of a motion that is not there")
            case ProgramEnded(ending=ending):
                require(ending in endings, f"there is no ending `{ending}`")
            case HandCommanded(action=action):
                require(action in actions, f"there is no action `{action}` of the hand")
            case _:
                named_bodies = (getattr(event, "body", None), getattr(event, "support", None))
                also: tuple[str, ...] = getattr(event, "also", ())
                there = all(name is None or name in bodies for name in (*named_bodies, *also))
                require(there, "an event is about an object that is not there")
    _check_beginnings(history.events)


def _check_beginnings(events: EventLog) -> None:
    """Check that a program's cycles are told of from its beginning on."""
    numbered = [*zip(events, events.numbers, strict=True), (None, 0)]
    for (event, number), (following, next_number) in pairwise(numbered):
        if isinstance(event, ProgramStarted):
            told = (
                isinstance(following, ProgramProgressed)
                and following.time_s == event.time_s
                and (following.program, following.process) == (event.program, event.process)
                and next_number == number
            )
            require(told, "a program begins without a cycle")
    in_order = [one.event for one in events.in_order.dated]
    for is_robot in (True, False):
        first = _first_of(in_order, spells(is_robot=is_robot))
        require(not isinstance(first, ProgramEnded), "a program ends that never began")


def _first_of(events: Iterable[Event], track: object) -> Event | None:
    return next((event for event in events if track in tracks_of(event)), None)
