"""What there is to see at an instant, as names with values, some of which open."""

from collections.abc import Iterator, Mapping
from typing import NamedTuple

from vrts.base.oat import components
from vrts.base.pose import IDENTITY, Pose
from vrts.base.units import deg, mm
from vrts.debug.debugger import Debugger
from vrts.debug.frames import Frame
from vrts.engine.code.values.formats import free
from vrts.engine.memory.events import SignalChanged
from vrts.engine.memory.records import Placement
from vrts.engine.run import Run, State
from vrts.ir.values import Value
from vrts.monitor.listings import name_order, value_text

_POSE = ("X", "Y", "Z", "O", "A", "T")
FEW = 8  # elements of an array that are shown without opening it


class Shown(NamedTuple):
    """A name with its value."""

    name: str
    value: str
    parts: tuple["Shown", ...] = ()  # when it is opened
    variable: str = ""  # what may be given another value; empty: nothing may


class Scope(NamedTuple):
    """A group of names."""

    name: str
    shown: tuple[Shown, ...]
    frame: Frame | None = None  # whose arguments and automatic variables they are


def scopes(debugger: Debugger, frame: Frame | None) -> tuple[Scope, ...]:
    """Return everything that can be seen at the present instant from a program."""
    state = debugger.state
    own: Mapping[str, Value] = {} if frame is None else frame.locals(debugger.run, debugger.at)
    named = state.variables
    places = {n: v for n, v in named.items() if isinstance(v, tuple)}
    others = {n: v for n, v in named.items() if not isinstance(v, tuple)}
    return (
        Scope("Arguments and AUTO", tuple(variables(own)), frame),
        Scope("Variables", tuple(variables(others))),
        Scope("Locations", tuple(variables(places))),
        Scope("Arm", tuple(_arm(state))),
        Scope("Hand and objects", tuple(_objects(state))),
        Scope("Signals", tuple(_signals(debugger.run, state))),
        Scope("Time", tuple(_time(debugger))),
    )


def variables(values: Mapping[str, Value]) -> Iterator[Shown]:
    """Return variables by name; the elements of a large array below its name."""
    arrays: dict[str, list[str]] = {}
    for name in sorted(values, key=name_order):
        arrays.setdefault(name.partition("[")[0], []).append(name)
    for base, names in arrays.items():
        found = tuple(variable(name, values[name]) for name in names)
        if len(found) > FEW:
            yield Shown(f"{base}[]", f"{len(found):,} elements", found)
        else:
            yield from found


def variable(name: str, value: Value) -> Shown:
    """Return a variable with its value; the parts of a location below it."""
    if isinstance(value, Pose):
        return pose(name, value, name)
    if isinstance(value, tuple):
        parts = tuple(Shown(f"JT{k}", f"{deg(q):.3f}") for k, q in enumerate(value, start=1))
        return Shown(name, _short([deg(q) for q in value]), parts, name)
    return Shown(name, value_text(value), (), name)


def pose(name: str, value: Pose, variable: str = "") -> Shown:
    """Return a pose with its components [mm, degrees]."""
    numbers = components(value)
    parts = tuple(
        Shown(letter, f"{number:.3f}") for letter, number in zip(_POSE, numbers, strict=True)
    )
    return Shown(name, _short(numbers), parts, variable)


def _arm(state: State) -> Iterator[Shown]:
    for k, (q, rate) in enumerate(zip(state.configuration, state.velocity, strict=True), start=1):
        yield Shown(f"JT{k}", f"{deg(q):.3f}", (Shown("speed", f"{deg(rate):.2f} deg/s"),))
    yield pose("HERE", state.base @ state.X_WT)
    yield pose("TOOL", state.X_FT)
    if state.base != IDENTITY:
        yield pose("BASE", state.base)
    yield Shown("speed", f"{state.program_speed:g} %, the operator's {state.monitor_speed:g} %")


def _objects(state: State) -> Iterator[Shown]:
    yield Shown("opening", f"{mm(state.hand_opening):.2f} mm")
    yield Shown("holds", state.held or "nothing")
    poses = state.poses
    for name, placement in state.placements.items():
        yield pose(name, poses[name])._replace(value=_lie(placement))


def _lie(placement: Placement) -> str:
    on = f" on {placement.support}" if placement.support else ""
    return f"{placement.lie.value}{on}"


def _signals(run: Run, state: State) -> Iterator[Shown]:
    on = state.signals
    yield Shown("on", ", ".join(map(str, sorted(on))) or "none")
    for number in sorted({e.signal for e in run.events if isinstance(e, SignalChanged)}):
        yield Shown(f"SIG({number})", "on" if number in on else "off")
    for name, is_on in sorted(state.switches.items()):
        yield Shown(name, "ON" if is_on else "OFF")
    for channel, value in sorted(state.analog.items()):
        yield Shown(f"analog output {channel}", free(value))


def _time(debugger: Debugger) -> Iterator[Shown]:
    run = debugger.run
    yield Shown("time", f"{debugger.at.time_s:.3f} s of {run.horizon_s:.3f} s")
    yield Shown("statements", f"{debugger.at.finished:,} of {run.statements:,}")
    motion = debugger.state.cause
    if motion is not None and run.motions:
        yield Shown("under way", f"line {motion.span.line}: {motion.span.text}")


def _short(numbers: Iterator[float] | list[float] | tuple[float, ...]) -> str:
    return "  ".join(f"{round(number, 2) + 0.0:g}" for number in numbers)
