"""The machine goes on, tick by tick.

Order within a tick: commands, faults of the scenario, signal inputs and sensors, the hand, then
reactions, the steps of the robot program that the controller model gives it, as many of the process
control program; a scenario may let that one go first. Motion needs no work of its own, because it
is planned as polynomials when it is issued. Ticks in which nothing can happen are skipped.
"""

import math

from vrts.engine.machine.due import is_due, obey_due
from vrts.engine.machine.ending import end
from vrts.engine.machine.execution import execute
from vrts.engine.machine.forever.findings import not_judged
from vrts.engine.machine.forever.judge import judge, stopped, waits_in_vain
from vrts.engine.machine.machine import Machine, MidTick, in_turn
from vrts.engine.machine.noting import note_motions
from vrts.engine.machine.schedule import at_rest_s, future_s, has_work, is_idle
from vrts.engine.machine.surroundings import bring_faults_about, process_is_first, sample
from vrts.engine.memory.records import INSTANT, Ending
from vrts.engine.programs.cycles import place


def run_until(machine: Machine, until_s: float, *, stop_when_idle: bool = False) -> None:
    """Run every tick up to a time [s], or until nothing executes and nothing moves."""
    machine.write()
    last = math.floor(until_s / machine.tick + INSTANT / machine.tick)
    while machine.next_tick <= last and has_work(machine):
        if stop_when_idle and is_idle(machine) and waits_in_vain(machine):
            break
        _run_tick(machine, machine.next_tick)
    settle(machine, until_s)


def settle(machine: Machine, until_s: float) -> None:
    """Note what needs no tick: grasps, and motions that begin and end."""
    machine.system.hand.settle_until(until_s, machine.system.events)
    note_motions(machine, until_s)


def _run_tick(machine: Machine, tick: int) -> None:
    begin_tick(machine, tick)
    go_on(machine)
    progress, stirred = end_tick(machine)
    if progress:
        machine.ticks.append(tick)
        machine.counts.append(machine.finished)
    _look_for_loops(machine, machine.robot.now)
    skip_ahead(machine, progress=progress, stirred=stirred)


def skip_ahead(machine: Machine, *, progress: bool, stirred: bool) -> None:
    """Choose the next tick that has to be run.

    Args:
        machine: The machine, at the end of a tick.
        progress: Statements were finished in it.
        stirred: Signals turned in it.
    """
    now = machine.robot.now
    if machine.running:
        _plan_next(machine, now, progress=progress, stirred=stirred)
    else:
        following = future_s(machine)
        _skip_to(machine, following if following is not None else now)


def begin_tick(machine: Machine, tick: int) -> None:
    """Let happen what happens at a tick before the programs go on."""
    now = tick * machine.tick
    machine.last_tick, machine.next_tick = tick, tick + 1
    system = machine.system
    machine.robot.now = machine.process.now = now
    note_motions(machine, now)
    obey_due(machine, now)
    bring_faults_about(machine, now)
    sample(machine, now)
    system.hand.settle_until(now, system.events)
    first = process_is_first(machine, now)
    machine.mid = MidTick(machine.finished, system.signals.changes, process_first=first)


def go_on(machine: Machine) -> None:
    """Let the programs have what is left of their turns in the tick under way.

    Raises:
        Undecided: A statement looks at something that is not decided; the machine is as it was
            before that statement.
    """
    mid = machine.mid
    assert mid is not None
    now = machine.robot.now
    _turns(machine, mid, now)
    while is_due(machine):  # what a debugger does at the end of the tick
        obey_due(machine, now)
        mid.again()
        _turns(machine, mid, now)


def end_tick(machine: Machine) -> tuple[bool, bool]:
    """End the tick under way; return whether statements were finished, and signals turned."""
    mid, machine.mid = machine.mid, None
    assert mid is not None
    return machine.finished != mid.finished, machine.system.signals.changes != mid.changes


def _turns(machine: Machine, mid: MidTick, now: float) -> None:
    programs = in_turn(machine)
    while mid.turn < len(programs):
        c = programs[mid.turn]
        if c.running:
            execute(machine, c, now, mid)
        mid.turn, mid.steps = mid.turn + 1, None


def _plan_next(machine: Machine, now: float, *, progress: bool, stirred: bool) -> None:
    programs = [c for c in (machine.robot, machine.process) if c.running]
    if any(c.wake <= now for c in programs):
        return  # some program goes on at the next tick
    if progress and any(c.wake == math.inf for c in programs):
        return  # what one program has changed another may wait for
    if stirred and any(c.watches for c in programs):
        return
    waking = min(c.wake for c in programs)
    if machine.closed and waking < math.inf:  # the limit is noticed when it is reached
        latest = min(c.started_s for c in programs) + machine.scenario.limits.time_s
        waking = min(waking, latest + machine.tick)
    following = future_s(machine)
    if following is not None and following < waking:
        waking = following
    if waking < math.inf:
        _skip_to(machine, waking)
    elif machine.closed and machine.robot.running:
        rests_s = at_rest_s(machine)
        if rests_s > now + INSTANT:
            _skip_to(machine, rests_s)  # the motion under way goes on to its end, wait or no wait
            return
        finding = stopped(machine, now)
        _tell_when_not_judged(machine)
        end(machine, machine.robot, Ending.LIMIT, finding)


def _skip_to(machine: Machine, time_s: float) -> None:
    machine.next_tick = max(machine.next_tick, machine.tick_of(time_s))


def _look_for_loops(machine: Machine, now: float) -> None:
    if not machine.robot.running:
        return
    finding = judge(machine, now)
    if finding is not None:
        end(machine, machine.robot, Ending.LIMIT, finding)
    else:
        _tell_when_not_judged(machine)


def _tell_when_not_judged(machine: Machine) -> None:
    """Tell once, where it matters, that the judgement itself has failed."""
    watcher = machine.watcher
    if watcher.broken and machine.closed and not watcher.told:
        watcher.told = True
        machine.robot.report(not_judged(machine), place(machine.robot))
