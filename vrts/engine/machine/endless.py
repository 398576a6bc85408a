"""Loops that repeat their state: what happened once from here on happens for ever.

Brent's method: a state is kept, and compared with later ones until a power of two of ticks has
passed; then a later one is kept. A loop that reads a clock or random numbers, or that an input
still to change may end, is never called endless.
"""

from typing import TYPE_CHECKING, NamedTuple

from vrts.base.diagnostic import Diagnostic, Label, Rule, Severity
from vrts.engine.memory.cells import Cell, Content
from vrts.engine.memory.records import Lie, Placement
from vrts.engine.programs.cycles import place
from vrts.robots.model import Configuration

if TYPE_CHECKING:
    from vrts.engine.machine.machine import Machine
    from vrts.engine.programs.context import Context

ENDLESS = Rule("V503", "endless-loop")

FIRST_LOOK = 20  # ticks that are executed before a state is kept


class Arm(NamedTuple):
    """Where the arm is on its way, apart from when."""

    since_start: int  # ticks since the motion under way began; -1 at rest
    start: Configuration
    goal: Configuration
    pending: Configuration | None
    opening: float


class Kept(NamedTuple):
    """The state of a machine, apart from the time."""

    places: tuple[object, ...]  # cheap to compare: where the programs are
    arm: Arm
    values: tuple[Content, ...]
    signals: frozenset[int]
    switches: tuple[tuple[str, bool], ...]
    objects: tuple[object, ...]
    clock_reads: int
    time_s: float
    finished: int


class Watcher:
    """Looks at the state of a machine after each tick that was run."""

    __slots__ = ("_kept", "_left", "_power", "_witness")

    def __init__(self) -> None:
        """Start with nothing kept."""
        self._kept: Kept | None = None
        self._power = FIRST_LOOK
        self._left = FIRST_LOOK
        self._witness: tuple[Cell, Content] | None = None  # a cell, and its value that is kept

    def copy(self) -> "Watcher":
        """Return an independent copy."""
        other = Watcher()
        other._kept, other._power, other._left = self._kept, self._power, self._left
        return other

    def look(self, machine: "Machine", now: float) -> Diagnostic | None:
        """Return a diagnostic when the robot program repeats its state."""
        if machine.signals_to_come():
            self._kept, self._left = None, self._power
            return None
        kept = self._kept
        if kept is not None and self._may_repeat(machine, kept):
            if _state(machine, now)[:6] == kept[:6]:
                return _endless(machine, kept, now)
            self._witness = _difference(machine, kept)
        self._left -= 1
        if self._left <= 0:
            self._power *= 2
            self._left = self._power
            self._kept, self._witness = _state(machine, now), None
        return None

    def _may_repeat(self, machine: "Machine", kept: Kept) -> bool:
        """Return whether a quick look finds no difference to a state that was kept."""
        return (
            kept.clock_reads == machine.system.clock_reads
            and kept.finished < machine.finished
            and kept.places == (_place(machine.robot), _place(machine.process))
            and (self._witness is None or self._witness[0].value == self._witness[1])
        )


def _difference(machine: "Machine", kept: Kept) -> tuple[Cell, Content] | None:
    """Return a variable that has changed, most likely not for the last time, and what it was."""
    for cell, value in zip(machine.system.memory.cells(), kept.values, strict=False):
        if cell.value != value:
            return cell, value
    return None


def _place(c: "Context") -> tuple[object, ...]:
    return (c.ending, c.phase, c.priority, tuple((f.program, f.index, f.kind) for f in c.frames))


def _state(machine: "Machine", now: float) -> Kept:
    system, robot, process = machine.system, machine.robot, machine.process
    planner = system.planner
    values: list[Content] = [cell.value for cell in system.memory.cells()]
    for c in (robot, process):
        for frame in c.frames:
            values += [getattr(slot, "value", None) for slot in frame.slots]  # type: ignore[misc]
            values += [*frame.limits, *frame.increments, *frame.cases]  # type: ignore[list-item]
            values.append(tuple((w.signal, w.on, w.pending, w.state) for w in c.watches))  # type: ignore[arg-type]
        values.append(c.last_error.number if c.last_error is not None else None)  # type: ignore[arg-type]
    values += [cell.value for cell in system.cells()]
    values.append((planner.branch, planner.request, planner.always, tuple(planner.next)))  # type: ignore[arg-type]
    values.append((planner.tool, planner.base, planner.scale.rate, system.answers_read))  # type: ignore[arg-type]
    return Kept(
        (_place(robot), _place(process)),
        _arm(machine, now),
        tuple(values),
        frozenset(system.signals.on),
        tuple(sorted(system.switches.items())),
        tuple(_where(track[-1]) for track in system.hand.placements.values()),
        system.clock_reads,
        now,
        machine.finished,
    )


def _arm(machine: "Machine", now: float) -> Arm:
    planner, hand = machine.system.planner, machine.system.hand
    opening = hand.opening(now)
    if not planner.under_way(now):
        q = planner.configuration
        return Arm(-1, q, q, None, opening)
    if not planner.motions:
        return Arm(-2, planner.configuration, planner.configuration, None, opening)
    pending = planner.motions[-1].goal if planner.pending is not None else None
    motion = planner.motions[-2 if pending is not None else -1]
    begun = round((planner.scale.path(now) - motion.start_s) / machine.tick)
    return Arm(begun, motion.start, motion.goal, pending, opening)


def _where(placement: Placement) -> object:
    if placement.lie is Lie.FALLING:
        return (placement.lie, placement.start_s)
    return (placement.lie, placement.X, placement.support)


def _endless(machine: "Machine", kept: Kept, now: float) -> Diagnostic:
    cause = place(machine.robot)
    assert cause is not None
    lines = machine.steps_between(kept.finished, machine.finished)
    period = now - kept.time_s
    return Diagnostic(
        ENDLESS,
        Severity.ERROR,
        "this loop never ends: it repeats its state",
        Label(cause.span, "reached again and again"),
        notes=(
            (
                f"from {kept.time_s:.3f} s to {now:.3f} s steps {lines} were executed,"
                f" and everything is as it was {period:.3f} s before"
            ),
        ),
        help=("change something in the loop that its condition depends on",),
        data={"period_s": round(period, 3), "since_s": round(kept.time_s, 3)},
    )
