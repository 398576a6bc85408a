"""Reads `[[inputs]]`, `[[sensors]]` and `[[faults]]` of a scenario: what comes from outside.

An input is changed at given times or by one sensor, never by both: what it is at any time can be
told from one place of the file.
"""

from difflib import get_close_matches
from itertools import pairwise
from typing import NamedTuple, cast

from vrts.base.diagnostic import Label, Rule
from vrts.base.pose import Vector
from vrts.base.source import Span
from vrts.base.toml.kinds import UNKNOWN_CHOICE
from vrts.base.toml.reading import Problems, Table
from vrts.base.units import MM
from vrts.scene.model import FaultKind, Mobility, PlannedFault, Region, Scene, Sensor
from vrts.scene.sensors import TOOL

DRIVEN_TWICE = Rule("V474", "signal-driven-twice")
INPUT_CHANGES = Rule("V475", "input-changes")
FLAT_REGION = Rule("V476", "flat-region")
BLIND_SENSOR = Rule("V477", "blind-sensor")
TOO_MANY = Rule("V480", "too-many-entries")

TWICE = {  # what two entries for one input do, and what to do instead
    "signal": ("change input", "give all its times in one `[[inputs]]`, or leave it to one sensor"),
    "channel": ("are about analog input", "say all that it reads in one `[[analog]]`"),
}
FIRST_INPUT, LAST_INPUT = 1001, 1032  # [assumed, manual language/signals#ranges]
LATEST_S = 7200.0  # any time in a scenario [s]
FARTHEST_MM = 10_000.0  # any corner of a region
MOST_CHANGES = 10_000  # of all inputs together
MOST_ENTRIES = 1_000  # of `[[inputs]]`, of `[[sensors]]`, and of `[[faults]]`


class Inputs(NamedTuple):
    """What drives the inputs of a run."""

    changes: tuple[tuple[float, int, bool], ...]  # (time [s], signal number, state), by time
    sensors: tuple[Sensor, ...]


class _Change(NamedTuple):
    time_s: float
    on: bool
    span: Span


def read_inputs(top: Table, scene: Scene) -> Inputs:
    """Return the changes of inputs and the sensors of a scenario."""
    problems = top.problems
    driven: dict[int, Span] = {}
    changes: list[tuple[float, int, bool]] = []
    for table in _entries(top, "inputs"):
        signal, own = _input(table)
        if signal is not None and driven_once(table, "signal", signal, driven):
            changes += [(change.time_s, signal, change.on) for change in own]
    check_count(problems, len(changes), MOST_CHANGES, "changes of inputs", top.span_of("inputs"))
    sensors: list[Sensor] = []
    for table in _entries(top, "sensors"):
        signal, sensor = _sensor(table, scene)
        if (
            signal is not None
            and driven_once(table, "signal", signal, driven)
            and sensor is not None
        ):
            sensors.append(sensor)
    return Inputs(tuple(sorted(changes)), tuple(sensors))


def read_faults(top: Table) -> tuple[PlannedFault, ...]:
    """Return the faults that a scenario brings about, by time."""
    found = [fault for fault in map(_fault, _entries(top, "faults")) if fault is not None]
    return tuple(sorted(found, key=lambda fault: fault.time_s))


def check_count(problems: Problems, count: int, most: int, what: str, span: Span) -> bool:
    """Return whether a scenario may have so many of something; report it if not."""
    if count > most:
        problems.error(
            TOO_MANY,
            f"{count:,} {what} are too many",
            span,
            f"a scenario may have {most:,}",
            data={"count": count, "most": most},
        )
    return count <= most


def _entries(top: Table, key: str) -> tuple[Table, ...]:
    """Return the tables `[[key]]`; of too many none is read, so that a fault costs little."""
    tables = top.tables(key)
    few = check_count(top.problems, len(tables), MOST_ENTRIES, key, top.span_of(key))
    return tables if few else ()


def _signal(table: Table, *, required: bool = True) -> int | None:
    return table.integer("signal", minimum=FIRST_INPUT, maximum=LAST_INPUT, required=required)


def driven_once(table: Table, key: str, number: int, driven: dict[int, Span]) -> bool:
    """Return whether a table is the first about an input; report it if not.

    Args:
        table: The table.
        key: Under which it names its input: one of `TWICE`.
        number: Of the input.
        driven: Where those before it name theirs; this one is added.
    """
    span = table.value_span(key)
    if number not in driven:
        driven[number] = span
        return True
    said, what_to_do = TWICE[key]
    table.problems.error(
        DRIVEN_TWICE,
        f"two entries {said} {number}",
        span,
        secondary=(Label(driven[number], "the other one"),),
        help=(what_to_do,),
        data={key: number},
    )
    return False


# --- inputs over time -----------------------------------------------------------------------------


