"""Loops that repeat their state: what happened once from here on happens for ever.

Brent's method: a state is kept, and compared with later ones until a power of two of ticks has
passed; then a later one is kept. A loop that reads a clock or random numbers, or that an input
still to change may end, is never called endless.
"""

from vrts.base.diagnostic import Diagnostic, Label, Rule, Severity
from vrts.engine.machine.machine import Machine
from vrts.engine.machine.schedule import signals_to_come
from vrts.engine.machine.watcher import Arm, Kept
from vrts.engine.memory.cells import Cell, Content
from vrts.engine.memory.records import Lie, Placement
from vrts.engine.programs.context import Context
from vrts.engine.programs.cycles import place

ENDLESS = Rule("V503", "endless-loop")

MOST_LOOKED_AT = 5000  # statements that are gone through for the steps of a loop


def look(machine: Machine, now: float) -> Diagnostic | None:
    """Return a diagnostic when the robot program repeats its state; ask after every tick run."""
    watcher = machine.watcher
    if signals_to_come(machine):
        watcher.kept, watcher.left = None, watcher.power
        return None
    kept = watcher.kept
    if kept is not None and _may_repeat(machine, kept):
        if _state(machine, now)[:6] == kept[:6]:
            return _endless(machine, kept, now)
        watcher.witness = _difference(machine, kept)
    watcher.left -= 1
    if watcher.left <= 0:
        watcher.power *= 2
        watcher.left = watcher.power
        watcher.kept, watcher.witness = _state(machine, now), None
    return None


def _may_repeat(machine: Machine, kept: Kept) -> bool:
    """Return whether a quick look finds no difference to a state that was kept."""
    witness = machine.watcher.witness
    return (
        kept.clock_reads == machine.system.clock_reads
        and kept.finished < machine.finished
        and kept.places == (_place(machine.robot), _place(machine.process))
        and (witness is None or witness[0].value == witness[1])
    )


def _difference(machine: Machine, kept: Kept) -> tuple[Cell, Content] | None:
    """Return a variable that has changed, most likely not for the last time, and what it was."""
    for cell, value in zip(machine.system.memory.cells(), kept.values, strict=False):
        if cell.value != value:
            return cell, value
    return None


def _place(c: Context) -> tuple[object, ...]:
    return (c.ending, c.phase, c.priority, tuple((f.program, f.index, f.kind) for f in c.frames))


def _state(machine: Machine, now: float) -> Kept:
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


def _arm(machine: Machine, now: float) -> Arm:
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


def _endless(machine: Machine, kept: Kept, now: float) -> Diagnostic:
    cause = place(machine.robot)
    assert cause is not None
    lines = _steps_between(machine, kept.finished, machine.finished)
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


def _steps_between(machine: Machine, first: int, last: int) -> str:
    """Return which steps the robot program executed between two counts of statements."""
    trace, causes = machine.robot.trace, machine.system.programs.causes
    begin, stop = trace.executed(first), trace.executed(last)
    steps = sorted({causes[k].step for k in trace.instructions[begin:stop][-MOST_LOOKED_AT:]})
    return f"{steps[0]} to {steps[-1]}" if len(steps) > 1 else str(steps[0])
