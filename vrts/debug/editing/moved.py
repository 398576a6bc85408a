"""A machine with other programs in memory, at the same place in them, telling of the new text."""

from array import array
from collections.abc import Sequence
from typing import NamedTuple, TypeVar

from vrts.debug.editing.retelling import Retelling
from vrts.debug.editing.watched import watch_on
from vrts.engine.code.executable import Executable
from vrts.engine.machine.machine import Lineage, Machine
from vrts.engine.memory.cells import Array, Bound, cells_of
from vrts.engine.memory.event_log import EventLog
from vrts.engine.memory.numbered import Numbered
from vrts.engine.memory.trace import Activation, Trace
from vrts.engine.programs.context import Context

Item = TypeVar("Item")


class NoPlace(Exception):  # noqa: N818 -- names the situation
    """A place of the old programs has none in the new ones."""


class Programs(NamedTuple):
    """New programs, and where the old ones are in them. Programs keep their numbers."""

    executable: Executable
    numbers: Sequence[int]  # of old instructions: that of the new one; -1: there is none
    data: frozenset[str]  # variables whose first values are others
    retelling: Retelling


def moved(machine: Machine, programs: Programs) -> Machine:
    """Return a machine that goes on with other programs.

    Args:
        machine: One in which nothing was executed or read that differs.
        programs: The programs.

    Raises:
        NoPlace: Something stands where the new programs have no place.
    """
    other = machine.copy()
    other.lineage, other.written = Lineage(), -1  # it parts from all others before it writes
    before, after, tell = machine.executable, programs.executable, programs.retelling
    _remember(other, before, programs)
    other.take_over(after)
    for c in (other.robot, other.process):
        _go_there(c, before, programs)
    planner, hand = other.system.planner, other.system.hand
    planner.given.motions = Numbered(
        [tell.of(motion) for motion in planner.given.motions], planner.given.motions.first
    )
    planner.pending = tell.of(planner.pending)
    hand.closing = tell.of(hand.closing)
    events = other.system.events
    other.system.events = EventLog.of([tell.of(event) for event in events], list(events.numbers))
    for c in (other.robot, other.process):
        c.events = other.system.events
    watch_on(other, before, after, tell, lambda number: _place(programs, number))
    other.wire()
    return other


def _remember(machine: Machine, before: Executable, programs: Programs) -> None:
    """Let memory be as the new programs number it."""
    memory, after = machine.system.memory, programs.executable
    fresh = after.memory().bound
    old = dict(zip(before.layout.names, memory.bound, strict=False))
    bound: list[Bound] = [
        mine
        if (mine := old.get(name)) is not None
        and name not in programs.data
        and isinstance(mine, Array) is isinstance(first, Array)
        else first
        for name, first in zip(after.layout.names, fresh, strict=False)
    ]
    for name, item in old.items():  # those that only the debugger speaks of
        if name not in after.layout.numbers and any(cell.since for cell in cells_of(item)):
            after.layout.number(name)
            if isinstance(item, Array):
                after.layout.arrays.add(name)
            bound.append(item)
    memory.bound = bound


def _go_there(c: Context, before: Executable, programs: Programs) -> None:
    tell, loaded = programs.retelling, programs.executable.programs.loaded
    for frame in c.frames:
        at = _place(programs, before.programs.loaded[frame.program].base + frame.index)
        frame.index = at - loaded[frame.program].base
        program = loaded[frame.program].program
        frame.limits = _sized(frame.limits, program.loops, None)
        frame.increments = _sized(frame.increments, program.loops, 0.0)
        frame.cases = _sized(frame.cases, program.cases, 0.0)
        frame.interrupted = tell.of(frame.interrupted)
    c.operands, c.fault, c.last_error = tell.of((c.operands, c.fault, c.last_error))
    c.next_hand, c.last_step, c.listed = tell.of((c.next_hand, c.last_step, c.listed))
    known: dict[int, Activation | None] = {}
    c.activation = _activation(c.activation, programs, {})
    c.trace = _trace(c.trace, c.events.counted(), programs, known)


def _sized(values: list[Item], size: int, empty: Item) -> list[Item]:
    return [*values[:size], *[empty] * (size - len(values))]


def _activation(
    old: Activation | None, programs: Programs, known: dict[int, Activation | None]
) -> Activation | None:
    if old is None:
        return None
    if id(old) not in known:
        called = None if old.called_from is None else _place(programs, old.called_from)
        caller = _activation(old.caller, programs, known)
        known[id(old)] = old._replace(called_from=called, caller=caller)
    return known[id(old)]


def _trace(
    old: Trace, finished: int, programs: Programs, known: dict[int, Activation | None]
) -> Trace:
    trace = old.copy()
    trace.cut(finished)
    trace.instructions = array("I", [_place(programs, k) for k in trace.instructions])
    trace.resting = array("I", [_place(programs, k) for k in trace.resting])
    trace.activations = [_activation(one, programs, known) for one in trace.activations]
    return trace


def _place(programs: Programs, number: int) -> int:
    found = programs.numbers[number] if number < len(programs.numbers) else -1
    if found < 0:
        raise NoPlace
    return found