def _input(table: Table) -> tuple[int | None, tuple[_Change, ...]]:
    errors_before = len(table.problems.found)
    signal = _signal(table)
    changes = tuple(
        sorted((*_changes(table, "on_s", on=True), *_changes(table, "off_s", on=False)), key=_time)
    )
    table.finish()
    if len(table.problems.found) > errors_before:
        return signal, changes
    if not changes:
        table.problems.error(
            INPUT_CHANGES,
            f"nothing says when input {signal} changes",
            table.span,
            help=("add `on_s = [2.0]`, the times in s at which it turns on, or `off_s`",),
        )
    _check_changes(table.problems, f"input {signal}", changes)
    return signal, changes


def _changes(table: Table, key: str, *, on: bool) -> tuple[_Change, ...]:
    times = table.numbers(key, (), minimum=0.0, maximum=LATEST_S) or ()
    return tuple(
        _Change(time_s, on, table.element_span(key, index)) for index, time_s in enumerate(times)
    )


def _time(change: _Change) -> float:
    return change.time_s


def _check_changes(problems: Problems, name: str, changes: tuple[_Change, ...]) -> None:
    """Report two changes at one time, and the first change into the state that there is."""
    for before, after in pairwise(changes):
        if before.time_s == after.time_s:
            problems.error(
                INPUT_CHANGES,
                f"{name} changes twice at {after.time_s:g} s",
                after.span,
                secondary=(Label(before.span, "the first time"),),
                help=("leave out one of the two",),
            )
            return
    on = False
    for change in changes:
        if change.on is on:
            state = "on" if on else "off"
            problems.warning(
                INPUT_CHANGES,
                f"{name} is {state} already at {change.time_s:g} s",
                change.span,
                "so nothing changes here",
                notes=() if on else ("an input is off when a run starts",),
            )
            return
        on = change.on


# --- sensors --------------------------------------------------------------------------------------


def _sensor(table: Table, scene: Scene) -> tuple[int | None, Sensor | None]:
    signal = _signal(table)
    region = read_region(table)
    seen = _seen(table, scene)
    inverted = table.boolean("inverted", default=False)
    table.finish()
    if signal is None or region is None or seen is None:
        return signal, None
    return signal, Sensor(signal, region, seen, inverted)


def read_region(table: Table) -> Region | None:
    """Return the box between two opposite corners, whichever they are."""
    section = table.table("region_mm", required=True)
    if section is None:
        return None
    ends = [
        section.numbers(key, count=3, minimum=-FARTHEST_MM, maximum=FARTHEST_MM, required=True)
        for key in ("from", "to")
    ]
    section.finish()
    if ends[0] is None or ends[1] is None:
        return None
    sides = tuple(zip(*ends, strict=True))
    for axis, (a, b) in zip("xyz", sides, strict=True):
        if a == b:
            section.problems.error(
                FLAT_REGION,
                f"the region has no extent along {axis}",
                section.span,
                f"both corners have {axis} = {a:g} mm",
                help=(f"let `from` and `to` differ in {axis}",),
                data={"axis": axis},
            )
            return None
    lower = cast("Vector", tuple(min(side) * MM for side in sides))
    upper = cast("Vector", tuple(max(side) * MM for side in sides))
    return Region(lower, upper)


def _seen(table: Table, scene: Scene) -> tuple[str, ...] | None:
    movable = tuple(body.name for body in scene.bodies if body.mobility is Mobility.MOVABLE)
    known = (*movable, TOOL)
    names = table.strings("sees", ()) or ()
    for index, name in enumerate(names):
        if name not in known:
            close = get_close_matches(name, known, 1, 0.6)
            table.problems.error(
                UNKNOWN_CHOICE,
                f"a sensor cannot see `{name}`",
                table.element_span("sees", index),
                notes=(f"it can see what can be carried, and the tool: {_listed(known)}",),
                help=(f"did you mean `{close[0]}`?",) if close else (),
                data={"key": "sees", "value": name},
            )
            return None
    if not names and not movable:
        table.problems.warning(
            BLIND_SENSOR,
            "the sensor can see nothing",
            table.span,
            notes=("the scene holds no object that can be carried",),
            help=(f'write sees = ["{TOOL}"], or choose another scene',),
        )
    return tuple(dict.fromkeys(names))  # each once: the engine asks for them at every tick


def _listed(names: tuple[str, ...]) -> str:
    return ", ".join(f"`{name}`" for name in names)


# --- faults ---------------------------------------------------------------------------------------


def _fault(table: Table) -> PlannedFault | None:
    time_s = table.number("time_s", minimum=0.0, maximum=LATEST_S, required=True)
    word = table.string("kind", choices=[kind.value for kind in FaultKind], required=True)
    stuck = word == FaultKind.INPUT_STUCK.value
    signal, state = None, None
    if stuck or word is None:  # of an unknown kind nothing is said
        signal = _signal(table, required=stuck)
        state = table.string("state", choices=("on", "off"), required=stuck)
    table.finish()
    if time_s is None or word is None or (stuck and (signal is None or state is None)):
        return None
    return PlannedFault(time_s, FaultKind(word), signal or 0, state == "on")
