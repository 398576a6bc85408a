"""When something may happen next, so that ticks in which nothing can are skipped."""

import math

from vrts.engine.machine.machine import Machine
from vrts.engine.memory.records import INSTANT


def changes_to_come(machine: Machine) -> bool:
    """Return whether inputs, faults, turns or commands may still change something from outside."""
    return (
        machine.system.signals.next_input_s is not None
        or machine.faults_done < len(machine.scenario.faults)
        or machine.turns_done < len(machine.scenario.process_first)
        or machine.next_command_s is not None
    )


def has_work(machine: Machine) -> bool:
    """Return whether anything is still to be done."""
    if machine.closed and not machine.robot.running and machine.next_command_s is None:
        return False
    return (
        machine.running or next_event_s(machine) is not None or machine.next_command_s is not None
    )


def is_idle(machine: Machine) -> bool:
    """Return whether nothing moves, and no program goes on before a command comes."""
    if machine.last_tick < 0 or machine.next_command_s is not None:
        return False
    if machine.robot.running and machine.robot.wake != math.inf:
        return False
    if machine.robot.running and future_s(machine) is not None:
        return False
    return machine.system.planner.settled_at <= machine.now + INSTANT


def at_rest_s(machine: Machine) -> float:
    """Return when arm and hand stand still if no program goes on [s]."""
    planner, hand = machine.system.planner, machine.system.hand
    strokes = [stroke.end_s for stroke in hand.strokes[-1:]]
    return max(planner.settled_at, planner.motion_end, *strokes)


def future_s(machine: Machine) -> float | None:
    """Return when something next happens that programs may notice; None when nothing will."""
    times = [t for t in (machine.next_command_s, next_event_s(machine)) if t is not None]
    return min(times, default=None)


def next_event_s(machine: Machine) -> float | None:
    """Return when an input, a sensor, the hand or a fault may change something next."""
    system = machine.system
    times = [system.signals.next_input_s, system.hand.next_s]
    if system.scheduled:
        times.append(system.scheduled[0][0])
    faults = machine.scenario.faults
    if machine.faults_done < len(faults):
        times.append(faults[machine.faults_done].time_s)
    turns = machine.scenario.process_first
    if machine.turns_done < len(turns):
        times.append(turns[machine.turns_done])
    times.append(machine.sensing.next_s(system, machine.now, machine.tick))
    known = [t for t in times if t is not None]
    return max(min(known), machine.now + machine.tick) if known else None
