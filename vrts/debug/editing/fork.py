"""A run with other programs: forked before the first step that differs, the past before it kept."""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from vrts.debug.editing.aligned import Changes, Spans, aligned, changes
from vrts.debug.editing.moved import NoPlace, Programs, moved
from vrts.debug.editing.retelling import Retelling
from vrts.debug.passages import Instant, Passages, instant_of
from vrts.engine.code.executable import Executable
from vrts.engine.controller import AFTERWARDS, advance, commands_of, resumed, start
from vrts.engine.machine.forever.idle import idle
from vrts.engine.machine.machine import Machine
from vrts.engine.memory.events import Cause, SwitchChanged
from vrts.engine.run import Run
from vrts.ir.commands import (
    Answer,
    Execute,
    ForceSignals,
    MonitorSpeed,
    SetLocal,
    SetVariable,
    TimedCommand,
)
from vrts.ir.module import Module

_PLAIN = (Answer, ForceSignals, MonitorSpeed, SetLocal, SetVariable)  # speak of no step
NEVER = 2**62


class Forked(NamedTuple):
    """A run with other programs."""

    run: Run
    differs: Instant | None  # the first step that does in the old run; None: none was executed
    again_s: float  # from when it was executed again [s]
    forgotten: tuple[TimedCommand, ...]  # what was done by hand later than the first difference


def edited(run: Run, module: Module, entry: str) -> Forked:
    """Return a run as it would have been with other programs.

    What was done by hand before the first step that differs is done again, what came later is not.

    Args:
        run: A run that can go on.
        module: The other programs and their data.
        entry: The program to execute.
    """
    given = _scripted(run)
    by_hand = [command for command in run.history.issued if command not in given]
    found = _found(run, module, entry, by_hand)
    kept = [command for command in by_hand if _finished(run, command) < found.first]
    forgotten = tuple(command for command in by_hand if command not in kept)
    commands = commands_of(run.scenario, entry)
    until_s = commands[-1].time_s + run.scenario.limits.time_s + AFTERWARDS
    until_s = max([until_s, *(command.time_s + AFTERWARDS for command in kept)])
    differs = None if found.first == NEVER else instant_of(run, min(found.first, run.statements))
    shared = _shared(run, module, found)
    if not shared:
        begun = start(module, run.scene, run.scenario)
        issued = sorted((*commands, *kept), key=lambda command: command.order)
        other = advance(begun, until_s, issued, closed=True)
        return Forked(other, differs, 0.0, forgotten)
    machine = shared[-1]
    machine.know((*commands, *kept))
    return Forked(resumed(shared, until_s), differs, machine.now, forgotten)


class _Found(NamedTuple):
    """What two modules have in common, as far as a run tells."""

    first: int  # statements finished when the first difference comes next
    safe: int  # states with no more statements finished may be taken over
    numbers: Sequence[int]
    changes: Changes
    retelling: Retelling


def _found(run: Run, module: Module, entry: str, by_hand: Sequence[TimedCommand]) -> _Found:
    old = run.checkpoints[0].executable
    programs = old.programs
    changed = changes(old.module, module)
    spans: Spans = {d.span: e.span for d, e in zip(old.module.data, module.data, strict=False)}
    causes: dict[Cause, Cause] = {}
    numbers = np.full(len(programs.causes), -1, np.int64)
    differ = np.ones(len(programs.causes), bool)
    base = 0
    bases: dict[str, int] = {}
    for program in module.programs.values():
        bases[program.name] = base
        base += len(program.origins)
    for known in programs.loaded:
        name = known.program.name
        if name in changed.programs:
            continue
        other = module.programs[name]
        found = aligned(known.program, other, changed, spans)
        for at, to in found.places.items():
            step, span = other.origins[to]
            causes.setdefault(known.causes[at], Cause(name, step, span))
            numbers[known.base + at] = bases[name] + to
            differ[known.base + at] = at in found.differ
    first = min(_first(run, differ, process=False), _first(run, differ, process=True))
    first = min([first, *(_finished(run, c) for c in by_hand if _leads_elsewhere(c, changed))])
    if run.history.issued[:1] != (TimedCommand(0.0, Execute(entry)),):
        first = 0
    safe = first - 1 if first < NEVER else NEVER
    if not changed.is_same and run.history.process.trace.changed:
        safe = min(safe, run.history.process.trace.changed[0] - 1)  # it may be judged otherwise
    if _tells_steps(run) and any(a[:2] != b[:2] for a, b in causes.items()):
        safe = -1
    return _Found(first, safe, numbers.tolist(), changed, Retelling(spans, causes))


def _first(run: Run, differ: NDArray[np.bool_], *, process: bool) -> int:
    """Return how many statements were finished when a program came to what differs."""
    history = run.history.process if process else run.history.robot
    trace, passages = history.trace, Passages(run, process=process)
    where = passages.instructions
    bad = np.flatnonzero((where >= len(differ)) | differ[np.minimum(where, len(differ) - 1)])
    found = NEVER
    if len(bad):
        k = int(bad[0])
        found = int(passages.before[k - 1]) + 1 if k else int(trace.changed[0])
    for finished, at in zip(trace.rested, trace.resting, strict=True):
        if finished > run.statements or finished >= found:
            break
        if at >= len(differ) or differ[at]:
            return int(finished)
    return found


def _scripted(run: Run) -> tuple[TimedCommand, ...]:
    """Return what the scenario gives, not somebody at the debugger."""
    issued = run.history.issued
    first = issued[0].command if issued else None
    return tuple(commands_of(run.scenario, first.program)) if isinstance(first, Execute) else ()


def _finished(run: Run, command: TimedCommand) -> int:
    """Return how many statements were finished when a command came."""
    after = command.after
    return after if after is not None else run.history.finished_at(command.time_s)


def _leads_elsewhere(command: TimedCommand, changed: Changes) -> bool:
    """Return whether a command may do something else with other programs."""
    return not isinstance(command.command, _PLAIN) and not changed.is_same


def _tells_steps(run: Run) -> bool:
    """Return whether numbers of steps are written: the switch TRACE."""
    return any(isinstance(event, SwitchChanged) and event.switch == "TRACE" for event in run.events)


def _shared(run: Run, module: Module, found: _Found) -> list[Machine]:
    """Return the states of a run up to the first difference, with the other programs."""
    known = [m for m in run.checkpoints if m.finished <= found.safe and m.next_tick > 0]
    if not known:
        return []
    before = known[-1].executable
    names = list(before.programs.numbers)
    executable = Executable(module, before.call_depth)
    if list(executable.programs.numbers)[: len(names)] != names or not _as_idle(before, executable):
        return []
    begun = start(module, run.scene, run.scenario).machine
    programs = Programs(executable, found.numbers, found.changes.data, found.retelling)
    try:
        return [begun, *(moved(machine, programs) for machine in known)]
    except NoPlace:
        return []


def _as_idle(before: Executable, after: Executable) -> bool:
    """Return whether no variable decides nothing any more that decided something before."""
    names = {before.layout.names[k] for k in idle(before)}
    return {after.layout.names[k] for k in idle(after)} <= {
        name for name in after.layout.names if name in names or name not in before.layout.numbers
    }
