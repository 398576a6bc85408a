"""Programs that interrupt another one: reactions to signals, and the one that catches errors."""

from vrts.engine.faults import RuntimeFault
from vrts.engine.machine.ending import fail
from vrts.engine.machine.machine import Machine
from vrts.engine.memory.events import Reacted
from vrts.engine.programs.context import Context
from vrts.engine.programs.cycles import note_progress, place
from vrts.engine.programs.frames import FrameKind
from vrts.engine.programs.watches import ERROR_PRIORITY, Watch


def react(machine: Machine, c: Context, *, look: bool) -> None:
    """Take reactions that may be taken now, the strongest first."""
    if not c.watches:
        c.reactions_wait = False
        return
    if look:
        on = c.signals.on
        for watch in c.watches:
            watch.look(watch.signal in on)
    elif not c.reactions_wait:
        return
    planner = machine.system.planner
    while True:
        ready = [
            watch
            for watch in c.watches
            if watch.pending
            and watch.priority > c.priority
            and not (watch.after_motion and planner.under_way(c.now))
        ]
        if not ready:
            c.reactions_wait = any(watch.pending for watch in c.watches)
            return
        _take(machine, c, max(ready, key=lambda watch: watch.priority))


def _take(machine: Machine, c: Context, watch: Watch) -> None:
    watch.pending = False
    if not watch.always:
        c.watches = [w for w in c.watches if w is not watch]
    planner = machine.system.planner
    if watch.immediate:
        planner.brake(c.now)
        c.look_again()
    elif c.is_robot:
        planner.take_back(c.now)
    machine.system.hand.path_changed(c.now)
    name = ""
    if watch.program is not None:
        program = machine.system.programs.loaded[watch.program].program
        name = program.name
        _note_interruption(machine, c)
        frame = machine.system.programs.frame(watch.program)
        c.interrupt(frame, FrameKind.REACTION, watch.priority)
        note_progress(c)
    c.wake = c.now
    c.events.append(Reacted(c.now, watch.signal, name, place(c)))


def _note_interruption(machine: Machine, c: Context) -> None:
    """Count being interrupted as a statement, so that before and after can be told apart."""
    frame = c.frames[-1]
    program = machine.system.programs.loaded[frame.program]
    c.trace.begin_slice(machine.finished)
    c.trace.instructions.append(program.base + min(frame.index, len(program.causes) - 1))
    machine.finished += 1
    c.finished = machine.finished


def catch(machine: Machine, c: Context, fault: RuntimeFault) -> None:
    """Call the program that catches errors, or end the program."""
    c.last_error = fault
    caught = any(frame.kind is FrameKind.ERROR for frame in c.frames)
    if c.error_program is None or caught:
        fail(machine, c, fault)
        return
    cause = place(c)
    c.phase, c.operands, c.fault = 0, None, None
    _note_interruption(machine, c)
    frame = machine.system.programs.frame(c.error_program)
    c.interrupt(frame, FrameKind.ERROR, ERROR_PRIORITY)
    note_progress(c)
    name = machine.system.programs.loaded[c.error_program].program.name
    c.events.append(Reacted(c.now, 0, name, cause))
    c.wake = c.now
