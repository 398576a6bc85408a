"""The table of events: everything that a run tells, and its contacts and near misses, in order."""

from collections.abc import Callable, Mapping
from itertools import chain
from typing import Any, NamedTuple, TypeAlias

from vrts.base.units import mm
from vrts.check.verdict import ContactEvent, NearMiss, sides
from vrts.debug.alarms import Alarm, Alarms
from vrts.debug.events.columns import Column, Columns, Content
from vrts.debug.passages import Instant, executes, statements_at
from vrts.debug.stops.stop import Stop, Why
from vrts.engine.memory import events as told
from vrts.engine.memory.records import INSTANT
from vrts.engine.run import Run
from vrts.report.event_words import event_text
from vrts.report.plain import one_line

CONTACT, NEAR_MISS = "contact", "near-miss"
CHECKED = frozenset({CONTACT, NEAR_MISS})  # kinds that take a check of the whole run
_Met: TypeAlias = ContactEvent | NearMiss
_Of: TypeAlias = Callable[[Any], Content]


class Happening(NamedTuple):
    """A row: an event, beside how many statements were finished with it."""

    event: told.Event | _Met
    number: int
    alarm: Alarm | None = None  # of a contact or a near miss


def _on(event: told.SignalChanged | told.SwitchChanged) -> str:
    return "on" if event.on else "off"


_KINDS: Mapping[type, tuple[str, str | Callable[[Any], str]]] = {
    told.ProgramStarted: ("program", "started"),
    told.ProgramEnded: ("program", "ended"),
    told.ProgramProgressed: ("program", "progressed"),
    told.MotionStarted: ("motion", "started"),
    told.MotionEnded: ("motion", "ended"),
    told.HandCommanded: ("hand", lambda e: e.action),
    told.Grasped: ("grasp", "grasped"),
    told.MissedOffCentre: ("fault", "missed"),
    told.Released: ("grasp", "released"),
    told.Landed: ("grasp", "landed"),
    told.Toppled: ("fault", "toppled"),
    told.SignalChanged: ("signal", _on),
    told.Printed: ("output", "printed"),
    told.SwitchChanged: ("program", _on),
    told.AnalogChanged: ("signal", "set"),
    told.Prompted: ("output", "asked"),
    told.Answered: ("output", "answered"),
    told.Reacted: ("signal", "reacted"),
    told.SpeedChanged: ("program", "speed"),
    told.CommandRefused: ("fault", "refused"),
    ContactEvent: (CONTACT, "began"),
    NearMiss: (NEAR_MISS, "began"),
}
KINDS = (*dict.fromkeys(kind for kind, _ in _KINDS.values()), "note")


def _kind(row: Happening) -> str:
    event = row.event
    if isinstance(event, told.Found):
        return "fault" if event.diagnostic.is_error else "note"
    return _KINDS[event.__class__][0]


def _what(row: Happening) -> str:
    event = row.event
    if isinstance(event, told.Found):
        return event.diagnostic.rule.slug
    what = _KINDS[event.__class__][1]
    return what if isinstance(what, str) else what(event)


def time_of(row: Happening) -> float:
    """Return when it happened [s]; a contact when it began."""
    event = row.event
    return event.start_s if isinstance(event, ContactEvent | NearMiss) else event.time_s


def _bodies(row: Happening) -> Content:
    event = row.event
    if isinstance(event, ContactEvent | NearMiss):
        return tuple(dict.fromkeys((*sides(event), *event.parts)))
    also: tuple[str, ...] = getattr(event, "also", ())
    names = (getattr(event, "body", None), getattr(event, "support", None), *also)
    return tuple(name for name in names if name is not None) or None


def _attribute(name: str, of: type | tuple[type, ...], turned: _Of = lambda v: v) -> _Of:
    def found(row: Happening) -> Content:
        event = row.event
        return turned(getattr(event, name)) if isinstance(event, of) else None

    return found


