"""The commands of a tick, obeyed after so many statements as they say."""

from vrts.engine.machine.machine import Machine
from vrts.engine.machine.obey import obey
from vrts.engine.memory.records import INSTANT
from vrts.engine.programs.cycles import rest


def is_due(machine: Machine) -> bool:
    """Return whether a command is to be obeyed before the next statement of this tick."""
    return machine.due_after is not None and machine.due_after <= machine.finished


def obey_due(machine: Machine, now: float) -> None:
    """Obey the commands that are due."""
    while machine.obeyed < len(machine.issued):
        time_s, command, after = machine.issued[machine.obeyed]
        if time_s > now + INSTANT:
            return
        if after is not None and after > machine.finished and time_s > now - machine.tick + INSTANT:
            return  # it comes within this tick
        machine.obeyed += 1
        machine.watcher.begin()
        machine.finished += 1  # so that before and after can be told apart
        obey(command, machine, now)
        for c in (machine.robot, machine.process):
            rest(c, machine.finished)
        machine.ticks.append(machine.last_tick)
        machine.counts.append(machine.finished)
