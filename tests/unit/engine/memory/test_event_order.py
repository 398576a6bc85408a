"""Events in time order: whatever a log has grown by is taken once, and gives what sorting gives."""

import random

import pytest

from tests.unit.live.session.growing.test_growing_run import COMMANDS, SCENE
from vrts.base.source import SourceFile, Span
from vrts.engine.memory import event_order
from vrts.engine.memory.event_log import EventLog
from vrts.engine.memory.event_order import EventOrder
from vrts.engine.memory.events import (
    Cause,
    Event,
    MotionEnded,
    MotionStarted,
    Printed,
    ProgramEnded,
    ProgramStarted,
    SignalChanged,
)
from vrts.live.session.growing.growing_run import GrowingRun
from vrts.scene.model import Scenario

CAUSE = Cause("main", 1, Span(SourceFile("main", ""), 0, 0))


def happenings(count: int, seed: int) -> list[Event]:
    """Return events as a session has them: mostly in order, some ahead of their time."""
    draw = random.Random(seed)
    now = 0.0
    found: list[Event] = []
    for _ in range(count):
        now += draw.choice((0.0, 0.0, 0.028))
        ahead = now + draw.choice((0.0, 0.1, 1.0))
        process = draw.random() < 0.3
        number = draw.randrange(3)
        found.append(
            draw.choice(
                (
                    Printed(now, "text", None),
                    SignalChanged(now, 1, True, None),
                    MotionStarted(ahead, number, CAUSE),
                    MotionEnded(ahead, number, CAUSE),
                    ProgramEnded(ahead, "completed", None, process=process),
                    ProgramStarted(now, "main", process=process),
                )
            )
        )
    return found


def naive(events: list[Event], until_s: float) -> list[Event]:
    """Return what is to come out, worked out from all events at once."""
    kept: list[Event] = []
    for k, event in enumerate(events):
        begun = [
            e.time_s for e in events[k + 1 :] if isinstance(e, ProgramStarted) and not e.process
        ]
        of_robot = isinstance(event, ProgramStarted | ProgramEnded) and not event.process
        if event.time_s <= until_s and not (of_robot and begun and event.time_s > min(begun)):
            kept.append(event)
    return sorted(kept, key=instant)


def instant(event: Event) -> tuple[int, bool, int, bool]:
    """Return what orders an event: motions first, as they follow one another."""
    number = event.motion if isinstance(event, MotionStarted | MotionEnded) else -1
    return round(event.time_s * 1e9), number < 0, number, isinstance(event, MotionEnded)


@pytest.mark.parametrize("seed", range(20))
def test_a_log_that_grows_has_the_order_of_one_that_is_sorted(seed: int) -> None:
    events = happenings(120, seed)
    log, copies = EventLog(), list[EventLog]()
    for k, event in enumerate(events, 1):
        log.append(event)
        if k % 7 == 0:
            until_s = event.time_s + (k % 3) * 0.05
            found = [one.event for one in log.in_order.until(until_s)]
            assert found == naive(events[:k], until_s)
            for kind in (ProgramEnded, Printed):
                expected = [e for e in found if isinstance(e, kind)]
                assert log.in_order.track(kind, until_s) == expected
                assert log.in_order.last(kind, until_s) == (expected[-1] if expected else None)
            copies.append(log.copy())
    for copy in copies:  # of a time before: what came later is not among theirs
        found = [one.event for one in copy.in_order.until(1e9)]
        assert found == naive(events[: len(copy)], 1e9)


def test_a_motion_that_takes_no_time_begins_before_it_ends() -> None:
    log = EventLog()
    for k in (7, 8):
        log.append(Printed(1.0, str(k), None))
        log.append(MotionStarted(1.0, k, CAUSE))
        log.append(MotionEnded(1.0, k, CAUSE))
    log.append(MotionEnded(1.0, 6, CAUSE))
    ordered = [one.event for one in log.in_order.until(1.0)]
    kinds = [(type(e).__name__[6:], getattr(e, "motion", None)) for e in ordered]
    assert kinds == [
        ("Ended", 6),
        ("Started", 7),
        ("Ended", 7),
        ("Started", 8),
        ("Ended", 8),
        ("d", None),
        ("d", None),
    ]


def test_a_copy_that_goes_on_otherwise_has_an_order_of_its_own() -> None:
    log = EventLog()
    for event in happenings(50, 3):
        log.append(event)
    other = log.copy()
    log.append(Printed(100.0, "one", None))
    other.append(Printed(100.0, "other", None))
    assert [getattr(one.event, "text", "") for one in log.in_order.dated[-1:]] == ["one"]
    assert [getattr(one.event, "text", "") for one in other.in_order.dated[-1:]] == ["other"]


def test_what_was_looked_at_is_not_looked_at_again(monkeypatch: pytest.MonkeyPatch) -> None:
    taken = list[int]()
    take = EventOrder.take

    def counted(order: EventOrder, events: list[Event]) -> None:
        taken.append(len(events))
        take(order, events)

    monkeypatch.setattr(event_order.EventOrder, "take", counted)
    growing = GrowingRun(SCENE, Scenario())
    growing.issue(*(command for _, command in COMMANDS[:2]))
    for second in range(1, 61):
        growing.advance(float(second))
        state = growing.run.at(growing.time_s)
        assert state.robot is not None
        assert not state.awaits_answer
        assert len(state.signals) <= 1
    assert sum(taken) == len(growing.machine.system.events) > 100