def _value(row: Happening) -> Content:
    match row.event:
        case told.SignalChanged(on=on) | told.SwitchChanged(on=on):
            return float(on)
        case told.AnalogChanged(value=value):
            return value
        case told.SpeedChanged(percent=percent):
            return percent
        case _:
            return None


def _of_cause(get: Callable[[Any], Content]) -> _Of:
    def found(row: Happening) -> Content:
        cause = row.event.cause
        return None if cause is None else get(cause)

    return found


def text_of(row: Happening) -> str:
    """Return what happened, in words."""
    event = row.event
    if row.alarm is not None:
        return row.alarm.text
    assert not isinstance(event, ContactEvent | NearMiss)
    words = event_text(event)
    if words is not None:
        return words[1]
    match event:
        case told.MotionEnded(cause=cause):
            return f"{one_line(cause.span.text)} is over"
        case told.ProgramProgressed(program=program, cycles_done=done, running=running):
            return f"program {program} {'goes on' if running else 'rests'}, {done} cycles done"
        case _:
            return "an empty line"


COLUMNS: Columns[Happening] = {
    "time": Column(
        "when it happened, or began; `here` is where you stand", time_of, "s", number=True
    ),
    "kind": Column("what sort of event", _kind, only=KINDS),
    "what": Column("more exactly: `grasped`, `on`, `ended`, the name of a fault", _what),
    "body": Column("things that it is about; of a contact both, with their parts", _bodies),
    "signal": Column(
        "number", _attribute("signal", (told.SignalChanged, told.Reacted)), number=True
    ),
    "value": Column("1 or 0 of what is on or off, counts, % of the speed", _value, number=True),
    "motion": Column(
        "number, from 0",
        _attribute("motion", (told.MotionStarted, told.MotionEnded)),
        number=True,
    ),
    "depth": Column(
        "how deep a contact gets", _attribute("depth_m", ContactEvent, mm), "mm", number=True
    ),
    "distance": Column(
        "how near a near miss gets", _attribute("distance_m", NearMiss, mm), "mm", number=True
    ),
    "height": Column(
        "how far a thing let go falls", _attribute("height_m", told.Released, mm), "mm", number=True
    ),
    "program": Column("whose step did it", _of_cause(lambda c: c.program)),
    "step": Column("its number", _of_cause(lambda c: c.step), number=True),
    "line": Column("of the file", _of_cause(lambda c: c.span.line), number=True),
    "text": Column("the words of the row", text_of),
}


def happened(run: Run, alarms: Alarms, *, checked: bool) -> list[Happening]:
    """Return every event of a run in order.

    Args:
        run: The run.
        alarms: Which know its contacts.
        checked: Whether contacts and near misses are among them: they take a check.
    """
    events = map(Happening, run.events, run.event_numbers)
    if not checked:
        return list(events)
    met = (Happening(event, a.instant.finished, a) for a, event in alarms.met())
    return sorted(chain(events, met), key=_order)


def stop_at(run: Run, row: Happening) -> Stop:
    """Return where to stand to see an event.

    What a step did at once is seen where this step comes next; anything else where it has just
    happened, and the step that led to it is the one to blame.
    """
    if row.alarm is not None:
        return Stop(row.alarm.instant, Why.ALARM, row.alarm.text, alarm=row.alarm)
    event = row.event
    assert not isinstance(event, ContactEvent | NearMiss)
    cause, number = event.cause, row.number
    text = text_of(row)
    if cause is not None and abs(run.history.time_of(number) - event.time_s) < INSTANT:
        for process in (False, True):
            done = executes(run, number, process=process)
            if done is not None and run.history.code.causes[done] == cause:
                return Stop(Instant(event.time_s, number - 1), Why.GO, text, process=process)
    least, most = statements_at(run, event.time_s)  # a motion that was planned before ends then
    instant = Instant(event.time_s, min(max(number, least), most))
    return Stop(instant, Why.GO, text, process=getattr(event, "process", False), by=cause)


def _order(row: Happening) -> tuple[float, int]:
    return time_of(row), row.number
