"""How a program goes on within a tick: statement by statement, or in single steps."""

import math

from vrts.engine.code.closures import BLOCKED, CYCLE_ENDED, HALTED, PAUSED, SWITCHED
from vrts.engine.code.steps.terminal_steps import put
from vrts.engine.faults import LimitReached, RuntimeFault
from vrts.engine.machine.due import obey_due
from vrts.engine.machine.ending import end
from vrts.engine.machine.limits import check_limits
from vrts.engine.machine.machine import Machine, MidTick
from vrts.engine.machine.reacting import catch, react
from vrts.engine.memory.events import Cause
from vrts.engine.memory.records import INSTANT, Ending
from vrts.engine.programs.context import Context
from vrts.engine.programs.cycles import next_cycle, note_blocked, rest, tell
from vrts.engine.programs.outside import Undecided


def execute(machine: Machine, c: Context, now: float, mid: MidTick) -> None:
    """Let a program react, and go on for its share of a tick [manual language/processes#share].

    Raises:
        Undecided: A statement looks at something that is not decided; it has not begun, and the
            rest of the share is left.
    """
    try:
        if c.finishing:
            _finish(machine, c)
        else:
            if mid.steps is None:
                react(machine, c, look=True)
                if c.wake == math.inf or c.wake <= now + INSTANT:
                    c.wake = now
                    mid.steps = machine.scene.controller.programs.steps_a_tick
            if mid.steps is not None:
                _run_steps(machine, c, mid, mid.steps)
        check_limits(machine, c)
    except LimitReached as limit:
        end(machine, c, Ending.LIMIT, limit.diagnostic)


def _run_steps(machine: Machine, c: Context, mid: MidTick, left: int) -> None:
    """Execute statements until the program waits, ends, or has used its share of the tick."""
    while left > 0 and c.running:
        due = machine.due_after
        share = left if due is None else min(left, max(due - machine.finished, 0))
        if share == 0:
            obey_due(machine, c.now)
            continue
        before = machine.finished
        try:
            unused = run_frame(machine, c, share)
            if unused or machine.finished - before >= share:  # else it waits, or has ended
                left += unused - share
            else:
                left = 0
        except RuntimeFault as fault:
            left -= 1
            catch(machine, c, fault)
        except Undecided:
            mid.steps = left - (machine.finished - before)
            raise
        if left > 0 and c.running:
            react(machine, c, look=False)
    rest(c, machine.finished)


def run_frame(machine: Machine, c: Context, left: int) -> int:
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
                if c.phase and (c.process.frames or not c.is_robot):  # else nobody can ask
                    note_blocked(c, c.now, finished)
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
    except Undecided:
        trace.instructions.pop()
        finished -= 1
        c.finished = finished
        frame.index = index
        raise
    finally:
        machine.finished = finished
    return _stepped(machine, c, program.causes[index]) if c.steps_left is not None else left


def _left(machine: Machine, c: Context, outcome: int, left: int) -> int:
    """Go on after a statement that ended the cycle or the program."""
    if outcome == CYCLE_ENDED:
        if next_cycle(c):
            return left if c.steps_left is None else _stepped(machine, c, None)
        _finish(machine, c)
    elif outcome == HALTED:
        end(machine, c, Ending.HALTED, None)
        c.clear()
        tell(c)
    else:
        assert outcome == PAUSED
        end(machine, c, Ending.PAUSED, None)
    return 0


def _finish(machine: Machine, c: Context) -> None:
    """End a program that has done its last step, once the arm stands still."""
    settled = machine.system.planner.settled_at
    if c.is_robot and not c.at_once and settled > c.now + INSTANT:
        c.finishing, c.wake, c.watches = True, settled, []
    else:
        end(machine, c, Ending.COMPLETED, None)


def _stepped(machine: Machine, c: Context, following: Cause | None) -> int:
    """Count a single step when another one comes next; return how many more may follow."""
    assert c.steps_left is not None
    count, depth = c.steps_left
    last = machine.system.programs.causes[c.trace.instructions[-1]]
    if (depth is not None and len(c.frames) > depth) or last == following:
        return 1
    if count > 1:
        c.steps_left = (count - 1, depth)
        return 1
    end(machine, c, Ending.STEPPED, None)
    return 0


def _list_step(c: Context, cause: Cause, finished: int) -> None:
    """Write the step that is executed next, as TRACE asks; one that waits only once."""
    if c.listed == (cause, finished):
        return
    c.listed = (cause, finished)
    put(c, f"{cause.program} {cause.step:5d}.  {cause.span.text}\r\n", cause)
