"""How a program goes on within a tick: statements, single steps, reactions, errors."""

import math
from typing import TYPE_CHECKING

from vrts.engine.code.closures import BLOCKED, CYCLE_ENDED, HALTED, PAUSED, SWITCHED
from vrts.engine.code.steps.terminal_steps import put
from vrts.engine.faults import LimitReached, RuntimeFault
from vrts.engine.machine.limits import check_limits
from vrts.engine.memory.events import Cause, Reacted
from vrts.engine.memory.records import INSTANT, Ending
from vrts.engine.programs.context import Context
from vrts.engine.programs.cycles import next_cycle, note_progress, place, rest
from vrts.engine.programs.frames import FrameKind
from vrts.engine.programs.watches import ERROR_PRIORITY, Watch

if TYPE_CHECKING:
    from vrts.engine.machine.machine import Machine

STEPS_A_TICK = 100  # of each program [assumed, manual language/processes#share]


def execute(machine: "Machine", c: Context, now: float) -> None:
    """Let a program react, and go on for its share of a tick."""
    try:
        if c.finishing:
            _finish(machine, c)
        else:
            _react(machine, c, look=True)
            if c.wake == math.inf or c.wake <= now + INSTANT:
                c.wake = now
                _run_steps(machine, c, STEPS_A_TICK)
        check_limits(machine, c)
    except LimitReached as limit:
        machine.end(c, Ending.LIMIT, limit.diagnostic)


def _run_steps(machine: "Machine", c: Context, most: int) -> None:
    """Execute statements until the program waits, ends, or has used its share of the tick."""
    left = most
    while left > 0 and c.running:
        due = machine.due_after
        share = left if due is None else min(left, max(due - machine.finished, 0))
        if share == 0:
            machine.obey(c.now)
            continue
        before = machine.finished
        try:
            unused = _run_frame(machine, c, share)
            if unused or machine.finished - before >= share:  # else it waits, or has ended
                left += unused - share
            else:
                left = 0
        except RuntimeFault as fault:
            left -= 1
            _catch(machine, c, fault)
        if left > 0 and c.running:
            _react(machine, c, look=False)
    rest(c, machine.finished)


def _run_frame(machine: "Machine", c: Context, left: int) -> int:
    """Execute statements without a look at anything else; return how many more may follow."""
    frame, trace, finished = c.frames[-1], c.trace, machine.finished
    program = machine.system.programs.loaded[frame.program]
    steps, base, index = machine.executable.steps[frame.program], program.base, frame.index
    note = trace.instructions.append
    trace.begin_slice(finished)
    if c.steps_left is not None:
        left = 1
    traced = machine.system.tracing
    try:
        while left > 0:
            if traced and index < len(steps) - 1:  # the last one is the end of the program
                _list_step(c, program.causes[index], finished)
            finished += 1
            c.finished = finished
            note(base + index)
            left -= 1
            outcome = steps[index](c)
            if outcome >= 0:
                index = outcome
            elif outcome == SWITCHED:
                frame = c.frames[-1]
                program = machine.system.programs.loaded[frame.program]
                steps, base = machine.executable.steps[frame.program], program.base
                index = frame.index
                traced = machine.system.tracing
                if c.reactions_wait:
                    break  # one may be taken now
            elif outcome == BLOCKED:
                trace.instructions.pop()
                finished -= 1
                c.finished = finished
                c.system.events.not_finished(finished)
                frame.index = index
                return 0
            else:
                machine.finished = finished
                return _left(machine, c, outcome, left)
        frame.index = index
    except RuntimeFault:
        frame.index = index
        raise
    finally:
        machine.finished = finished
    return _stepped(machine, c, program.causes[index]) if c.steps_left is not None else left


def _left(machine: "Machine", c: Context, outcome: int, left: int) -> int:
    """Go on after a statement that ended the cycle or the program."""
    if outcome == CYCLE_ENDED:
        if next_cycle(c):
            return left if c.steps_left is None else _stepped(machine, c, None)
        _finish(machine, c)
    elif outcome == HALTED:
        machine.end(c, Ending.HALTED, None)
        c.clear()
    else:
        assert outcome == PAUSED
        machine.end(c, Ending.PAUSED, None)
    return 0


def _finish(machine: "Machine", c: Context) -> None:
    """End a program that has done its last step, once the arm stands still."""
    settled = machine.system.planner.settled_at
    if c.is_robot and not c.at_once and settled > c.now + INSTANT:
        c.finishing, c.wake, c.watches = True, settled, []
    else:
        machine.end(c, Ending.COMPLETED, None)


def _stepped(machine: "Machine", c: Context, following: Cause | None) -> int:
    """Count a single step when another one comes next; return how many more may follow."""
    assert c.steps_left is not None
    count, depth = c.steps_left
    last = machine.system.programs.causes[c.trace.instructions[-1]]
    if (depth is not None and len(c.frames) > depth) or last == following:
        return 1
    if count > 1:
        c.steps_left = (count - 1, depth)
        return 1
    machine.end(c, Ending.STEPPED, None)
    return 0


def _list_step(c: Context, cause: Cause, finished: int) -> None:
    """Write the step that is executed next, as TRACE asks; one that waits only once."""
    if c.listed == (cause, finished):
        return
    c.listed = (cause, finished)
    put(c, f"{cause.program} {cause.step:5d}.  {cause.span.text}\r\n", cause)


def _react(machine: "Machine", c: Context, *, look: bool) -> None:
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


def _take(machine: "Machine", c: Context, watch: Watch) -> None:
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


def _note_interruption(machine: "Machine", c: Context) -> None:
    """Count being interrupted as a statement, so that before and after can be told apart."""
    frame = c.frames[-1]
    program = machine.system.programs.loaded[frame.program]
    c.trace.begin_slice(machine.finished)
    c.trace.instructions.append(program.base + min(frame.index, len(program.causes) - 1))
    machine.finished += 1
    c.finished = machine.finished


def _catch(machine: "Machine", c: Context, fault: RuntimeFault) -> None:
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


def fail(machine: "Machine", c: Context, fault: RuntimeFault) -> None:
    """End a program with a run-time error at the step that it is at."""
    cause = place(c)
    assert cause is not None
    machine.end(c, Ending.ERROR, fault.diagnostic(cause.span))
