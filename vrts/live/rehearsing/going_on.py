"""A text compiled and run as it would run now, in the state of a room's session."""

import base64
import binascii
import math
from dataclasses import replace
from typing import Final

from msgspec import structs

from vrts.base.diagnostic import Diagnostic
from vrts.base.source import SourceFile
from vrts.debug.passages import Instant
from vrts.engine.controller import AFTERWARDS, advance
from vrts.engine.machine.machine import Machine
from vrts.engine.memory.records import INSTANT
from vrts.engine.run import Run
from vrts.ir.commands import Execute, Load, Panic, TimedCommand
from vrts.ir.module import Module
from vrts.lang.compiler import Compilation
from vrts.lang.dialect import DIALECTS
from vrts.lang.reading.decoding import decode
from vrts.live.rehearsing.asked import Begin
from vrts.live.rehearsing.running import Outcome, narrower
from vrts.live.session.looking.state import StateLost, machine_of, state_of, stored
from vrts.live.session.setting import scene_sha256, setting_of
from vrts.monitor.programs import in_view
from vrts.pipeline.compiling.reading import ProgramFile
from vrts.pipeline.execution import entry_in
from vrts.pipeline.request import Request
from vrts.pipeline.setting import scenario_of
from vrts.scene.model import Limits

STOPPED: Final = "arm and programs of the room are stopped in it where they were"
SETTLES_S: Final = 10.0  # longer than any arm takes to stop [s]


def run_from_now(begin: Begin) -> Outcome:
    """Compile a text with what a session knows, and run it in its state.

    What moves there is stopped first, as PANIC would, in the rehearsal alone.

    Raises:
        CannotRead: A file of the scene or task is not there.
        Refused: A file of them has errors.
        StateLost: The state is none of this scene.
    """
    where, order = begin.where, begin.order
    dialect = DIALECTS[where.dialect]
    try:
        state = state_of(base64.b64decode(begin.state, validate=True))
    except binascii.Error as problem:
        raise StateLost from problem
    setting = setting_of(structs.replace(where, controller=state.controller))
    if scene_sha256(setting) != state.scene_sha256:
        raise StateLost
    task = setting.task
    source = decode(order.text.encode("utf-8", "replace"), order.name)
    if isinstance(source, Diagnostic):
        return Outcome(None, None, (source,), dialect, task)
    scenario = scenario_of(setting)
    machine = machine_of(state, setting.scene, scenario)
    run = Run(machine, state.time_s, (machine,))
    found = in_view(
        source,
        tuple(source.text.split("\n")),
        stored(state, machine),
        run.at(state.time_s).variables,
        dialect,
    )
    own = _own(found, source)
    if own is None:
        return Outcome(source, None, found.diagnostics, dialect, task)
    request = Request(ProgramFile(b"", order.name), setting)
    entry, said = entry_in(own, request)
    diagnostics = (*found.diagnostics, *said)
    if entry is None:
        return Outcome(source, None, diagnostics, dialect, task)
    limits = narrower(scenario.limits)
    run = _stopped(run, busy=state.busy)
    machine = run.machine.copy()
    machine.scenario = replace(scenario, limits=_beyond(machine, limits))
    run = Run(machine, run.until_s, (machine,))
    at_s, finished = run.until_s, run.statements
    commands = [TimedCommand(at_s, Load(own)), TimedCommand(at_s, Execute(entry))]
    run = advance(run, at_s + limits.time_s + AFTERWARDS, commands, closed=True)
    return Outcome(
        source,
        run,
        diagnostics,
        dialect,
        task,
        None if task is None else task.near_miss,
        tuple(own.programs),
        Instant(at_s, finished),
        goes_on=True,
        note=STOPPED if state.busy else "",
    )


def _own(found: Compilation, source: SourceFile) -> Module | None:
    """Return the programs and data of a text, without what was only in view."""
    if found.module is None:
        return None
    programs = {n: p for n, p in found.module.programs.items() if p.span.source is source}
    data = tuple(datum for datum in found.module.data if datum.span.source is source)
    return Module(programs, data) if programs else None


def _stopped(run: Run, *, busy: bool) -> Run:
    """Return a run up to a tick at which nothing moves."""
    if busy:
        run = advance(run, run.until_s, [TimedCommand(run.until_s, Panic())])
        run = advance(run, run.until_s + 2.0 * run.history.tick_s)
        rests_s = min(run.machine.system.planner.settled_at, run.until_s + SETTLES_S)
        run = advance(run, max(rests_s, run.until_s))
    tick = run.history.tick_s
    return advance(run, math.ceil(run.until_s / tick - INSTANT / tick) * tick)


def _beyond(machine: Machine, limits: Limits) -> Limits:
    """Return limits that count from now on: the machine's own counts began with the session."""
    system = machine.system
    return replace(
        limits,
        statements=machine.finished + limits.statements,
        motions=len(system.planner.given.motions) + limits.motions,
        output_characters=system.terminal.characters + limits.output_characters,
    )
